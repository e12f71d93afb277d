import { describe, expect, it } from 'vitest';
import { baseFrames } from './base_frames';

describe('base frames', () => {
  it('are a number that is small when the steps are equal', () => {
    expect(baseFrames(100, 0)).toEqual([0, 0, 0]);
    expect(baseFrames(100, 1)).toEqual([99, 98, 97]);
    expect(baseFrames(100, 3)).toEqual([97, 94, 91]);
    expect(baseFrames(100, 2 | (1 << 8))).toEqual([98, 97, 96]);
    expect(baseFrames(100, 2 | (255 << 8))).toEqual([98, 0, 0]);
    expect(baseFrames(100, 2 | (5 << 8) | (255 << 16))).toEqual([98, 93, 0]);
  });

  it('that no encoder writes are refused', () => {
    for (const baselines of [255, 256, 1 | (255 << 8) | (1 << 16), 1 | (1 << 24), 10, 5 | (5 << 8), 0xffffffff])
      expect(() => baseFrames(10, baselines), `${baselines}`).toThrow();
    expect(baseFrames(10, 3)).toEqual([7, 4, 1]);
    expect(() => baseFrames(9, 3)).toThrow(/before the first frame/);
  });
});
