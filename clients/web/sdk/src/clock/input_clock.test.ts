// Inputs of every tick, sent thirty times per second over a simulated network to a server that reports
// their margins over another one. Same cases as tests/clients/cpp/core/input_clock_test.cpp.

import { expect, it } from 'vitest';
import { InputClock } from './input_clock.js';
import { IDEAL_NETWORK, NetworkSimulator, type NetworkConditions } from '../network_simulator/network_simulator.js';

const TICK_US = 1e6 / 60;

/** Tick n of the server is due at n / 60 s; the local clock differs. */
class SteeredStream {
  readonly clock = new InputClock();
  addedLatencyUs = 0; // added to the latency towards the server
  late = 0;
  sentCount = 0;
  least = 1;
  greatest = 1;
  private us = 3_000_000;
  batchPeriodUs = 33_333;
  private nextBatchUs = this.us;
  private sequence = 0;
  private tick = 0;
  private unsent: { sequence: number; tick: number }[] = [];
  private readonly downstream: { dueUs: number; sequence: number; marginUs: number }[] = [];
  private readonly up: NetworkSimulator;
  private readonly down: NetworkSimulator;

  constructor(conditions: Partial<NetworkConditions>) {
    this.up = new NetworkSimulator({ ...IDEAL_NETWORK, ...conditions });
    this.down = new NetworkSimulator({ ...IDEAL_NETWORK, ...conditions });
    this.clock.begin(60);
  }

  /** In steps of 1 ms. */
  run(seconds: number, oneWayUs: number): void {
    const { clock } = this;
    for (const end = this.us + seconds * 1e6; this.us < end; this.us += 1000) {
      if (this.us % 16_000 === 0) {
        const now = Math.floor(this.us / TICK_US) - 4;
        clock.onFrame(now, this.us - now * TICK_US, oneWayUs, this.us);
      }
      if (clock.tick(this.us) > this.tick)
        this.unsent.push({ sequence: ++this.sequence, tick: (this.tick = clock.tick(this.us)) });
      if (this.us >= this.nextBatchUs && this.unsent.length > 0) this.send();
      while (this.downstream.length > 0 && this.downstream[0]!.dueUs <= this.us) {
        const { sequence, marginUs } = this.downstream.shift()!;
        clock.onMargin(sequence, marginUs);
      }
      this.least = Math.min(this.least, clock.speed);
      this.greatest = Math.max(this.greatest, clock.speed);
    }
  }

  private send(): void {
    this.nextBatchUs = this.us + this.batchPeriodUs;
    const arrival = this.up.send(this.us).arrivalUs + this.addedLatencyUs;
    this.sentCount += this.unsent.length;
    this.late += this.unsent.filter(({ tick }) => tick * TICK_US < arrival).length;
    const { sequence, tick } = this.unsent[this.unsent.length - 1]!;
    this.downstream.push({ dueUs: this.down.send(Math.floor(arrival)).arrivalUs, sequence, marginUs: tick * TICK_US - arrival });
    this.clock.sent(sequence);
    this.unsent = [];
  }

  get marginErrorUs(): number {
    return Math.abs(this.clock.marginUs - this.clock.targetUs);
  }
}

it('converges within one tick of its target with few late inputs', () => {
  const stream = new SteeredStream({ latencyMs: 50, jitterMs: 10 });
  stream.run(5, 50_000);
  stream.late = stream.sentCount = 0;
  stream.run(60, 50_000);
  expect(stream.marginErrorUs).toBeLessThan(TICK_US);
  expect(stream.clock.targetUs, 'a tick and four times the jitter').toBeLessThan(45_000);
  expect(stream.late).toBeLessThan(0.01 * stream.sentCount);
  expect(stream.clock.jumps).toBe(0);
});

// The first estimate of the jitter is 4 ms, so that the clock begins 33 ms ahead.
it('has a margin of one tick plus four times the jitter on loopback', () => {
  const stream = new SteeredStream({ latencyMs: 0.1 });
  stream.batchPeriodUs = 0; // timed inputs are sent at once
  stream.run(5, 100);
  stream.late = stream.sentCount = 0;
  stream.run(20, 100);
  expect(stream.clock.targetUs).toBeLessThan(22_000);
  expect(stream.marginErrorUs).toBeLessThan(TICK_US / 4 + 500);
  expect(stream.late).toBe(0);
  expect(stream.clock.jumps).toBe(0);
});

it('adapts to a longer latency at 1.05 and back at 0.95 speed', () => {
  const stream = new SteeredStream({ latencyMs: 50 });
  stream.run(5, 50_000);
  stream.addedLatencyUs = 100_000; // six ticks, which no ping measures
  stream.run(5, 50_000);
  expect(stream.marginErrorUs).toBeLessThan(TICK_US);
  stream.addedLatencyUs = 0;
  stream.run(5, 50_000);
  expect(stream.marginErrorUs).toBeLessThan(TICK_US);
  expect(stream.clock.jumps).toBe(0);
  expect(stream.least).toBe(0.95);
  expect(stream.greatest).toBe(1.05);
});

it('jumps once when more than ten ticks off', () => {
  const stream = new SteeredStream({ latencyMs: 50 });
  stream.run(5, 50_000);
  stream.addedLatencyUs = 400_000;
  stream.run(5, 250_000);
  expect(stream.clock.jumps).toBe(1);
  expect(stream.marginErrorUs).toBeLessThan(TICK_US);
});

it('follows frames without inputs after the server skips ticks', () => {
  const clock = new InputClock();
  expect(clock.position(5)).toBe(0);
  clock.begin(60);
  clock.onFrame(100, 20_000, 50_000, 1e6);
  const leadTicks = (70_000 + clock.targetUs) / TICK_US;
  expect(clock.position(1e6)).toBeCloseTo(100 + leadTicks, 9);
  expect(clock.position(2e6)).toBeCloseTo(160 + leadTicks, 9);
  // One second later on the local clock, half a second by ticks, and no margin for two seconds.
  for (let k = 0; k <= 120; k++) clock.onFrame(130, 20_000, 50_000, 2e6);
  expect(clock.position(2e6)).toBeCloseTo(130 + leadTicks, 9);
  expect(clock.jumps).toBe(1);
});
