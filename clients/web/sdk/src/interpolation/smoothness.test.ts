// One minute of motion in closed form over simulated networks, rendered 144 and 60 times per second.
// Same networks and limits as tests/clients/cpp/core/smoothness_test.cpp.

import { describe, expect, it } from 'vitest';
import { IDEAL_NETWORK, type NetworkConditions } from '../network_simulator/network_simulator.js';
import { observe } from '../testing/observed_world.js';

// Limits per network; measured values are slightly lower. Errors come from extrapolation: a bounce is
// cut by 23 mm between two frames, and a body that holds while the real one moves on at 3 m/s is off by
// 2.6 m after a stall of 1 s.
const NETWORKS: { name: string; conditions: Partial<NetworkConditions>; errorP95Mm: number; errorMm: number; delayMs: number }[] = [
  { name: 'constant latency', conditions: { latencyMs: 40 }, errorP95Mm: 2, errorMm: 25, delayMs: 75 },
  { name: 'uniform jitter of 20 ms', conditions: { latencyMs: 40, jitterMs: 20 }, errorP95Mm: 2, errorMm: 25, delayMs: 82 },
  { name: 'uniform jitter of 80 ms', conditions: { latencyMs: 40, jitterMs: 80 }, errorP95Mm: 3, errorMm: 50, delayMs: 140 },
  { name: 'exponential jitter of 15 ms', conditions: { latencyMs: 40, jitterTailMs: 15 }, errorP95Mm: 10, errorMm: 125, delayMs: 112 },
  { name: 'stalls of 250 ms', conditions: { latencyMs: 40, jitterMs: 10, stallMs: 250, stallIntervalMs: 5000 }, errorP95Mm: 250, errorMm: 540, delayMs: 112 },
  { name: 'stalls of 1 s', conditions: { latencyMs: 40, jitterMs: 10, stallMs: 1000, stallIntervalMs: 10_000 }, errorP95Mm: 2050, errorMm: 2620, delayMs: 75 },
  { name: '2 % loss', conditions: { latencyMs: 40, jitterMs: 5, loss: 0.02 }, errorP95Mm: 35, errorMm: 360, delayMs: 220 },
];

describe.each(NETWORKS)('over a network with $name', ({ conditions, ...limits }) => {
  it.each([144, 60])('render clock is monotonic and bodies move smoothly at %d frames per second', (renderHz) => {
    const observation = observe({ ...IDEAL_NETWORK, ...conditions }, renderHz);
    expect(observation.renderedFrames).toBeGreaterThan(58 * renderHz);
    expect(observation.backwardSteps).toBe(0);
    expect(observation.leastSpeed).toBeGreaterThan(0.9);
    expect(observation.greatestSpeed).toBeLessThan(1.1);
    expect(observation.stepMm).toBeLessThan(20);
    expect(observation.interpolatedTeleports, 'a teleport of 5 m is not interpolated').toBe(0);
    expect(observation.ghosts, 'a removed body is not rendered').toBe(0);
    expect(observation.errorP95Mm).toBeLessThan(limits.errorP95Mm);
    expect(observation.errorMm).toBeLessThan(limits.errorMm);
    expect(observation.delayMs).toBeLessThan(limits.delayMs);
  });
});
