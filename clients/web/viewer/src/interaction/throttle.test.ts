import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Throttle } from './throttle';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('runs ten times per second for sixty requests, plus once for the last one', async () => {
  const runs: number[] = [];
  let requested = 0;
  const throttle = new Throttle(100, async () => void runs.push(requested));
  for (; requested < 60; requested++) {
    throttle.request();
    await vi.advanceTimersByTimeAsync(1000 / 60);
  }
  expect(runs.length).toBe(10);
  await vi.advanceTimersByTimeAsync(1000);
  expect(runs.length).toBe(11);
  expect(runs[10]).toBe(60);
});

it('waits for a slow run before starting the next', async () => {
  let started = 0;
  let finish = () => {};
  const throttle = new Throttle(100, () => {
    started++;
    return new Promise((done) => (finish = done));
  });
  throttle.request();
  throttle.request();
  await vi.advanceTimersByTimeAsync(5000);
  expect(started).toBe(1);
  finish();
  await vi.advanceTimersByTimeAsync(1);
  expect(started).toBe(2);
});
