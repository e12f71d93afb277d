import { create, type MessageInitShape } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { PlayerEventKind, PlayerRole, SnapshotSchema } from '../gen/jostle/v1/play_pb.js';
import { WorldData } from './world_data.js';

const apply = (data: WorldData, snapshot: MessageInitShape<typeof SnapshotSchema>) => data.apply(create(SnapshotSchema, snapshot));

describe('players', () => {
  it('follow the events after the complete list', () => {
    const data = new WorldData();
    apply(data, { players: [{ complete: true, players: [{ client: 1, name: 'ann' }, { client: 2, name: 'bob' }] }] });
    apply(data, { players: [{ pings: [{ client: 2, pingMs: 31 }, { client: 9, pingMs: 5 }] }] });
    apply(data, {
      players: [
        {
          events: [
            { tick: 9, kind: PlayerEventKind.LEFT, player: { client: 1, name: 'ann' } },
            { tick: 9, kind: PlayerEventKind.RENAMED, player: { client: 2, name: 'rob', role: PlayerRole.PLAYER } },
            { tick: 9, kind: PlayerEventKind.JOINED, player: { client: 3, name: 'cy' } },
          ],
        },
      ],
    });
    expect([...data.players.values()].map(({ client, name, pingMs }) => [client, name, pingMs])).toEqual([[2, 'rob', 31], [3, 'cy', 0]]);
  });
});

describe('attributes', () => {
  const entity = { kind: 'entity', id: 7 } as const;

  it('change by key and end with their target', () => {
    const data = new WorldData();
    apply(data, {
      attributes: [
        {
          complete: true,
          sets: [
            { target: { case: 'entity', value: 7 }, attributes: [{ key: 'hp', value: { case: 'integer', value: -3n } }, { key: 'label', value: { case: 'text', value: 'ü' } }] },
            { target: { case: 'world', value: true }, attributes: [{ key: 'open', value: { case: 'boolean', value: false } }] },
          ],
        },
      ],
    });
    expect([data.value(entity, 'hp'), data.value(entity, 'label'), data.value({ kind: 'world' }, 'open')]).toEqual([-3n, 'ü', false]);
    apply(data, { attributes: [{ sets: [{ target: { case: 'entity', value: 7 }, attributes: [{ key: 'hp' }] }] }] });
    expect([...data.attributesOf(entity).keys()]).toEqual(['label']);
    apply(data, { attributes: [{ entitiesEnded: [7, 8] }] });
    expect(data.attributesOf(entity).size).toBe(0);
    apply(data, { attributes: [{ complete: true }] });
    expect(data.value({ kind: 'world' }, 'open')).toBeUndefined();
  });
});

it('has the newest settings of the room until it leaves', () => {
  const data = new WorldData();
  apply(data, { frame: 1 });
  expect(data.room).toBeUndefined();
  apply(data, { room: { settings: { title: 'Night race', permissions: { 'player.explode': 'none' } }, bans: [{ member: 'subject/eve' }] } });
  apply(data, { frame: 2 });
  expect([data.room?.settings?.permissions, data.room?.bans.length]).toEqual([{ 'player.explode': 'none' }, 1]);
  apply(data, { room: { settings: { title: 'Day race' } } });
  expect([data.room?.settings?.title, data.room?.bans.length]).toEqual(['Day race', 0]);
  data.clear();
  expect(data.room).toBeUndefined();
});
