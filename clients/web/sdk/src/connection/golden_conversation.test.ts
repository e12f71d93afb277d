// The golden conversation (proto/WIRE.md): a real server's messages from Welcome to the twentieth snapshot.

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { fromBinary } from '@bufbuild/protobuf';
import { Connection } from './connection.js';
import { FakeSocket } from '../testing/fake_socket.js';
import { InputCode, ServerMessageSchema, type InputResult } from '../gen/jostle/v1/play_pb.js';

const golden = (name: string) => readFileSync(new URL(`../../../../../proto/golden/${name}`, import.meta.url));

interface Expected {
  welcome: { client_id: number; codec: number };
  snapshots: { frame: number; entities: number[][] }[];
  known_entities: number[];
  results: [number, string, number, number][];
}

/** The messages to the client, in order. */
function messages(): Uint8Array[] {
  const bytes = golden('conversation.jcnv');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 4;
  const u32 = () => view.getUint32((at += 4) - 4, true);
  expect(bytes.subarray(0, 4).toString()).toBe('JCNV');
  expect(u32()).toBe(1);
  const found: Uint8Array[] = [];
  for (let left = u32(); left > 0; left--) {
    const [direction] = [u32(), u32()];
    const size = u32();
    if (direction === 1) found.push(new Uint8Array(bytes.subarray(at, at + size)));
    at += size;
  }
  expect(at).toBe(bytes.length);
  return found;
}

describe('golden conversation', () => {
  it('leads to the states, entities and results of conversation.json', () => {
    const expected = JSON.parse(golden('conversation.json').toString()) as Expected;
    const socket = new FakeSocket();
    const nothing = () => {};
    const rejected: InputResult[] = [];
    const connection = new Connection({
      url: 'ws://test/play',
      listener: {
        state: nothing,
        entityList: nothing,
        stats: nothing,
        worldEvents: nothing,
        inputRejected: (result) => rejected.push(result),
        notice: (text) => expect.fail(text),
      },
      openSocket: () => socket,
    });
    connection.join('golden');
    socket.onopen?.();
    const frames: { frame: number; entities: number[][] }[] = [];
    for (const bytes of messages()) {
      socket.onmessage?.({ data: bytes.slice().buffer as ArrayBuffer });
      const { message } = fromBinary(ServerMessageSchema, bytes);
      if (message.case !== 'snapshot') continue;
      const decoded = connection.frames.find(message.value.frame);
      frames.push({
        frame: message.value.frame,
        entities: (decoded?.entities ?? []).map((e) => [e.id, ...e.position, e.largest, ...e.rotation, Number(e.atRest)]),
      });
    }
    expect(frames).toEqual(expected.snapshots.map(({ frame, entities }) => ({ frame, entities })));
    expect([...connection.entities.keys()].sort((a, b) => a - b)).toEqual(expected.known_entities);
    expect(rejected.map((r) => [r.sequence, `INPUT_CODE_${InputCode[r.code]}`, r.tick, r.entity])).toEqual(
      expected.results.filter(([, code]) => code !== 'INPUT_CODE_APPLIED'),
    );
    connection.stop();
  });
});
