import { expect, it } from 'vitest';
import { scaleLength, scaleText } from './scale_bar';

it('selects round lengths', () => {
  expect([0.7, 1, 1.9, 4.9, 5, 19, 99, 100, 0.04].map(scaleLength)).toEqual([0.5, 1, 1, 2, 5, 10, 50, 100, expect.closeTo(0.02, 9)]);
});
it('writes lengths with units', () => {
  expect([0.002, 0.05, 0.5, 1, 200, 5000].map(scaleText)).toEqual(['2 mm', '5 cm', '50 cm', '1 m', '200 m', '5 km']);
});
