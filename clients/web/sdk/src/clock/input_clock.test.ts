// Inputs of every tick, sent thirty times a second over a bad link to a server that tells their margin over another.
// tests/clients/cpp/core/input_clock_test.cpp tells the same.

import { expect, it } from 'vitest';
import { InputClock } from './input_clock.js';
import { IDEAL_NETWORK, NetworkSimulator, type NetworkConditions } from '../network_simulator/network_simulator.js';

const TICK_US = 1e6 / 60;

/** Tick n of the server is due at n / 60 s. Ours is another clock. */
class SteeredStream {
  readonly clock = new InputClock();
  addedWayUs = 0; // of the way up
  late = 0;
  told = 0;
  least = 1;
  greatest = 1;
  private us = 3_000_000;
  private nextBatchUs = this.us;
  private sequence = 0;
  private tick = 0;
  private unsent: { sequence: number; tick: number }[] = [];
  private readonly coming: { dueUs: number; sequence: number; marginUs: number }[] = [];
  private readonly up: NetworkSimulator;
  private readonly down: NetworkSimulator;

  constructor(settings: Partial<NetworkConditions>) {
    this.up = new NetworkSimulator({ ...IDEAL_NETWORK, ...settings });
    this.down = new NetworkSimulator({ ...IDEAL_NETWORK, ...settings });
    this.clock.begin(60);
  }

  /** In steps of a millisecond. */
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
      while (this.coming.length > 0 && this.coming[0]!.dueUs <= this.us) {
        const { sequence, marginUs } = this.coming.shift()!;
        clock.onMargin(sequence, marginUs);
      }
      this.least = Math.min(this.least, clock.speed);
      this.greatest = Math.max(this.greatest, clock.speed);
    }
  }

  private send(): void {
    this.nextBatchUs = this.us + 33_333;
    const arrival = this.up.arrivalUs(this.us) + this.addedWayUs;
    this.told += this.unsent.length;
    this.late += this.unsent.filter(({ tick }) => tick * TICK_US < arrival).length;
    const { sequence, tick } = this.unsent[this.unsent.length - 1]!;
    this.coming.push({ dueUs: this.down.arrivalUs(Math.floor(arrival)), sequence, marginUs: tick * TICK_US - arrival });
    this.clock.sent(sequence);
    this.unsent = [];
  }

  get off(): number {
    return Math.abs(this.clock.marginUs - this.clock.targetUs);
  }
}

it('settles within a tick of its target, and few inputs are late', () => {
  const stream = new SteeredStream({ delay: 50, jitter: 10 });
  stream.run(5, 50_000);
  stream.late = stream.told = 0;
  stream.run(60, 50_000);
  expect(stream.off).toBeLessThan(TICK_US);
  expect(stream.clock.targetUs, 'a tick and four times the jitter').toBeLessThan(45_000);
  expect(stream.late).toBeLessThan(0.01 * stream.told);
  expect(stream.clock.jumps).toBe(0);
});

it('walks to a longer way at 1.05 and back at 0.95', () => {
  const stream = new SteeredStream({ delay: 50 });
  stream.run(5, 50_000);
  stream.addedWayUs = 100_000; // six ticks, of which no ping tells
  stream.run(5, 50_000);
  expect(stream.off).toBeLessThan(TICK_US);
  stream.addedWayUs = 0;
  stream.run(5, 50_000);
  expect(stream.off).toBeLessThan(TICK_US);
  expect(stream.clock.jumps).toBe(0);
  expect(stream.least).toBe(0.95);
  expect(stream.greatest).toBe(1.05);
});

it('jumps once when it is more than ten ticks off', () => {
  const stream = new SteeredStream({ delay: 50 });
  stream.run(5, 50_000);
  stream.addedWayUs = 400_000;
  stream.run(5, 250_000);
  expect(stream.clock.jumps).toBe(1);
  expect(stream.off).toBeLessThan(TICK_US);
});

it('follows the frames when nothing is sent and the server lost ticks', () => {
  const clock = new InputClock();
  expect(clock.position(5)).toBe(0);
  clock.begin(60);
  clock.onFrame(100, 20_000, 50_000, 1e6);
  const ahead = (70_000 + clock.targetUs) / TICK_US;
  expect(clock.position(1e6)).toBeCloseTo(100 + ahead, 9);
  expect(clock.position(2e6)).toBeCloseTo(160 + ahead, 9);
  // A second later by ours, half by its ticks, and for two seconds nothing was told.
  for (let k = 0; k <= 120; k++) clock.onFrame(130, 20_000, 50_000, 2e6);
  expect(clock.position(2e6)).toBeCloseTo(130 + ahead, 9);
  expect(clock.jumps).toBe(1);
});
