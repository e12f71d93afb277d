import { expect, it } from 'vitest';
import { IDEAL_NETWORK, NetworkSimulator, networkConditionsFromQuery, type NetworkConditions } from './network_simulator.js';

/** How long each of so many messages, 60 a second, is on its way, ms. */
function waysOf(settings: Partial<NetworkConditions>, count = 36_000): number[] {
  const link = new NetworkSimulator({ ...IDEAL_NETWORK, ...settings });
  const ways: number[] = [];
  let last = 0;
  for (let k = 0; k < count; k++) {
    const sent = k * 16_667;
    const arrives = link.arrivalUs(sent);
    if (arrives < last) throw new Error('overtaken');
    last = arrives;
    ways.push((arrives - sent) / 1000);
  }
  return ways;
}
const mean = (values: number[]) => values.reduce((a, b) => a + b) / values.length;

it('delays by what it was told and no more', () => {
  expect(new Set(waysOf({ delay: 80 }))).toEqual(new Set([80]));
});

it('has even jitter and an exponential tail', () => {
  const even = waysOf({ delay: 10, jitter: 16 });
  expect(Math.abs(mean(even) - 18)).toBeLessThan(0.1);
  expect(Math.max(...even)).toBeLessThanOrEqual(26);
  const tail = waysOf({ delay: 10, tail: 4 });
  expect(Math.abs(mean(tail) - 14)).toBeLessThan(0.2);
});

it('stalls every so often and holds up what is behind', () => {
  const ways = waysOf({ stalls: 250, stallEvery: 5000 });
  const stalls = ways.filter((way, k) => k > 0 && way > 200 && ways[k - 1]! < 100).length;
  expect(Math.abs(stalls - 120)).toBeLessThanOrEqual(8); // of 600 s
  expect(Math.max(...ways)).toBeLessThan(250.1);
});

it('sends again what is lost', () => {
  const ways = waysOf({ delay: 10, loss: 0.01 });
  const late = ways.filter((way) => way > 10).length / ways.length;
  expect(Math.abs(late - 0.105)).toBeLessThan(0.02);
  expect(Math.abs(Math.max(...ways) - 210)).toBeLessThan(1);
});

it('is the same link for the same seed in every language', () => {
  const link = new NetworkSimulator({ delay: 40, jitter: 20, tail: 5, stalls: 100, stallEvery: 500, loss: 0.05, retransmit: 200, seed: 7 });
  let sum = 0;
  for (let k = 0; k < 1000; k++) sum += link.arrivalUs(k * 16_667) - k * 16_667;
  expect(sum).toBe(109_097_580); // tests/clients/cpp/core/network_simulator_test.cpp has the same number
});

it('is read from an address line', () => {
  const link = networkConditionsFromQuery('?world=yard&delay=80&jitter=20.5&stalls=250&stall_every=3000&seed=9')!;
  expect(link).toEqual({ ...IDEAL_NETWORK, delay: 80, jitter: 20.5, stalls: 250, stallEvery: 3000, seed: 9 });
  expect(networkConditionsFromQuery('?world=yard')).toBeUndefined();
  expect(networkConditionsFromQuery('?delay=-1&loss=2&jitter=much&tail=')).toBeUndefined();
});
