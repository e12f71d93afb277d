import { expect, it } from 'vitest';
import type { EntityState } from '../snapshot/decode_frame.js';
import { FrameBuffer } from './frame_buffer.js';

const spec = { unitsPerMeter: 512, rotationComponent: 511 };
const entity = (id: number, x: number): EntityState => ({
  id,
  position: [x, 0, 0],
  largest: 3,
  rotation: [0, 0, 0],
  atRest: false,
});
const filled = (count: number) => {
  const frames = new FrameBuffer();
  for (let n = 1; n <= count; n++) frames.add({ frame: n, entities: [entity(1, n)] }, n * 1000, spec);
  return frames;
};

it('stores the newest 32 frames as baselines', () => {
  const frames = filled(40);
  expect(frames.find(8)).toBeUndefined();
  expect(frames.find(9)?.frame).toBe(9);
  expect(frames.find(40)?.frame).toBe(40);
  expect(frames.find(0)).toBeUndefined();
  expect(frames.newest?.frame).toBe(40);
});

it('finds the frames around a time and clamps at the ends', () => {
  const frames = filled(5);
  const around = (us: number) => {
    const pair = frames.around(us)!;
    return [pair.a.frame, pair.b.frame];
  };
  expect(around(3500)).toEqual([3, 4]);
  expect(around(4000)).toEqual([3, 4]);
  expect(around(0)).toEqual([1, 1]);
  expect(around(9000)).toEqual([4, 5]); // the last two, for extrapolation
  expect(new FrameBuffer().around(0)).toBeUndefined();
});

it('reuses the pose of an unchanged entity', () => {
  const frames = new FrameBuffer();
  const stays = entity(7, 1024);
  frames.add({ frame: 1, entities: [entity(1, 0), stays] }, 0, spec);
  const second = frames.add({ frame: 2, entities: [stays, entity(9, 512)] }, 1, spec);
  expect([...second.poses]).toEqual([2, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1]);
});
