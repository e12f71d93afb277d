// proto/golden/world_data.jdat (proto/WIRE.md): players, attributes and user messages.

import { readFileSync } from 'node:fs';
import { fromBinary } from '@bufbuild/protobuf';
import { expect, it } from 'vitest';
import { PlayerRole, SnapshotSchema, type UserMessage } from '../gen/jostle/v1/play_pb.js';
import { WorldData } from './world_data.js';

it('leads to the state that WIRE.md lists', () => {
  const bytes = readFileSync(new URL('../../../../../proto/golden/world_data.jdat', import.meta.url));
  expect(bytes.subarray(0, 4).toString()).toBe('JDAT');
  const data = new WorldData();
  const messages: UserMessage[] = [];
  let at = 12;
  for (let left = bytes.readUInt32LE(8); left > 0; left--) {
    const size = bytes.readUInt32LE(at);
    const snapshot = fromBinary(SnapshotSchema, bytes.subarray(at + 4, at + 4 + size));
    at += 4 + size;
    data.apply(snapshot);
    messages.push(...snapshot.messages);
  }
  expect(at).toBe(bytes.length);
  expect([...data.players.values()].map(({ client, name, role, color, pingMs }) => [client, name, role, color, pingMs])).toEqual([
    [3, 'Zoë', PlayerRole.BUILDER, undefined, 26],
    [4, 'rob', PlayerRole.OWNER, 0xff8000, 140],
  ]);
  expect(data.value({ kind: 'world' }, 'gravity')).toMatchObject({ x: 0, y: -9.81, z: 0 });
  expect(data.value({ kind: 'world' }, 'round')).toBe(3n);
  expect(Object.fromEntries([...data.attributesOf({ kind: 'player', id: 3 })].map(([key, { value }]) => [key, value.value]))).toEqual({ secret: 'open' });
  expect(data.attributesOf({ kind: 'player', id: 4 }).size + data.attributesOf({ kind: 'entity', id: 7 }).size).toBe(0);
  expect(messages.map(({ number, from, topic, data: body, direct }) => [number, from, topic, [...body], direct])).toEqual([
    [1, 4, 'chat', [104, 105], false],
    [3, 0, 'game.start', [0, 255], true],
  ]);
});
