// Simulates network conditions for tests and demonstrations: when a message sent now arrives at the
// other end. As on TCP, messages of a stream are never lost or reordered: a lost message arrives one
// retransmission later and delays those behind it. Datagrams can be lost, duplicated and reordered.
// Deterministic per seed, and identical to base/include/jostle/base/network_simulator.h. One
// instance per direction.

export interface NetworkConditions {
  readonly latencyMs: number; // of every message
  readonly jitterMs: number; // added, uniform from 0
  readonly jitterTailMs: number; // added, exponential with this mean
  readonly stallMs: number; // duration of a stall, during which nothing arrives
  readonly stallIntervalMs: number; // mean, between the starts of two stalls; the actual one is 0.5 to 1.5 times this value
  readonly loss: number; // fraction of messages, 0 to 1: retransmitted in a stream, dropped as datagrams
  readonly lossBurst: number; // mean number of consecutive losses; 1: independent
  readonly retransmitMs: number; // delay of a retransmission
  readonly duplicate: number; // fraction of datagrams that arrive twice, 0 to 1
  readonly reorder: number; // fraction of datagrams that later ones can overtake, 0 to 1
  readonly reorderMs: number; // added to such a datagram
  readonly rateKbps: number; // bandwidth, kbit/s; 0: unlimited
  readonly seed: number;
}

export const IDEAL_NETWORK: NetworkConditions = {
  latencyMs: 0,
  jitterMs: 0,
  jitterTailMs: 0,
  stallMs: 0,
  stallIntervalMs: 5000,
  loss: 0,
  lossBurst: 1,
  retransmitMs: 200,
  duplicate: 0,
  reorder: 0,
  reorderMs: 20,
  rateKbps: 0,
  seed: 1,
};

/** Whether any setting delays, drops, duplicates or reorders messages. */
export function isImpaired(conditions: NetworkConditions): boolean {
  const { latencyMs, jitterMs, jitterTailMs, stallMs, loss, duplicate, reorder, rateKbps } = conditions;
  return [latencyMs, jitterMs, jitterTailMs, stallMs, loss, duplicate, reorder, rateKbps].some((value) => value > 0);
}

export type Delivery = 'stream' | 'datagrams';

export interface Transit {
  readonly copies: number; // 0: lost, 2: duplicated; 1 on a stream
  readonly arrivalUs: number; // of all copies
}

const toUs = (ms: number) => Math.round(1000 * ms);

export class NetworkSimulator {
  private random: number;
  private lastArrival = 0;
  private stall = 0; // start of the next or current stall
  private free = 0; // when the previous message has been transmitted
  private started = false;
  private previousLost = false;

  /** Simulators with different `path` numbers have different random sequences. */
  constructor(
    private readonly conditions: NetworkConditions,
    path = 0,
    private readonly delivery: Delivery = 'stream',
  ) {
    this.random = conditions.seed ^ Math.imul(0x9e3779b9, path);
  }

  /** Sends a message now, in microseconds of any clock; `sentUs` must not decrease. */
  send(sentUs: number, bytes = 0): Transit {
    const { stallIntervalMs, retransmitMs, duplicate, reorder, reorderMs } = this.conditions;
    if (!this.started) {
      this.started = true;
      this.stall = sentUs + toUs(stallIntervalMs * (0.5 + this.nextUniform()));
    }
    const departs = this.departure(sentUs, bytes);
    let transitMs = this.nextTransitMs();
    const lost = this.nextLost();
    if (lost && this.delivery === 'datagrams') return { copies: 0, arrivalUs: 0 };
    if (lost) transitMs += retransmitMs;
    this.lastArrival = this.skipStalls(Math.max(departs + toUs(transitMs), this.lastArrival));
    if (this.delivery === 'stream') return { copies: 1, arrivalUs: this.lastArrival };
    const copies = duplicate > 0 && this.nextUniform() < duplicate ? 2 : 1;
    const overtaken = reorder > 0 && this.nextUniform() < reorder;
    return { copies, arrivalUs: this.lastArrival + (overtaken ? toUs(reorderMs) : 0) };
  }

  private departure(sentUs: number, bytes: number): number {
    const { rateKbps } = this.conditions;
    if (!(rateKbps > 0)) return sentUs;
    this.free = Math.max(this.free, sentUs) + (8000 * bytes) / rateKbps;
    return Math.round(this.free);
  }

  private nextTransitMs(): number {
    const { latencyMs, jitterMs, jitterTailMs } = this.conditions;
    let transitMs = latencyMs;
    if (jitterMs > 0) transitMs += jitterMs * this.nextUniform();
    if (jitterTailMs > 0) transitMs -= jitterTailMs * Math.log(1 - this.nextUniform());
    return transitMs;
  }

  /** Bursts are a two-state Markov chain (E. N. Gilbert, 1960). */
  private nextLost(): boolean {
    const { loss, lossBurst } = this.conditions;
    if (!(loss > 0)) return false;
    let probability = loss;
    if (lossBurst > 1 && loss < 1) probability = this.previousLost ? 1 - 1 / lossBurst : loss / (lossBurst * (1 - loss));
    return (this.previousLost = this.nextUniform() < probability);
  }

  private skipStalls(arrival: number): number {
    const { stallMs, stallIntervalMs } = this.conditions;
    if (!(stallMs > 0)) return arrival;
    const length = toUs(stallMs);
    // A stall starts after the previous one has ended.
    while (arrival >= this.stall + length) this.stall += Math.max(toUs(stallIntervalMs * (0.5 + this.nextUniform())), length + 1000);
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
