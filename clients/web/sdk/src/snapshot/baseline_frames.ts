// Baselines of a snapshot: the earlier frames that it is encoded against (WIRE.md, "Frame
// encoding").

import { DecodeError } from './frame_state.js';

const NO_BASELINE = 255;

/**
 * Frame numbers of baseline, baseline2 and baseline3 (0: none) from Snapshot.baselines. Throws
 * DecodeError.
 */
export function baselineFrames(frame: number, baselines: number): [number, number, number] {
  const numbers: [number, number, number] = [0, 0, 0];
  if (baselines === 0) return numbers;
  let distance = baselines & 255;
  const second = (baselines >>> 8) & 255;
  const third = baselines >>> 16;
  if (distance === 0 || distance === NO_BASELINE || third > NO_BASELINE || (second === NO_BASELINE && third !== 0))
    throw new DecodeError(`frame ${frame}: invalid baselines ${baselines}: distances must be 1 to 254`);
  let current = frame;
  for (const [k, entry] of [distance, second, third].entries()) {
    if (entry === NO_BASELINE) break;
    distance = entry || distance;
    current -= distance;
    if (current <= 0) throw new DecodeError(`frame ${frame}: baselines ${baselines} are before the first frame`);
    numbers[k] = current;
  }
  return numbers;
}
