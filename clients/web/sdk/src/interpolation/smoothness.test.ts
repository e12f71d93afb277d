// A minute of a known world over bad links, drawn 144 and 60 times a second: what a person sees. tests/clients/cpp/core/smoothness_test.cpp
// tells the same of the C++ client library, with the same links and bounds.

import { describe, expect, it } from 'vitest';
import { IDEAL_NETWORK, type NetworkConditions } from '../network_simulator/network_simulator.js';
import { observe } from '../testing/observed_world.js';

// What each link is allowed to cost; measured figures are a little below. Errors are those of who guesses: a bounce is cut by 23 mm
// between two frames, and who holds while a body goes on at 3 m/s is 2.6 m off when a stall of a second ends.
const LINKS: { name: string; link: Partial<NetworkConditions>; usualErrorMm: number; errorMm: number; behindMs: number }[] = [
  { name: 'even', link: { delay: 40 }, usualErrorMm: 2, errorMm: 25, behindMs: 75 },
  { name: 'uniform jitter of 20 ms', link: { delay: 40, jitter: 20 }, usualErrorMm: 2, errorMm: 25, behindMs: 82 },
  { name: 'uniform jitter of 80 ms', link: { delay: 40, jitter: 80 }, usualErrorMm: 3, errorMm: 50, behindMs: 140 },
  { name: 'exponential jitter of 15 ms', link: { delay: 40, tail: 15 }, usualErrorMm: 10, errorMm: 125, behindMs: 112 },
  { name: 'stalls of 250 ms', link: { delay: 40, jitter: 10, stalls: 250, stallEvery: 5000 }, usualErrorMm: 250, errorMm: 540, behindMs: 112 },
  { name: 'stalls of 1 s', link: { delay: 40, jitter: 10, stalls: 1000, stallEvery: 10_000 }, usualErrorMm: 2050, errorMm: 2620, behindMs: 75 },
  { name: 'two percent lost', link: { delay: 40, jitter: 5, loss: 0.02 }, usualErrorMm: 35, errorMm: 360, behindMs: 220 },
];

describe.each(LINKS)('over a link with $name', ({ link, ...most }) => {
  it.each([144, 60])('the clock never goes back and no body steps, at %d pictures a second', (picturesHz) => {
    const seen = observe({ ...IDEAL_NETWORK, ...link }, picturesHz);
    expect(seen.pictures).toBeGreaterThan(58 * picturesHz);
    expect(seen.backwardSteps).toBe(0);
    expect(seen.leastSpeed).toBeGreaterThan(0.9);
    expect(seen.greatestSpeed).toBeLessThan(1.1);
    expect(seen.stepMm).toBeLessThan(20);
    expect(seen.halfwayLeaps, 'a body that leaps by 5 m is never between').toBe(0);
    expect(seen.ghosts, 'a body that is gone is not shown').toBe(0);
    expect(seen.usualErrorMm).toBeLessThan(most.usualErrorMm);
    expect(seen.errorMm).toBeLessThan(most.errorMm);
    expect(seen.behindMs).toBeLessThan(most.behindMs);
  });
});
