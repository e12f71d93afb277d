import { expect, it } from 'vitest';
import { ClockSync } from './clock_sync.js';

it('uses the sample with the shortest round trip', () => {
  const clock = new ClockSync();
  expect(clock.ready).toBe(false);
  clock.add(0, 1_050_000, 100_000); // 100 ms round trip, true offset 1 s
  clock.add(200_000, 1_281_000, 280_000); // asymmetric: offset 1.041 s
  clock.add(300_000, 1_301_000, 302_000);
  expect(clock.serverUs(0)).toBe(1_000_000);
  expect(clock.rttMs).toBe(2);
});

it('rejects pongs from the future', () => {
  const clock = new ClockSync();
  clock.add(500, 1, 400);
  expect(clock.ready).toBe(false);
});
