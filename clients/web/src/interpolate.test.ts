import { describe, expect, it } from 'vitest';
import { FrameBuffer } from './frame_buffer';
import { Delay, DrawnPoses } from './interpolate';
import type { EntityState } from './decode_frame';

const spec = { unitsPerMeter: 512, rotationComponent: 511 };
const entity = (id: number, x: number): EntityState => ({
  id,
  position: [x, 0, 0],
  largest: 3,
  rotation: [0, 0, 0],
  atRest: false,
});

describe('drawn poses', () => {
  const frames = new FrameBuffer();
  frames.add({ frame: 1, entities: [entity(1, 0), entity(2, 512)] }, 0, spec);
  frames.add({ frame: 2, entities: [entity(1, 512), entity(3, 0)] }, 10_000, spec);
  const drawn = new DrawnPoses();

  it('lie between two frames', () => {
    drawn.update(frames, 2_500);
    expect(drawn.count).toBe(2);
    expect(drawn.poses[0]).toBeCloseTo(0.25, 9);
    expect(drawn.ids[1]).toBe(3); // new: stands where it appears
    expect(drawn.poses[7]).toBe(0);
  });

  it('go on for 50 ms after the last frame, no further', () => {
    drawn.update(frames, 10_000 + 50_000);
    expect(drawn.poses[0]).toBeCloseTo(6, 6);
    drawn.update(frames, 10_000 + 500_000);
    expect(drawn.poses[0]).toBeCloseTo(6, 6);
  });
});

describe('delay', () => {
  it('settles at 1.7 intervals when frames come evenly, and grows with jitter', () => {
    const even = new Delay();
    for (let i = 0; i < 300; i++) even.add(i * 16_667, i * 16_667 + 5_000);
    expect(even.us).toBeGreaterThan(5_000 + 1.65 * 16_667);
    expect(even.us).toBeLessThan(5_000 + 1.75 * 16_667);
    const uneven = new Delay();
    for (let i = 0; i < 300; i++) uneven.add(i * 16_667, i * 16_667 + (i % 4) * 20_000);
    expect(uneven.us).toBeGreaterThan(16_667 + 55_000);
  });
});
