// Layout and initial state of the models of codec 2 (proto/WIRE.md, "Models"), as in
// proto/snapshot/include/jostle/snapshot/frame_models.h.

import type { Models } from './range_decoder.js';
import { COUNT, MAGNITUDE, TAIL } from './range_numbers.js';
import { INITIAL_MODELS } from './start_models.js';

export { COUNT, MAGNITUDE, TAIL } from './range_numbers.js';

let total = 0;
function take(models: number): number {
  total += models;
  return total - models;
}

export const CHANGES_ENTITIES = take(1);
export const REMOVED = take(COUNT);
export const REMOVED_GAP = take(COUNT);
export const SPAWNED = take(COUNT);
export const ID_GAP = take(COUNT);
export const POSITION_STEP = take(3 * COUNT);
export const POSITION_NEGATIVE = take(1);
export const TURNED = take(1);
export const SPAWNED_AT_REST = take(1);
export const NONE_WAKE = take(1);
export const RESTING_RUN = take(COUNT);
export const STAYS_AT_REST = take(1);
export const CHANGES = take(3);
export const FALLS_ASLEEP = take(3 * 2);
export const POSITION = take(4 * 2 * 7 * 3 * 4 * MAGNITUDE);
export const POSITION_TAIL = take(4 * TAIL);
export const SAME_LARGEST = take(4);
export const OTHER_LARGEST = take(2);
export const ROTATION = take(4 * 7 * 3 * 5 * MAGNITUDE);
export const ROTATION_TAIL = take(4 * TAIL);
export const MODEL_COUNT = total;

const ALPHABET = '0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+,-./:;<=>';
const LEVELS = [64, 64, 64, 89, 133, 198, 295, 439, 652, 968, 1434, 2117, 3108, 4531, 6537, 9296, 12964, 17625, 23222, 29502];
const TRAINED = 8;

/** The models of a table of letters. */
export function parseModels(letters: string, count = MODEL_COUNT): Models {
  const one = new Uint16Array(count);
  const updates = new Uint8Array(count);
  for (let i = 0; i < count; i++) {
    const index = ALPHABET.indexOf(letters[i]!);
    const level = index >> 1;
    one[i] = level < 20 ? LEVELS[level]! : 65536 - LEVELS[39 - level]!;
    updates[i] = index % 2 === 0 ? 0 : TRAINED;
  }
  return { one, updates };
}

const start = INITIAL_MODELS.map((letters) => parseModels(letters));
const working: Models = { one: new Uint16Array(MODEL_COUNT), updates: new Uint8Array(MODEL_COUNT) };

/** The initial models of a frame whose baseline is `baselineAge` ticks old. Valid until the next call. */
export function initialModels(baselineAge: number): Models {
  const { one, updates } = start[baselineAge > 2 ? 1 : 0]!;
  working.one.set(one);
  working.updates.set(updates);
  return working;
}
