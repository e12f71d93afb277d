import { describe, expect, it } from 'vitest';
import { baselineFrames } from './baseline_frames.js';

describe('baseline frames', () => {
  it('are encoded as a small number for equal steps', () => {
    expect(baselineFrames(100, 0)).toEqual([0, 0, 0]);
    expect(baselineFrames(100, 1)).toEqual([99, 98, 97]);
    expect(baselineFrames(100, 3)).toEqual([97, 94, 91]);
    expect(baselineFrames(100, 2 | (1 << 8))).toEqual([98, 97, 96]);
    expect(baselineFrames(100, 2 | (255 << 8))).toEqual([98, 0, 0]);
    expect(baselineFrames(100, 2 | (5 << 8) | (255 << 16))).toEqual([98, 93, 0]);
  });

  it('that no encoder writes are rejected', () => {
    for (const baselines of [255, 256, 1 | (255 << 8) | (1 << 16), 1 | (1 << 24), 10, 5 | (5 << 8), 0xffffffff])
      expect(() => baselineFrames(10, baselines), `${baselines}`).toThrow();
    expect(baselineFrames(10, 3)).toEqual([7, 4, 1]);
    expect(() => baselineFrames(9, 3)).toThrow(/before the first frame/);
  });
});
