import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { IDEAL_NETWORK, NetworkSimulator, type Delivery, type NetworkConditions } from './network_simulator.js';

/** Latency in ms of each of `count` messages at 60 per second. */
function latenciesOf(conditions: Partial<NetworkConditions>, count = 36_000): number[] {
  const simulator = new NetworkSimulator({ ...IDEAL_NETWORK, ...conditions });
  const latencies: number[] = [];
  let last = 0;
  for (let k = 0; k < count; k++) {
    const sent = k * 16_667;
    const arrives = simulator.send(sent).arrivalUs;
    if (arrives < last) throw new Error('overtaken');
    last = arrives;
    latencies.push((arrives - sent) / 1000);
  }
  return latencies;
}
const mean = (values: number[]) => values.reduce((a, b) => a + b) / values.length;

it('applies exactly the configured latency', () => {
  expect(new Set(latenciesOf({ latencyMs: 80 }))).toEqual(new Set([80]));
});

it('has uniform jitter with an exponential tail', () => {
  const uniform = latenciesOf({ latencyMs: 10, jitterMs: 16 });
  expect(Math.abs(mean(uniform) - 18)).toBeLessThan(0.1);
  expect(Math.max(...uniform)).toBeLessThanOrEqual(26);
  const tail = latenciesOf({ latencyMs: 10, jitterTailMs: 4 });
  expect(Math.abs(mean(tail) - 14)).toBeLessThan(0.2);
});

it('stalls at the configured interval and delays later messages', () => {
  const latencies = latenciesOf({ stallMs: 250, stallIntervalMs: 5000 });
  const stalls = latencies.filter((latency, k) => k > 0 && latency > 200 && latencies[k - 1]! < 100).length;
  expect(Math.abs(stalls - 120)).toBeLessThanOrEqual(8); // in 600 s
  expect(Math.max(...latencies)).toBeLessThan(250.1);
});

it('delivers lost messages one retransmission later', () => {
  const latencies = latenciesOf({ latencyMs: 10, loss: 0.01 });
  const late = latencies.filter((latency) => latency > 10).length / latencies.length;
  expect(Math.abs(late - 0.105)).toBeLessThan(0.02);
  expect(Math.abs(Math.max(...latencies) - 210)).toBeLessThan(1);
});

interface Vector {
  delivery: Delivery;
  path: number;
  conditions: Record<string, number>; // named as in C++
  interval_us: number;
  bytes: number;
  transits: [copies: number, arrivalUs: number][];
}

it('produces the arrival times of the vectors shared with C++', () => {
  const file = new URL('../../../../../tests/base/network_simulator_vectors.json', import.meta.url);
  for (const vector of JSON.parse(readFileSync(file, 'utf8')) as Vector[]) {
    const camelCase = (name: string) => name.replace(/_(.)/g, (_, letter: string) => letter.toUpperCase());
    const conditions = Object.fromEntries(Object.entries(vector.conditions).map(([name, value]) => [camelCase(name), value]));
    const simulator = new NetworkSimulator({ ...IDEAL_NETWORK, ...conditions }, vector.path, vector.delivery);
    const transits = vector.transits.map((_, k) => simulator.send(k * vector.interval_us, vector.bytes));
    expect(transits.map(({ copies, arrivalUs }) => [copies, arrivalUs])).toEqual(vector.transits);
  }
});
