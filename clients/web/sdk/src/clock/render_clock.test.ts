import { expect, it } from 'vitest';
import { RenderClock } from './render_clock.js';

const EVEN_MS = 1.7 * 16.667;

/** Frames at 60 Hz, each so long on its way; a picture after each. */
class Feed {
  readonly clock = new RenderClock();
  due = 50e6; // two clocks that differ
  ours = 1_000;
  least = 1;
  greatest = 1;

  frames(count: number, oneWayUs: number): void {
    for (let k = 0; k < count; k++) {
      this.due += 16_667;
      this.ours += 16_667;
      this.clock.onFrame(this.due, this.ours + oneWayUs);
      this.clock.advance(this.ours + oneWayUs);
      this.least = Math.min(this.least, this.clock.speed);
      this.greatest = Math.max(this.greatest, this.clock.speed);
    }
  }
  behindMs(oneWayUs: number): number {
    return (this.due + oneWayUs - this.clock.renderTimeUs) / 1000;
  }
}

const near = (value: number, wanted: number, within: number) => expect(Math.abs(value - wanted)).toBeLessThan(within);

it('shows the way and 1.7 intervals ago when frames come evenly', () => {
  const feed = new Feed();
  feed.frames(1200, 5_000);
  near(feed.clock.delayUs / 1000, EVEN_MS, 0.5);
  near(feed.behindMs(5_000), 5 + EVEN_MS, 1);
});

it('walks to a longer way and back without leaving 8 percent', () => {
  const feed = new Feed();
  feed.frames(600, 5_000);
  feed.frames(1200, 80_000);
  near(feed.behindMs(80_000), 80 + EVEN_MS, 3);
  feed.frames(1200, 5_000);
  near(feed.behindMs(5_000), 5 + EVEN_MS, 3);
  expect(feed.least).toBeGreaterThanOrEqual(0.92 - 1e-9);
  expect(feed.greatest).toBeLessThanOrEqual(1.08 + 1e-9);
});

it('jumps only when it is more than a second behind', () => {
  const feed = new Feed();
  feed.frames(120, 1_500_000);
  feed.frames(1, 10_000); // a new route
  const before = feed.clock.renderTimeUs;
  feed.clock.advance(feed.ours + 1_600_000);
  expect(feed.clock.renderTimeUs - before).toBeGreaterThan(1e6);
});

it('is not late because the world rested', () => {
  const feed = new Feed();
  feed.frames(600, 5_000);
  // Four heartbeats a second, for a minute.
  for (let k = 0; k < 240; k++) {
    feed.due += 250_000;
    feed.ours += 250_000;
    feed.clock.onFrame(feed.due, feed.ours + 5_000);
  }
  feed.frames(60, 5_000);
  near(feed.clock.delayUs / 1000, EVEN_MS, 1);
});

it('stands while our clock stands or goes back', () => {
  const feed = new Feed();
  feed.frames(10, 5_000);
  const shown = feed.clock.renderTimeUs;
  expect(feed.clock.advance(feed.ours + 5_000)).toBe(shown);
  expect(feed.clock.advance(feed.ours - 900_000)).toBe(shown);
});

it('shows nothing before the first frame, nor after a reset', () => {
  const feed = new Feed();
  expect(feed.clock.advance(1e6)).toBe(0);
  feed.frames(10, 5_000);
  feed.clock.reset();
  expect(feed.clock.advance(9e6)).toBe(0);
});
