// Text descriptions of the events of a tick.

import type { ContactEvent, Events } from '@jostle/client/gen/play_pb';

const NAMED_BODIES_MAX = 2; // if more bodies fell asleep or woke in one tick, only their number is shown

/**
 * One line per event, the most important last. The server repeats ongoing contacts and trigger overlaps
 * in every tick; they are omitted.
 */
export function describeEvents(events: Events, name: (entity: number) => string): string[] {
  const lines: string[] = [];
  const pair = ({ entityA, entityB }: Pick<ContactEvent, 'entityA' | 'entityB'>) => `${entityA} ${entityB}`;
  const both = (event: ContactEvent, verb: string) => `${name(event.entityA)} ${verb} ${name(event.entityB)}`;
  // A hit includes the information of the contact that it began.
  const hit = new Set(events.hits.map(pair));
  if (events.missed > 0) lines.push(`events of ${counted(events.missed, 'tick', 'ticks')} missed`);
  lines.push(...describeSleep(events.fellAsleep, 'fell asleep', name), ...describeSleep(events.woke, 'woke', name));
  for (const event of events.contactsEnded) lines.push(both(event, 'separated from'));
  for (const event of events.contactsBegan) if (!hit.has(pair(event))) lines.push(both(event, 'touched'));
  for (const event of events.triggersLeft) lines.push(`${name(event.entity)} left ${name(event.trigger)}`);
  for (const event of events.triggersEntered) lines.push(`${name(event.entity)} entered ${name(event.trigger)}`);
  for (const event of events.hits) lines.push(`${both(event, 'hit')} at ${event.speed.toFixed(1)} m/s`);
  for (const event of events.jointsBroke)
    lines.push(`joint broke between ${name(event.entityA)} and ${name(event.entityB)} (${Math.round(event.force)} N)`);
  return lines;
}

function describeSleep(entities: readonly number[], verb: string, name: (entity: number) => string): string[] {
  if (entities.length > NAMED_BODIES_MAX) return [`${entities.length} bodies ${verb}`];
  return entities.map((entity) => `${name(entity)} ${verb}`);
}

/** A number with its noun. */
export function counted(n: number, one: string, many: string): string {
  return `${n} ${n === 1 ? one : many}`;
}

/** The newest lines, oldest first. Consecutive equal lines become one line with a count. */
export class RecentLines {
  private readonly entries: { text: string; count: number }[] = [];

  constructor(private readonly max: number) {}

  add(text: string): void {
    const last = this.entries[this.entries.length - 1];
    if (last?.text === text) {
      last.count++;
      return;
    }
    this.entries.push({ text, count: 1 });
    if (this.entries.length > this.max) this.entries.shift();
  }

  clear(): void {
    this.entries.length = 0;
  }

  get lines(): string[] {
    return this.entries.map(({ text, count }) => (count > 1 ? `${text} × ${count}` : text));
  }
}
