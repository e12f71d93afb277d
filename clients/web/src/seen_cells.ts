// What a client that sees a part of its world knows of it: the last states of each cell, put together to one frame (WIRE.md, "Cells").

import { baseFrames } from './base_frames';
import { DecodeError, decodeFrame, frameCrc, type EntityState, type QuantSpec, type QuantizedFrame } from './decode_frame';

/** A cell as it comes. */
export interface CellPart {
  readonly cell: number;
  readonly number: number;
  readonly bases: number;
  readonly packed: Uint8Array;
  readonly crc: number;
}

const RING = 32;

export class SeenCells {
  private cells = new Map<number, QuantizedFrame[]>();

  /** Throws a DecodeError, and everything is as it was. */
  apply(parts: readonly CellPart[], left: readonly number[], spec: QuantSpec, codec: number): void {
    const fresh = parts.map((part) => ({ cell: part.cell, state: this.decode(part, spec, codec) }));
    for (const cell of left) this.cells.delete(cell);
    for (const { cell, state } of fresh) {
      let states = this.cells.get(cell) ?? [];
      // One that is told whole begins anew.
      if (states.length > 0 && state.frame <= states[states.length - 1]!.frame) states = [];
      states.push(state);
      if (states.length > RING) states.shift();
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

  clear(): void {
    this.cells.clear();
  }

  private decode(part: CellPart, spec: QuantSpec, codec: number): QuantizedFrame {
    const known = this.cells.get(part.cell) ?? [];
    const name = `cell ${part.cell} of tick ${part.number}`;
    if (part.bases !== 0 && known.length > 0 && part.number <= known[known.length - 1]!.frame)
      throw new DecodeError(`${name} is not newer than the last one`);
    const [base, base2, base3] = baseFrames(part.number, part.bases).map((number) => {
      const state = known.find((k) => k.frame === number);
      if (number !== 0 && !state) throw new DecodeError(`${name}: its state ${number} is not known`);
      return state;
    });
    const state = decodeFrame(part.number, part.packed, { base, base2, base3 }, spec, undefined, codec);
    if (frameCrc(state) !== part.crc) throw new DecodeError(`${name}: the CRC does not match`);
    return state;
  }
}
