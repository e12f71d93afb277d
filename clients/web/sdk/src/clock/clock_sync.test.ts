import { expect, it } from 'vitest';
import { ClockSync } from './clock.js';

it('believes the shortest round trip, whatever the others say', () => {
  const clock = new ClockSync();
  expect(clock.ready).toBe(false);
  clock.add(0, 1_050_000, 100_000); // 100 ms round trip, true offset 1 s
  clock.add(200_000, 1_281_000, 280_000); // lopsided: says 1.041 s
  clock.add(300_000, 1_301_000, 302_000);
  expect(clock.serverUs(0)).toBe(1_000_000);
  expect(clock.rttMs).toBe(2);
});

it('takes no pong from the future', () => {
  const clock = new ClockSync();
  clock.add(500, 1, 400);
  expect(clock.ready).toBe(false);
});
