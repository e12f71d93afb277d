// The received states of one point object (proto/WIRE.md, "Points"): baselines of later states, and
// points to render.

import { DecodeError } from './frame_state.js';
import { decodePoints, NO_POINT, type PointState } from './point_codec.js';
import { checkLayout, PointForm, pointOrder, type PointLayout, type PointLevel } from './point_layout.js';

/** Stored states. The last three are baselines; the others are for rendering. */
export const POINT_STATES_MAX = 8;
const BASELINES_MAX = 3;

export interface KnownPoints {
  readonly points: PointState;
  /** Tick in which the object had this state. */
  readonly tick: number;
}

/** A received state (proto PointUpdate). */
export interface PointStateUpdate {
  readonly number: number;
  readonly back: number;
  readonly tick: number;
  readonly packed: Uint8Array;
  readonly crc: number;
}

export class PointHistory {
  private readonly order: readonly PointLevel[];
  private known: KnownPoints[] = [];
  private usable = 0; // newest states that can be baselines

  /** Throws DecodeError if the layout is invalid. */
  constructor(readonly layout: PointLayout) {
    checkLayout(layout);
    this.order = layout.form === PointForm.Loose ? [] : pointOrder(layout);
  }

  /** The oldest state first; PointState.previous of each refers to the one before it. */
  get states(): readonly KnownPoints[] {
    return this.known;
  }

  /**
   * Adds a state. Throws DecodeError if its baseline is not the newest stored state or if it is malformed;
   * nothing changes then.
   */
  add({ number, back, tick, packed, crc }: PointStateUpdate): void {
    const newest = this.usable > 0 ? this.known[this.known.length - 1]! : undefined;
    if (back !== 0 && newest?.points.number !== number - (back - 1))
      throw new DecodeError(`points: state ${number} is based on state ${number - back + 1}; the newest known one is ${newest?.points.number ?? 0}`);
    const refines = back === 1;
    const baselines = this.known.slice(this.known.length - this.usable).reverse();
    const available = back === 0 ? [] : refines ? baselines.slice(0, 1) : baselines;
    const points = decodePoints(this.layout, this.order, number, packed, crc, available.map((state) => state.points));
    if (refines) return this.refine(points);
    if (back === 0) this.known = [];
    this.known.push({ points, tick });
    if (this.known.length > POINT_STATES_MAX) this.known.shift();
    this.usable = back === 0 ? 1 : Math.min(this.usable + 1, BASELINES_MAX);
  }

  /**
   * A loose point of the refined state may be new although an earlier state has it, so the earlier states
   * are no longer baselines.
   */
  private refine(points: PointState): void {
    const coarse = this.known[this.known.length - 1]!;
    const previous = points.previous.map((index) => (index === NO_POINT ? NO_POINT : coarse.points.previous[index]!));
    this.known[this.known.length - 1] = { points: { ...points, previous }, tick: coarse.tick };
    this.usable = 1;
  }
}
