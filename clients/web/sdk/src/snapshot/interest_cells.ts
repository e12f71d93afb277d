// What a client that sees a part of its world knows of it: the last states of each cell, put together to one frame (WIRE.md, "Cells").

import { baselineFrames } from './baseline_frames.js';
import { DecodeError, decodeFrame, frameCrc, type EntityState, type QuantSpec, type QuantizedFrame } from './decode_frame.js';

/** A cell as it comes. */
export interface CellUpdate {
  readonly cell: number;
  readonly number: number;
  readonly baselines: number;
  readonly packed: Uint8Array;
  readonly crc: number;
}

const FRAME_HISTORY_MAX = 32;
const INTERVALS = 3;
const BLEND_TICKS_MAX = 12; // ticks: nobody is shown later than that

/** Of an entity that is on its way to where it was told to be. */
export interface Blend {
  readonly from: EntityState;
  readonly t: number; // from 0 there to 1
  readonly ticks: number; // from one to the other
}

export class InterestCells {
  private cells = new Map<number, QuantizedFrame[]>();
  private newest = 0; // snapshot
  private step = 1; // ticks from the one before

  /** Throws a DecodeError, and everything is as it was. */
  apply(parts: readonly CellUpdate[], left: readonly number[], spec: QuantSpec, codec: number, frame = 0): void {
    const fresh = parts.map((part) => ({ cell: part.cell, state: this.decode(part, spec, codec) }));
    if (this.newest !== 0 && frame > this.newest) this.step = frame - this.newest;
    this.newest = frame;
    for (const cell of left) this.cells.delete(cell);
    for (const { cell, state } of fresh) {
      let states = this.cells.get(cell) ?? [];
      // One that is told whole begins anew.
      if (states.length > 0 && state.frame <= states[states.length - 1]!.frame) states = [];
      states.push(state);
      if (states.length > FRAME_HISTORY_MAX) states.shift();
      this.cells.set(cell, states);
    }
  }

  /** All that is in sight, in rising order of id: of an entity that is in two cells, on its way from one to the other, the newer. */
  frame(number: number): QuantizedFrame {
    const newest = new Map<number, { entity: EntityState; number: number }>();
    for (const states of this.cells.values()) {
      const state = states[states.length - 1]!;
      for (const entity of state.entities) {
        const known = newest.get(entity.id);
        if (!known || known.number < state.frame) newest.set(entity.id, { entity, number: state.frame });
      }
    }
    const entities = [...newest.values()].map((seen) => seen.entity).sort((a, b) => a.id - b.id);
    return { frame: number, entities };
  }

  /**
   * For a picture of the newest snapshot: a cell that is told with some snapshots only moves on evenly from one telling to the next, and is
   * shown so much later. By entity, of those that are not where frame() has them.
   */
  blends(number: number): Map<number, Blend> {
    const blends = new Map<number, Blend>();
    for (const states of this.cells.values()) {
      const t = this.progress(states, number);
      if (t === 1) continue;
      const [before, now] = states.slice(-2) as [QuantizedFrame, QuantizedFrame];
      let from = 0;
      for (const { id } of now.entities) {
        while (from < before.entities.length && before.entities[from]!.id < id) from++;
        const was = before.entities[from];
        if (was?.id === id) blends.set(id, { from: was, t, ticks: now.frame - before.frame });
      }
    }
    return blends;
  }

  // How far on the way from the state before to the newest one a picture is. A cell in which nothing moved for a while is told as seldom
  // as it likes: its shortest interval of late is how often it is told.
  private progress(states: readonly QuantizedFrame[], number: number): number {
    const last = states.length - 1;
    if (last < 1) return 1;
    let shortest = BLEND_TICKS_MAX;
    for (let k = last; k > 0 && k + INTERVALS > last; k--) shortest = Math.min(shortest, states[k]!.frame - states[k - 1]!.frame);
    const since = Math.max(0, number - states[last]!.frame);
    return shortest <= this.step ? 1 : Math.min(1, (since + this.step) / shortest);
  }

  clear(): void {
    this.cells.clear();
    this.newest = 0;
    this.step = 1;
  }

  private decode(part: CellUpdate, spec: QuantSpec, codec: number): QuantizedFrame {
    const known = this.cells.get(part.cell) ?? [];
    const name = `cell ${part.cell} of tick ${part.number}`;
    if (part.baselines !== 0 && known.length > 0 && part.number <= known[known.length - 1]!.frame)
      throw new DecodeError(`${name} is not newer than the last one`);
    const [base, baseline2, baseline3] = baselineFrames(part.number, part.baselines).map((number) => {
      const state = known.find((k) => k.frame === number);
      if (number !== 0 && !state) throw new DecodeError(`${name}: its state ${number} is not known`);
      return state;
    });
    const state = decodeFrame(part.number, part.packed, { base, baseline2, baseline3 }, spec, undefined, codec);
    if (frameCrc(state) !== part.crc) throw new DecodeError(`${name}: the CRC does not match`);
    return state;
  }
}
