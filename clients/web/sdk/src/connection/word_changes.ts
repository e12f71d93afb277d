// A list of words, delta-encoded against the previous list, and the state of the controlled entity,
// which is sent in this form (proto/WIRE.md).

import type { ControlledEntityState } from '../gen/jostle/v1/play_pb.js';

const WORDS_MAX = 16 * 1024;
const NO_WORDS = new Uint32Array(0);

function bitCount(byte: number): number {
  let count = 0;
  for (let bits = byte; bits !== 0; bits &= bits - 1) count++;
  return count;
}

/** The list of `size` words; undefined if the arguments are inconsistent. */
export function applyChanges(previous: Uint32Array, size: number, changed: Uint8Array, values: Uint8Array): Uint32Array | undefined {
  if (size > WORDS_MAX || values.length !== 4 * changed.reduce((sum, byte) => sum + bitCount(byte), 0)) return undefined;
  const words = new Uint32Array(size);
  words.set(previous.subarray(0, size));
  const view = new DataView(values.buffer, values.byteOffset, values.length);
  let at = 0;
  for (let k = 0; k < 8 * changed.length; k++) {
    if (((changed[k >> 3]! >> (k & 7)) & 1) === 0) continue;
    if (k >= size) return undefined;
    words[k] = view.getUint32(at, true);
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

/** Decodes the state of the entity that this client controls. */
export class ControlledStateDecoder {
  /** undefined: none was received, or not completely. */
  newest: ControlledEntity | undefined;

  apply({ entity, tick, module, words: size, keyframe, changedMask, values }: ControlledEntityState): void {
    const previous = keyframe ? NO_WORDS : this.newest?.entity === entity ? this.newest.words : undefined;
    const words = previous && applyChanges(previous, size, changedMask, values);
    this.newest = words && { entity, tick, module, words };
  }

  reset(): void {
    this.newest = undefined;
  }
}
