import { create, type MessageInitShape } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { describeEvents, RecentLines } from './describe_events';
import { EventsSchema } from '@jostle/client/gen/play_pb';

const names = ['', 'ball', 'wall', 'box', 'goal'];
const lines = (init: MessageInitShape<typeof EventsSchema>) => describeEvents(create(EventsSchema, init), (id) => names[id]!);

describe('event descriptions', () => {
  it('a hit includes its speed', () => {
    expect(lines({ hits: [{ entityA: 1, entityB: 2, speed: 4.234 }] })).toEqual(['ball hit wall at 4.2 m/s']);
  });

  it('a hit that began a contact is listed once', () => {
    const contactsBegan = [
      { entityA: 1, entityB: 2, speed: 4.2 },
      { entityA: 1, entityB: 3, speed: 0.2 },
    ];
    expect(lines({ contactsBegan, hits: [{ entityA: 1, entityB: 2, speed: 4.2 }] })).toEqual([
      'ball touched box',
      'ball hit wall at 4.2 m/s',
    ]);
  });

  it('triggers name the entering and leaving body', () => {
    expect(lines({ triggersEntered: [{ trigger: 4, entity: 3 }], triggersLeft: [{ trigger: 4, entity: 1 }] })).toEqual([
      'ball left goal',
      'box entered goal',
    ]);
  });

  it('a broken joint names its bodies and force', () => {
    expect(lines({ jointsBroke: [{ entityA: 3, entityB: 2, force: 1520.4 }] })).toEqual([
      'joint broke between box and wall (1520 N)',
    ]);
  });

  it('few sleeping bodies are named, many are counted', () => {
    expect(lines({ fellAsleep: [1, 3], woke: [1, 2, 3] })).toEqual(['ball fell asleep', 'box fell asleep', '3 bodies woke']);
  });

  it('ongoing contacts are omitted', () => {
    expect(lines({ contacts: [{ entityA: 1, entityB: 2 }], triggersStayed: [{ trigger: 4, entity: 1 }] })).toEqual([]);
  });

  it('reports missed ticks', () => {
    expect(lines({ missed: 1, contactsEnded: [{ entityA: 1, entityB: 3 }] })).toEqual([
      'events of 1 tick missed',
      'ball separated from box',
    ]);
  });
});

it('stores the last 12 lines and counts repetitions', () => {
  const last = new RecentLines(12);
  for (let i = 0; i < 20; i++) last.add(`line ${i}`);
  last.add('line 19');
  expect(last.lines.length).toBe(12);
  expect([last.lines[0], last.lines[11]]).toEqual(['line 8', 'line 19 × 2']);
});
