import { expect, it } from 'vitest';
import { addError, decay, poseError } from './pose_error.js';

const STILL = { speed: 0, spin: 0 };
const FAST = { speed: 20, spin: 0 };
const metres = (x: number) => Float64Array.of(x, 0, 0, 0, 0, 0, 1);
const right = Float64Array.of(1, 2, 3, 0, 0, Math.sin(0.1), Math.cos(0.1));

it('put back onto what is right gives what was shown', () => {
  const shown = Float64Array.of(1.5, 2, 2, Math.sin(0.3), 0, 0, Math.cos(0.3));
  const again = right.slice();
  addError(again, poseError(shown, right, STILL)!);
  again.forEach((value, k) => expect(value).toBeCloseTo(shown[k]!, 12));
});

it('halves in a tenth of a second and is gone in one, when it is small', () => {
  const error = metres(0.01);
  expect(decay(error, STILL, 0.1)).toBe(true);
  expect(error[0]).toBeCloseTo(0.005, 9);
  expect(decay(error, STILL, 1)).toBe(false);
});

it('is walked at 1.1 metres a second or 0.35 of the speed, when it is great', () => {
  const slow = metres(2);
  decay(slow, STILL, 0.1);
  expect(slow[0]).toBeCloseTo(2 - 0.11, 9);
  const fast = metres(8);
  decay(fast, FAST, 0.1);
  expect(fast[0]).toBeCloseTo(8 - 0.7, 9);
  const turned = Float64Array.of(0, 0, 0, 0, Math.sin(1), 0, Math.cos(1)); // 2 rad
  decay(turned, STILL, 0.1);
  expect(2 * Math.asin(turned[4]!)).toBeCloseTo(2 - 0.15, 9);
});

it('is none when it would take more than three seconds', () => {
  const none = metres(0);
  expect(poseError(metres(3.2), none, STILL)).toBeDefined();
  expect(poseError(metres(3.4), none, STILL)).toBeUndefined();
  expect(poseError(metres(3.4), none, { speed: 10, spin: 0 })).toBeDefined();
});
