// What happened last, in words; a mark where something hit. The server is asked to tell only while this is open.

import { describeEvents, RecentLines } from './describe_events';
import type { Events } from '@jostle/client/gen/play_pb';
import type { HitMarks } from '../scene/hit_marks';

const LINES = 12;

export class EventsPanel {
  private readonly last = new RecentLines(LINES);
  private readonly list = document.createElement('ol');
  private changed = true;

  constructor(
    private readonly panel: HTMLElement,
    private readonly marks: HitMarks,
    private readonly want: (wanted: boolean) => void,
    private readonly nameOf: (entity: number) => string,
  ) {
    const title = document.createElement('h2');
    title.textContent = 'Events';
    panel.append(title, this.list);
  }

  toggle(): void {
    this.panel.hidden = !this.panel.hidden;
    if (this.panel.hidden) this.clear();
    this.want(!this.panel.hidden);
  }

  clear(): void {
    this.last.clear();
    this.changed = true;
  }

  /** `seenMs`: when the picture will have come to that moment. */
  addEvents(events: Events, seenMs: number): void {
    for (const words of describeEvents(events, this.nameOf)) this.last.add(words);
    for (const { point, speed } of events.hits) if (point) this.marks.add(point.x, point.y, point.z, speed, seenMs);
    this.changed = true;
  }

  /** Once a picture: however much happens, the page is written at most once in between. */
  update(): void {
    if (!this.changed || this.panel.hidden) return;
    this.changed = false;
    const { lines } = this.last;
    const shown = lines.length > 0 ? lines : ['Nothing yet.'];
    this.list.replaceChildren(
      ...shown.map((line) => {
        const row = document.createElement('li');
        row.textContent = line;
        return row;
      }),
    );
  }
}
