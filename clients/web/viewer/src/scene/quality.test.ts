import { describe, expect, it } from 'vitest';
import { AutomaticQuality } from './quality';

/** Runs `seconds` of frames that take `frameMs` at each level; returns the levels after each second. */
function run(quality: AutomaticQuality, seconds: number, frameMs: (level: number) => number, from = 0): number[] {
  const levels: number[] = [];
  let now = from;
  for (let second = 1; second <= seconds; second++) {
    while (now < from + second * 1000) {
      now += frameMs(quality.level);
      quality.frame(now);
    }
    levels.push(quality.level);
  }
  return levels;
}

describe('automatic quality', () => {
  it('keeps the best level at 60 frames per second', () => {
    expect(run(new AutomaticQuality(), 20, () => 16.7).at(-1)).toBe(0);
  });
  it('drops to the first level that is fast enough, and stays there', () => {
    const levels = run(new AutomaticQuality(), 30, (level) => [60, 40, 20, 10][level]!);
    expect(levels.at(-1)).toBe(2);
    expect(levels.filter((level, k) => k > 0 && level !== levels[k - 1]).length).toBe(2);
  });
  it('does not drop for a single slow second', () => {
    const quality = new AutomaticQuality();
    run(quality, 6, () => 16.7);
    run(quality, 1, () => 40, 6000);
    expect(run(quality, 3, () => 16.7, 7000).at(-1)).toBe(0);
  });
  it('raises the level after 8 fast seconds, and tries a level that failed less often', () => {
    const quality = new AutomaticQuality();
    // Level 0 takes 40 ms, level 1 takes 12 ms.
    const levels = run(quality, 240, (level) => (level === 0 ? 40 : 12));
    const secondsAtBest = levels.slice(5).filter((level) => level === 0).length;
    expect(secondsAtBest).toBeGreaterThan(0);
    expect(secondsAtBest).toBeLessThan(16);
  });
  it('returns to the better level if the display limits the frame rate', () => {
    expect(run(new AutomaticQuality(), 30, () => 33.3).at(-1)).toBe(0);
  });
  it('drops at two frames per second', () => {
    expect(run(new AutomaticQuality(), 12, (level) => [500, 400, 300, 30][level]!).at(-1)).toBe(3);
  });
  it('ignores a hidden page', () => {
    const quality = new AutomaticQuality();
    run(quality, 5, () => 16.7);
    for (let k = 1; k <= 20; k++) quality.frame(5000 + 2000 * k);
    expect(quality.level).toBe(0);
  });
});
