// The newest events as text, with marks at hits. Events are subscribed to only while the panel is open.

import { describeEvents, RecentLines } from './describe_events';
import type { Events } from '@jostle/client/gen/play_pb';
import type { HitMarks } from '../scene/hit_marks';

const LINES = 12;

export class EventsPanel {
  private readonly recent = new RecentLines(LINES);
  private readonly list = document.createElement('ol');
  private changed = true;

  constructor(
    content: HTMLElement,
    private readonly marks: HitMarks,
    private readonly setEnabled: (enabled: boolean) => void,
    private readonly nameOf: (entity: number) => string,
  ) {
    content.append(this.list);
  }

  opened(): void {
    this.setEnabled(true);
  }
  closed(): void {
    this.clear();
    this.setEnabled(false);
  }

  clear(): void {
    this.recent.clear();
    this.changed = true;
  }

  /** `renderedAtMs`: when rendering reaches the tick of the events. */
  addEvents(events: Events, renderedAtMs: number): void {
    for (const text of describeEvents(events, this.nameOf)) this.recent.add(text);
    for (const { point, speed } of events.hits) if (point) this.marks.add(point.x, point.y, point.z, speed, renderedAtMs);
    this.changed = true;
  }

  /** Call once per rendered frame; updates the DOM at most once, however many events arrived. */
  update(): void {
    if (!this.changed) return;
    this.changed = false;
    const { lines } = this.recent;
    const texts = lines.length > 0 ? lines : ['No events yet.'];
    this.list.replaceChildren(
      ...texts.map((line) => {
        const row = document.createElement('li');
        row.textContent = line;
        return row;
      }),
    );
  }
}
