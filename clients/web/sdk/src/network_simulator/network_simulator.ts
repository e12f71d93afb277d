// A bad link, for tests and demonstrations: says when a message that is sent now arrives at the other end of a stream. Nothing is
// lost or overtaken, as on TCP: a lost message comes a retransmission later, and those behind it wait. The same seed gives the
// same link, here and in the C++ client library (jostle/client/network_simulator.h). One direction each.

export interface NetworkConditions {
  readonly delay: number; // ms, of every message
  readonly jitter: number; // ms on top, from 0 to this, each alike
  readonly tail: number; // ms on top, exponential with this mean
  readonly stalls: number; // ms, how long nothing arrives
  readonly stallEvery: number; // ms from the beginning of one stall to the next: 0.5 to 1.5 times
  readonly loss: number; // share of messages that are sent a second time, 0 to 1
  readonly retransmit: number; // ms: that much later
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

const NAMES: Record<string, [field: keyof NetworkConditions, most: number]> = {
  delay: ['delay', 60_000],
  jitter: ['jitter', 60_000],
  tail: ['tail', 60_000],
  stalls: ['stalls', 60_000],
  stall_every: ['stallEvery', 1e9],
  loss: ['loss', 1],
  retransmit: ['retransmit', 60_000],
  seed: ['seed', 2 ** 32 - 1],
};

/** From an address line: ?delay=80&jitter=20&stalls=250. What is out of range is left out; undefined: a good link. */
export function networkConditionsFromQuery(search: string): NetworkConditions | undefined {
  const settings: { -readonly [K in keyof NetworkConditions]: NetworkConditions[K] } = { ...IDEAL_NETWORK };
  for (const [name, text] of new URLSearchParams(search)) {
    const [field, most] = NAMES[name] ?? [];
    const value = Number(text);
    if (field && text !== '' && value >= 0 && value <= most!) settings[field] = value;
  }
  const { delay, jitter, tail, stalls, loss } = settings;
  return delay > 0 || jitter > 0 || tail > 0 || stalls > 0 || loss > 0 ? settings : undefined;
}

const usOf = (ms: number) => Math.round(1000 * ms);

export class NetworkSimulator {
  private random: number;
  private lastArrival = 0;
  private stall = 0; // begin of the next one, or of the one that is on
  private begun = false;

  constructor(private readonly settings: NetworkConditions) {
    this.random = settings.seed | 0;
  }

  /** When a message that is sent now arrives; times rise, in microseconds of any clock. */
  arrivalUs(sentUs: number): number {
    const { delay, jitter, tail, stalls, stallEvery, loss, retransmit } = this.settings;
    if (!this.begun) {
      this.begun = true;
      this.stall = sentUs + usOf(stallEvery * (0.5 + this.nextUniform()));
    }
    let way = delay;
    if (jitter > 0) way += jitter * this.nextUniform();
    if (tail > 0) way -= tail * Math.log(1 - this.nextUniform());
    if (loss > 0 && this.nextUniform() < loss) way += retransmit;
    let arrival = Math.max(sentUs + usOf(way), this.lastArrival);
    if (stalls > 0) arrival = this.skipStalls(arrival);
    return (this.lastArrival = arrival);
  }

  private skipStalls(arrival: number): number {
    const length = usOf(this.settings.stalls);
    // A stall begins after the one before has ended.
    while (arrival >= this.stall + length)
      this.stall += Math.max(usOf(this.settings.stallEvery * (0.5 + this.nextUniform())), length + 1000);
    return arrival >= this.stall ? this.stall + length : arrival;
  }

  /** Mulberry32 by Tommy Ettinger. 0 to 1, less than 1. */
  private nextUniform(): number {
    this.random = (this.random + 0x6d2b79f5) | 0;
    let t = Math.imul(this.random ^ (this.random >>> 15), this.random | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  }
}
