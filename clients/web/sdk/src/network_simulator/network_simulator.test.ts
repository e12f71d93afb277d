import { expect, it } from 'vitest';
import { IDEAL_NETWORK, NetworkSimulator, type NetworkConditions } from './network_simulator.js';

/** Latency in ms of each of `count` messages at 60 per second. */
function latenciesOf(conditions: Partial<NetworkConditions>, count = 36_000): number[] {
  const simulator = new NetworkSimulator({ ...IDEAL_NETWORK, ...conditions });
  const latencies: number[] = [];
  let last = 0;
  for (let k = 0; k < count; k++) {
    const sent = k * 16_667;
    const arrives = simulator.arrivalUs(sent);
    if (arrives < last) throw new Error('overtaken');
    last = arrives;
    latencies.push((arrives - sent) / 1000);
  }
  return latencies;
}
const mean = (values: number[]) => values.reduce((a, b) => a + b) / values.length;

it('applies exactly the configured delay', () => {
  expect(new Set(latenciesOf({ delay: 80 }))).toEqual(new Set([80]));
});

it('has uniform jitter with an exponential tail', () => {
  const uniform = latenciesOf({ delay: 10, jitter: 16 });
  expect(Math.abs(mean(uniform) - 18)).toBeLessThan(0.1);
  expect(Math.max(...uniform)).toBeLessThanOrEqual(26);
  const tail = latenciesOf({ delay: 10, tail: 4 });
  expect(Math.abs(mean(tail) - 14)).toBeLessThan(0.2);
});

it('stalls at the configured interval and delays later messages', () => {
  const latencies = latenciesOf({ stalls: 250, stallEvery: 5000 });
  const stalls = latencies.filter((latency, k) => k > 0 && latency > 200 && latencies[k - 1]! < 100).length;
  expect(Math.abs(stalls - 120)).toBeLessThanOrEqual(8); // in 600 s
  expect(Math.max(...latencies)).toBeLessThan(250.1);
});

it('delivers lost messages one retransmission later', () => {
  const latencies = latenciesOf({ delay: 10, loss: 0.01 });
  const late = latencies.filter((latency) => latency > 10).length / latencies.length;
  expect(Math.abs(late - 0.105)).toBeLessThan(0.02);
  expect(Math.abs(Math.max(...latencies) - 210)).toBeLessThan(1);
});

it('is deterministic per seed in every language', () => {
  const simulator = new NetworkSimulator({ delay: 40, jitter: 20, tail: 5, stalls: 100, stallEvery: 500, loss: 0.05, retransmit: 200, seed: 7 });
  let sum = 0;
  for (let k = 0; k < 1000; k++) sum += simulator.arrivalUs(k * 16_667) - k * 16_667;
  expect(sum).toBe(109_097_580); // tests/clients/cpp/core/network_simulator_test.cpp has the same number
});
