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

describe('rendered poses', () => {
  const frames = new FrameBuffer();
  frames.add({ frame: 1, entities: [entity(1, 0), entity(2, 1)] }, 0, spec);
  frames.add({ frame: 2, entities: [entity(1, 1), entity(3, 0)] }, 10_000, spec);
  const poses = new RenderedPoses();

  it('are interpolated between two frames', () => {
    poses.update(frames, 2_500, 0);
    expect(poses.count).toBe(2);
    expect(poses.poses[0]).toBeCloseTo(0.25, 9);
    expect(poses.ids[1]).toBe(3); // new: at its first position
    expect(poses.poses[7]).toBe(0);
  });

  it('are extrapolated for at most 50 ms after the last frame', () => {
    poses.update(frames, 10_000 + 50_000, 57_500);
    expect(poses.poses[0]).toBeCloseTo(6, 6);
    poses.update(frames, 10_000 + 500_000, 507_500);
    expect(poses.poses[0]).toBeCloseTo(6, 6);
  });
});

describe('a teleporting body', () => {
  /**
   * Rendered x of a body that is at 1 until frame 90 and at `there` since; frames stop from `stop` to
   * `go`.
   */
  const teleport = (there: number, stop: number, go: number) => {
    const frames = new FrameBuffer();
    const poses = new RenderedPoses();
    const positions: number[] = [];
    let next = 0;
    for (let us = 0; us < 120 * 16_667; us += 4_167) {
      const newest = Math.floor(us / 16_667);
      if (newest < stop || newest >= go)
        for (; next <= newest; next++) frames.add({ frame: next + 1, entities: [entity(1, next < 90 ? 1 : there)] }, next * 16_667, spec);
      poses.update(frames, us - 25_000, us);
      positions.push(poses.poses[0]!);
    }
    return positions;
  };

  it('is not interpolated', () => {
    const positions = teleport(4, 1000, 1000);
    expect(new Set(positions)).toEqual(new Set([1, 4]));
    expect(positions[positions.length - 1]).toBe(4);
  });

  it('is not smoothed when it teleports during a frame gap', () => {
    expect(new Set(teleport(3, 85, 95))).toEqual(new Set([1, 3]));
  });
});

it('discards errors after a pause in rendering', () => {
  const frames = new FrameBuffer();
  const poses = new RenderedPoses();
  const feed = (from: number, to: number) => {
    for (let n = from; n < to; n++) frames.add({ frame: n + 1, entities: [entity(1, n / 60)] }, n * 16_667, spec);
  };
  feed(0, 60);
  poses.update(frames, 62 * 16_667, 62 * 16_667); // extrapolated
  feed(60, 120);
  poses.update(frames, 118.5 * 16_667, 118.5 * 16_667);
  expect(poses.poses[0]).toBeCloseTo(118.5 / 60, 2);
});
