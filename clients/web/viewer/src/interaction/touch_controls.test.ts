import { expect, it } from 'vitest';
import { stickPosition } from './touch_controls';

it('deflects the stick in proportion, and at most fully', () => {
  expect(stickPosition(22, 0)).toEqual([0.5, 0]);
  const [x, y] = stickPosition(300, -400);
  expect(Math.hypot(x, y)).toBeCloseTo(1, 9);
  expect(y / x).toBeCloseTo(-4 / 3, 9);
});
