import { describe, expect, it } from 'vitest';
import type { EntityState } from '../snapshot/decode_frame.js';
import { FrameBuffer } from './frame_buffer.js';
import { RenderedPoses } from './rendered_poses.js';

const spec = { unitsPerMeter: 512, rotationComponent: 511 };
const entity = (id: number, x: number): EntityState => ({
  id,
  position: [x * 512, 0, 0],
  largest: 3,
  rotation: [0, 0, 0],
  atRest: false,
});

describe('drawn poses', () => {
  const frames = new FrameBuffer();
  frames.add({ frame: 1, entities: [entity(1, 0), entity(2, 1)] }, 0, spec);
  frames.add({ frame: 2, entities: [entity(1, 1), entity(3, 0)] }, 10_000, spec);
  const drawn = new RenderedPoses();

  it('lie between two frames', () => {
    drawn.update(frames, 2_500, 0);
    expect(drawn.count).toBe(2);
    expect(drawn.poses[0]).toBeCloseTo(0.25, 9);
    expect(drawn.ids[1]).toBe(3); // new: stands where it appears
    expect(drawn.poses[7]).toBe(0);
  });

  it('go on for 50 ms after the last frame, no further', () => {
    drawn.update(frames, 10_000 + 50_000, 57_500);
    expect(drawn.poses[0]).toBeCloseTo(6, 6);
    drawn.update(frames, 10_000 + 500_000, 507_500);
    expect(drawn.poses[0]).toBeCloseTo(6, 6);
  });
});

describe('a body that leaps', () => {
  /** Where it is drawn at a time at which it stood at 1 until frame 90, and at `there` since; frames stop from `stop` to `go`. */
  const leap = (there: number, stop: number, go: number) => {
    const frames = new FrameBuffer();
    const drawn = new RenderedPoses();
    const seen: number[] = [];
    let next = 0;
    for (let us = 0; us < 120 * 16_667; us += 4_167) {
      const newest = Math.floor(us / 16_667);
      if (newest < stop || newest >= go)
        for (; next <= newest; next++) frames.add({ frame: next + 1, entities: [entity(1, next < 90 ? 1 : there)] }, next * 16_667, spec);
      drawn.update(frames, us - 25_000, us);
      seen.push(drawn.poses[0]!);
    }
    return seen;
  };

  it('is at the old place and then at the new one', () => {
    const seen = leap(4, 1000, 1000);
    expect(new Set(seen)).toEqual(new Set([1, 4]));
    expect(seen[seen.length - 1]).toBe(4);
  });

  it('does not slide there when it leapt while frames stopped', () => {
    expect(new Set(leap(3, 85, 95))).toEqual(new Set([1, 3]));
  });
});

it('shows the world as it is to who did not look for a while', () => {
  const frames = new FrameBuffer();
  const drawn = new RenderedPoses();
  const feed = (from: number, to: number) => {
    for (let n = from; n < to; n++) frames.add({ frame: n + 1, entities: [entity(1, n / 60)] }, n * 16_667, spec);
  };
  feed(0, 60);
  drawn.update(frames, 62 * 16_667, 62 * 16_667); // a guess
  feed(60, 120);
  drawn.update(frames, 118.5 * 16_667, 118.5 * 16_667);
  expect(drawn.poses[0]).toBeCloseTo(118.5 / 60, 2);
});
