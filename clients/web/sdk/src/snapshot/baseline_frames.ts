// Which earlier frames a snapshot is told against (WIRE.md, "A frame").

import { DecodeError } from './frame_state.js';

const NO_BASE = 255;

/** The numbers of base, baseline2 and baseline3, 0: none, of Snapshot.bases. */
export function baselineFrames(frame: number, baselines: number): [number, number, number] {
  const found: [number, number, number] = [0, 0, 0];
  if (baselines === 0) return found;
  let distance = baselines & 255;
  const second = (baselines >>> 8) & 255;
  const third = baselines >>> 16;
  if (distance === 0 || distance === NO_BASE || third > NO_BASE || (second === NO_BASE && third !== 0))
    throw new DecodeError(`frame ${frame}: baselines ${baselines} are no distances of 1 to 254`);
  let at = frame;
  for (const [k, told] of [distance, second, third].entries()) {
    if (told === NO_BASE) break;
    distance = told || distance;
    at -= distance;
    if (at <= 0) throw new DecodeError(`frame ${frame}: baselines ${baselines} lie before the first frame`);
    found[k] = at;
  }
  return found;
}
