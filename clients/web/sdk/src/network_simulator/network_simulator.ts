// Simulates network conditions for tests and demonstrations: when a message sent now arrives at the
// other end of a stream. As on TCP, nothing is lost or reordered: a lost message arrives one
// retransmission later and delays those behind it. Deterministic per seed, and identical to
// base/include/jostle/base/network_simulator.h. One instance per direction.

export interface NetworkConditions {
  readonly delay: number; // ms, of every message
  readonly jitter: number; // ms, added, uniform from 0
  readonly tail: number; // ms, added, exponential with this mean
  readonly stalls: number; // ms, duration of a stall
  readonly stallEvery: number; // ms, between the starts of two stalls: 0.5 to 1.5 times
  readonly loss: number; // fraction of messages that are retransmitted, 0 to 1
  readonly retransmit: number; // ms, delay of a retransmission
  readonly seed: number;
}

export const IDEAL_NETWORK: NetworkConditions = {
  delay: 0,
  jitter: 0,
  tail: 0,
  stalls: 0,
  stallEvery: 5000,
  loss: 0,
  retransmit: 200,
  seed: 1,
};

const toUs = (ms: number) => Math.round(1000 * ms);

export class NetworkSimulator {
  private random: number;
  private lastArrival = 0;
  private stall = 0; // start of the next or current stall
  private started = false;

  constructor(private readonly conditions: NetworkConditions) {
    this.random = conditions.seed | 0;
  }

  /** When a message sent now arrives, in microseconds of any clock; `sentUs` must not decrease. */
  arrivalUs(sentUs: number): number {
    const { delay, jitter, tail, stalls, stallEvery, loss, retransmit } = this.conditions;
    if (!this.started) {
      this.started = true;
      this.stall = sentUs + toUs(stallEvery * (0.5 + this.nextUniform()));
    }
    let latencyMs = delay;
    if (jitter > 0) latencyMs += jitter * this.nextUniform();
    if (tail > 0) latencyMs -= tail * Math.log(1 - this.nextUniform());
    if (loss > 0 && this.nextUniform() < loss) latencyMs += retransmit;
    let arrival = Math.max(sentUs + toUs(latencyMs), this.lastArrival);
    if (stalls > 0) arrival = this.skipStalls(arrival);
    return (this.lastArrival = arrival);
  }

  private skipStalls(arrival: number): number {
    const length = toUs(this.conditions.stalls);
    // A stall starts after the previous one has ended.
    while (arrival >= this.stall + length)
      this.stall += Math.max(toUs(this.conditions.stallEvery * (0.5 + this.nextUniform())), length + 1000);
    return arrival >= this.stall ? this.stall + length : arrival;
  }

  /** Mulberry32 by Tommy Ettinger: 0 <= x < 1. */
  private nextUniform(): number {
    this.random = (this.random + 0x6d2b79f5) | 0;
    let t = Math.imul(this.random ^ (this.random >>> 15), this.random | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  }
}
