import { expect, it } from 'vitest';
import { addError, decay, poseError } from './pose_error.js';

const RESTING = { speed: 0, spin: 0 };
const FAST = { speed: 20, spin: 0 };
const meters = (x: number) => Float64Array.of(x, 0, 0, 0, 0, 0, 1);
const target = Float64Array.of(1, 2, 3, 0, 0, Math.sin(0.1), Math.cos(0.1));

it('the error applied to the target pose gives the rendered pose', () => {
  const rendered = Float64Array.of(1.5, 2, 2, Math.sin(0.3), 0, 0, Math.cos(0.3));
  const restored = target.slice();
  addError(restored, poseError(rendered, target, RESTING)!);
  restored.forEach((value, k) => expect(value).toBeCloseTo(rendered[k]!, 12));
});

it('halves in 100 ms and vanishes in one second when small', () => {
  const error = meters(0.01);
  expect(decay(error, RESTING, 0.1)).toBe(true);
  expect(error[0]).toBeCloseTo(0.005, 9);
  expect(decay(error, RESTING, 1)).toBe(false);
});

it('decays at 1.1 m/s or 0.35 of the body speed when large', () => {
  const slow = meters(2);
  decay(slow, RESTING, 0.1);
  expect(slow[0]).toBeCloseTo(2 - 0.11, 9);
  const fast = meters(8);
  decay(fast, FAST, 0.1);
  expect(fast[0]).toBeCloseTo(8 - 0.7, 9);
  const rotated = Float64Array.of(0, 0, 0, 0, Math.sin(1), 0, Math.cos(1)); // 2 rad
  decay(rotated, RESTING, 0.1);
  expect(2 * Math.asin(rotated[4]!)).toBeCloseTo(2 - 0.15, 9);
});

it('is not smoothed when that would take more than three seconds', () => {
  const none = meters(0);
  expect(poseError(meters(3.2), none, RESTING)).toBeDefined();
  expect(poseError(meters(3.4), none, RESTING)).toBeUndefined();
  expect(poseError(meters(3.4), none, { speed: 10, spin: 0 })).toBeDefined();
});
