import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Throttle } from './throttle';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('runs ten times in a second of sixty askings, and once more for the last', async () => {
  const seen: number[] = [];
  let asked = 0;
  const paced = new Throttle(100, async () => void seen.push(asked));
  for (; asked < 60; asked++) {
    paced.request();
    await vi.advanceTimersByTimeAsync(1000 / 60);
  }
  expect(seen.length).toBe(10);
  await vi.advanceTimersByTimeAsync(1000);
  expect(seen.length).toBe(11);
  expect(seen[10]).toBe(60);
});

it('waits for a slow answer before it asks again', async () => {
  let started = 0;
  let answer = () => {};
  const paced = new Throttle(100, () => {
    started++;
    return new Promise((done) => (answer = done));
  });
  paced.request();
  paced.request();
  await vi.advanceTimersByTimeAsync(5000);
  expect(started).toBe(1);
  answer();
  await vi.advanceTimersByTimeAsync(1);
  expect(started).toBe(2);
});
