import { create, type MessageInitShape } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { describeEvents, RecentLines } from './describe_events';
import { EventsSchema } from '@jostle/client/gen/play_pb';

const names = ['', 'ball', 'wall', 'box', 'goal'];
const words = (init: MessageInitShape<typeof EventsSchema>) => describeEvents(create(EventsSchema, init), (id) => names[id]!);

describe('events in words', () => {
  it('a hit says how fast', () => {
    expect(words({ hits: [{ entityA: 1, entityB: 2, speed: 4.234 }] })).toEqual(['ball hit wall at 4.2 m/s']);
  });

  it('a hit is not said twice because it began a contact', () => {
    const contactsBegan = [
      { entityA: 1, entityB: 2, speed: 4.2 },
      { entityA: 1, entityB: 3, speed: 0.2 },
    ];
    expect(words({ contactsBegan, hits: [{ entityA: 1, entityB: 2, speed: 4.2 }] })).toEqual([
      'ball touched box',
      'ball hit wall at 4.2 m/s',
    ]);
  });

  it('triggers are entered and left by the other body', () => {
    expect(words({ triggersEntered: [{ trigger: 4, entity: 3 }], triggersLeft: [{ trigger: 4, entity: 1 }] })).toEqual([
      'ball left goal',
      'box entered goal',
    ]);
  });

  it('a joint that broke says between what and with what force', () => {
    expect(words({ jointsBroke: [{ entityA: 3, entityB: 2, force: 1520.4 }] })).toEqual([
      'joint broke between box and wall (1520 N)',
    ]);
  });

  it('many sleepers are counted, few are named', () => {
    expect(words({ fellAsleep: [1, 3], woke: [1, 2, 3] })).toEqual(['ball fell asleep', 'box fell asleep', '3 bodies woke']);
  });

  it('what merely goes on is not said', () => {
    expect(words({ contacts: [{ entityA: 1, entityB: 2 }], triggersStayed: [{ trigger: 4, entity: 1 }] })).toEqual([]);
  });

  it('says what it missed', () => {
    expect(words({ missed: 1, contactsEnded: [{ entityA: 1, entityB: 3 }] })).toEqual([
      '1 tick of events went by unseen',
      'ball parted from box',
    ]);
  });
});

it('keeps the last 12 lines, and counts what repeats', () => {
  const last = new RecentLines(12);
  for (let i = 0; i < 20; i++) last.add(`line ${i}`);
  last.add('line 19');
  expect(last.lines.length).toBe(12);
  expect([last.lines[0], last.lines[11]]).toEqual(['line 8', 'line 19 × 2']);
});
