import { expect, it } from 'vitest';
import { RenderClock } from './render_clock.js';

const EVEN_MS = 1.7 * 16.667;

/** Frames at 60 Hz with a given latency, and a rendered frame after each. */
class Feed {
  readonly clock = new RenderClock();
  due = 50e6; // the clocks differ
  localUs = 1_000;
  least = 1;
  greatest = 1;

  frames(count: number, oneWayUs: number): void {
    for (let k = 0; k < count; k++) {
      this.due += 16_667;
      this.localUs += 16_667;
      this.clock.onFrame(this.due, this.localUs + oneWayUs);
      this.clock.advance(this.localUs + oneWayUs);
      this.least = Math.min(this.least, this.clock.speed);
      this.greatest = Math.max(this.greatest, this.clock.speed);
    }
  }
  behindMs(oneWayUs: number): number {
    return (this.due + oneWayUs - this.clock.renderTimeUs) / 1000;
  }
}

const near = (value: number, expected: number, tolerance: number) => expect(Math.abs(value - expected)).toBeLessThan(tolerance);

it('renders latency plus 1.7 intervals behind for regular frames', () => {
  const feed = new Feed();
  feed.frames(1200, 5_000);
  near(feed.clock.delayUs / 1000, EVEN_MS, 0.5);
  near(feed.behindMs(5_000), 5 + EVEN_MS, 1);
});

it('adapts to changed latency within 8 percent speed change', () => {
  const feed = new Feed();
  feed.frames(600, 5_000);
  feed.frames(1200, 80_000);
  near(feed.behindMs(80_000), 80 + EVEN_MS, 3);
  feed.frames(1200, 5_000);
  near(feed.behindMs(5_000), 5 + EVEN_MS, 3);
  expect(feed.least).toBeGreaterThanOrEqual(0.92 - 1e-9);
  expect(feed.greatest).toBeLessThanOrEqual(1.08 + 1e-9);
});

it('jumps only when more than one second behind', () => {
  const feed = new Feed();
  feed.frames(120, 1_500_000);
  feed.frames(1, 10_000); // a faster route
  const previous = feed.clock.renderTimeUs;
  feed.clock.advance(feed.localUs + 1_600_000);
  expect(feed.clock.renderTimeUs - previous).toBeGreaterThan(1e6);
});

it('does not increase the delay after the world slept', () => {
  const feed = new Feed();
  feed.frames(600, 5_000);
  // Four snapshots per second for one minute.
  for (let k = 0; k < 240; k++) {
    feed.due += 250_000;
    feed.localUs += 250_000;
    feed.clock.onFrame(feed.due, feed.localUs + 5_000);
  }
  feed.frames(60, 5_000);
  near(feed.clock.delayUs / 1000, EVEN_MS, 1);
});

it('does not advance while the local clock stands or goes back', () => {
  const feed = new Feed();
  feed.frames(10, 5_000);
  const renderTimeUs = feed.clock.renderTimeUs;
  expect(feed.clock.advance(feed.localUs + 5_000)).toBe(renderTimeUs);
  expect(feed.clock.advance(feed.localUs - 900_000)).toBe(renderTimeUs);
});

it('returns zero before the first frame and after a reset', () => {
  const feed = new Feed();
  expect(feed.clock.advance(1e6)).toBe(0);
  feed.frames(10, 5_000);
  feed.clock.reset();
  expect(feed.clock.advance(9e6)).toBe(0);
});
