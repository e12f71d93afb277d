// A list of words as what changed in it since the list before, and what somebody drives, which is told so (proto/WIRE.md, "Driven things").

import type { ControlledEntityState } from '../gen/jostle/v1/play_pb.js';

const WORDS_MAX = 16 * 1024;
const NO_WORDS = new Uint32Array(0);

function bitCount(byte: number): number {
  let count = 0;
  for (let bits = byte; bits !== 0; bits &= bits - 1) count++;
  return count;
}

/** The list of `size` words; undefined: the bytes do not belong together. */
export function applyChanges(before: Uint32Array, size: number, changed: Uint8Array, values: Uint8Array): Uint32Array | undefined {
  if (size > WORDS_MAX || values.length !== 4 * changed.reduce((sum, byte) => sum + bitCount(byte), 0)) return undefined;
  const words = new Uint32Array(size);
  words.set(before.subarray(0, size));
  const told = new DataView(values.buffer, values.byteOffset, values.length);
  let at = 0;
  for (let k = 0; k < 8 * changed.length; k++) {
    if (((changed[k >> 3]! >> (k & 7)) & 1) === 0) continue;
    if (k >= size) return undefined;
    words[k] = told.getUint32(at, true);
    at += 4;
  }
  return words;
}

export interface ControlledEntity {
  readonly entity: number;
  readonly tick: number;
  readonly module: string;
  readonly words: Uint32Array;
}

/** What this client drives, as it was told last. */
export class ControlledStateDecoder {
  /** undefined: nothing was told, or not all of it. */
  newest: ControlledEntity | undefined;

  apply({ entity, tick, module, words: size, keyframe, changedMask, values }: ControlledEntityState): void {
    const before = keyframe ? NO_WORDS : this.newest?.entity === entity ? this.newest.words : undefined;
    const words = before && applyChanges(before, size, changedMask, values);
    this.newest = words && { entity, tick, module, words };
  }

  forget(): void {
    this.newest = undefined;
  }
}
