import { describe, expect, it } from 'vitest';
import { renderedTime } from './rendered_time.js';

describe('rendered time', () => {
  const newest = { frame: 600, serverUs: 10_000_000 };

  it('is behind the newest frame by the render delay', () => {
    const rendered = renderedTime(newest, 10_000_000 - 75_000, 60)!; // 4.5 ticks
    expect(rendered.tick).toBe(595);
    expect(rendered.fraction).toBeCloseTo(0.5, 6);
  });

  it('is at most 50 ms after the newest frame', () => {
    const rendered = renderedTime(newest, 10_000_000 + 400_000, 60)!;
    expect(rendered.tick + rendered.fraction).toBeCloseTo(603, 6);
  });

  it('is the newest frame without rendering, and undefined before the first frame', () => {
    expect(renderedTime(newest, 0, 60)).toEqual({ tick: 600, fraction: 0 });
    expect(renderedTime(newest, 8_000_000, 60)).toEqual({ tick: 600, fraction: 0 });
    expect(renderedTime(undefined, 5, 60)).toBeUndefined();
  });
});
