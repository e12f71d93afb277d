// State of the cells in the area of interest, merged into one frame (WIRE.md, "Cells").

import { baselineFrames } from './baseline_frames.js';
import { DecodeError, decodeFrame, frameCrc, type EntityState, type QuantSpec, type QuantizedFrame } from './decode_frame.js';

/** A received cell (proto CellUpdate). */
export interface CellUpdate {
  readonly cell: number;
  readonly number: number;
  readonly baselines: number;
  readonly packed: Uint8Array;
  readonly crc: number;
}

const FRAME_HISTORY_MAX = 32;
const INTERVALS = 3;
const BLEND_TICKS_MAX = 12; // maximum extra render delay

/** An entity that is rendered between its last two states. */
export interface Blend {
  readonly from: EntityState;
  readonly t: number; // 0 at `from`, 1 at the newest state
  readonly ticks: number; // between the two states
}

export class InterestCells {
  private cells = new Map<number, QuantizedFrame[]>();
  private newest = 0; // tick of the newest snapshot
  private step = 1; // ticks between the last two snapshots

  /**
   * Applies cell updates and removals. Throws DecodeError for a malformed update and leaves the state
   * unchanged.
   */
  apply(updates: readonly CellUpdate[], removed: readonly number[], spec: QuantSpec, codec: number, frame = 0): void {
    const decoded = updates.map((update) => ({ cell: update.cell, state: this.decode(update, spec, codec) }));
    if (this.newest !== 0 && frame > this.newest) this.step = frame - this.newest;
    this.newest = frame;
    for (const cell of removed) this.cells.delete(cell);
    for (const { cell, state } of decoded) {
      let states = this.cells.get(cell) ?? [];
      // An update without baselines restarts the history.
      if (states.length > 0 && state.frame <= states[states.length - 1]!.frame) states = [];
      states.push(state);
      if (states.length > FRAME_HISTORY_MAX) states.shift();
      this.cells.set(cell, states);
    }
  }

  /**
   * All entities of the area of interest, ascending by id. An entity that changes cells may be in both:
   * the newer state counts.
   */
  frame(number: number): QuantizedFrame {
    const newest = new Map<number, { entity: EntityState; number: number }>();
    for (const states of this.cells.values()) {
      const state = states[states.length - 1]!;
      for (const entity of state.entities) {
        const known = newest.get(entity.id);
        if (!known || known.number < state.frame) newest.set(entity.id, { entity, number: state.frame });
      }
    }
    const entities = [...newest.values()].map((state) => state.entity).sort((a, b) => a.id - b.id);
    return { frame: number, entities };
  }

  /**
   * Entities that are rendered between two states when the newest snapshot is rendered. A cell with a
   * lower update rate is interpolated over its update interval and rendered later by it. All other
   * entities are where frame() has them.
   */
  blends(number: number): Map<number, Blend> {
    const blends = new Map<number, Blend>();
    for (const states of this.cells.values()) {
      const t = this.progress(states, number);
      if (t === 1) continue;
      const [previous, latest] = states.slice(-2) as [QuantizedFrame, QuantizedFrame];
      let from = 0;
      for (const { id } of latest.entities) {
        while (from < previous.entities.length && previous.entities[from]!.id < id) from++;
        const earlier = previous.entities[from];
        if (earlier?.id === id) blends.set(id, { from: earlier, t, ticks: latest.frame - previous.frame });
      }
    }
    return blends;
  }

  // Progress from the previous to the newest state. A cell without motion is updated rarely, so the
  // shortest of its recent intervals is its update interval.
  private progress(states: readonly QuantizedFrame[], number: number): number {
    const last = states.length - 1;
    if (last < 1) return 1;
    let interval = BLEND_TICKS_MAX;
    for (let k = last; k > 0 && k + INTERVALS > last; k--) interval = Math.min(interval, states[k]!.frame - states[k - 1]!.frame);
    const since = Math.max(0, number - states[last]!.frame);
    return interval <= this.step ? 1 : Math.min(1, (since + this.step) / interval);
  }

  clear(): void {
    this.cells.clear();
    this.newest = 0;
    this.step = 1;
  }

  private decode(update: CellUpdate, spec: QuantSpec, codec: number): QuantizedFrame {
    const known = this.cells.get(update.cell) ?? [];
    const name = `cell ${update.cell} of tick ${update.number}`;
    if (update.baselines !== 0 && known.length > 0 && update.number <= known[known.length - 1]!.frame)
      throw new DecodeError(`${name} is not newer than its last state`);
    const [baseline, baseline2, baseline3] = baselineFrames(update.number, update.baselines).map((number) => {
      const state = known.find((k) => k.frame === number);
      if (number !== 0 && !state) throw new DecodeError(`${name}: its state ${number} is unknown`);
      return state;
    });
    const state = decodeFrame(update.number, update.packed, { baseline, baseline2, baseline3 }, spec, undefined, codec);
    if (frameCrc(state) !== update.crc) throw new DecodeError(`${name}: CRC mismatch`);
    return state;
  }
}
