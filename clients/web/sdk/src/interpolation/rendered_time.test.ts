import { describe, expect, it } from 'vitest';
import { renderedTime } from './rendered_time.js';

describe('the moment that is shown', () => {
  const newest = { frame: 600, serverUs: 10_000_000 };

  it('is as many ticks before the newest frame as the picture is behind it', () => {
    const shown = renderedTime(newest, 10_000_000 - 75_000, 60)!; // 4.5 ticks
    expect(shown.tick).toBe(595);
    expect(shown.fraction).toBeCloseTo(0.5, 6);
  });

  it('is at most 50 ms after the newest frame, as pictures are', () => {
    const shown = renderedTime(newest, 10_000_000 + 400_000, 60)!;
    expect(shown.tick + shown.fraction).toBeCloseTo(603, 6);
  });

  it('is the newest frame where nobody draws, and none before the first', () => {
    expect(renderedTime(newest, 0, 60)).toEqual({ tick: 600, fraction: 0 });
    expect(renderedTime(newest, 8_000_000, 60)).toEqual({ tick: 600, fraction: 0 });
    expect(renderedTime(undefined, 5, 60)).toBeUndefined();
  });
});
