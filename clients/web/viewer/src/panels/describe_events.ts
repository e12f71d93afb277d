// What happened in a tick, in words.

import type { ContactEvent, Events } from '@jostle/client/gen/play_pb';

const NAMED_SLEEPERS = 2; // more of them in one tick are only counted

/**
 * One line for each thing that happened, the ones that matter most last. What merely goes on (contacts that press, bodies that
 * stay in a trigger) is said in every tick by the server and not repeated here.
 */
export function describeEvents(events: Events, name: (entity: number) => string): string[] {
  const lines: string[] = [];
  const pair = ({ entityA, entityB }: Pick<ContactEvent, 'entityA' | 'entityB'>) => `${entityA} ${entityB}`;
  const both = (event: ContactEvent, verb: string) => `${name(event.entityA)} ${verb} ${name(event.entityB)}`;
  // A hit says all that its beginning would.
  const hit = new Set(events.hits.map(pair));
  if (events.missed > 0) lines.push(`${counted(events.missed, 'tick', 'ticks')} of events went by unseen`);
  lines.push(...describeSleep(events.fellAsleep, 'fell asleep', name), ...describeSleep(events.woke, 'woke', name));
  for (const event of events.contactsEnded) lines.push(both(event, 'parted from'));
  for (const event of events.contactsBegan) if (!hit.has(pair(event))) lines.push(both(event, 'touched'));
  for (const event of events.triggersLeft) lines.push(`${name(event.entity)} left ${name(event.trigger)}`);
  for (const event of events.triggersEntered) lines.push(`${name(event.entity)} entered ${name(event.trigger)}`);
  for (const event of events.hits) lines.push(`${both(event, 'hit')} at ${event.speed.toFixed(1)} m/s`);
  for (const event of events.jointsBroke)
    lines.push(`joint broke between ${name(event.entityA)} and ${name(event.entityB)} (${Math.round(event.force)} N)`);
  return lines;
}

function describeSleep(entities: readonly number[], verb: string, name: (entity: number) => string): string[] {
  if (entities.length > NAMED_SLEEPERS) return [`${entities.length} bodies ${verb}`];
  return entities.map((entity) => `${name(entity)} ${verb}`);
}

function counted(n: number, one: string, many: string): string {
  return `${n} ${n === 1 ? one : many}`;
}

/** The newest lines, oldest first. The same words again and again are one line with a count. */
export class RecentLines {
  private readonly entries: { words: string; times: number }[] = [];

  constructor(private readonly most: number) {}

  add(words: string): void {
    const last = this.entries[this.entries.length - 1];
    if (last?.words === words) {
      last.times++;
      return;
    }
    this.entries.push({ words, times: 1 });
    if (this.entries.length > this.most) this.entries.shift();
  }

  clear(): void {
    this.entries.length = 0;
  }

  get lines(): string[] {
    return this.entries.map(({ words, times }) => (times > 1 ? `${words} × ${times}` : words));
  }
}
