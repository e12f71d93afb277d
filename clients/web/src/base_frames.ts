// Which earlier frames a snapshot is told against (WIRE.md, "A frame").

import { DecodeError } from './frame_state';

const NO_BASE = 255;

/** The numbers of base, base2 and base3, 0: none, of Snapshot.bases. */
export function baseFrames(frame: number, bases: number): [number, number, number] {
  const found: [number, number, number] = [0, 0, 0];
  if (bases === 0) return found;
  let distance = bases & 255;
  const second = (bases >>> 8) & 255;
  const third = bases >>> 16;
  if (distance === 0 || distance === NO_BASE || third > NO_BASE || (second === NO_BASE && third !== 0))
    throw new DecodeError(`frame ${frame}: bases ${bases} are no distances of 1 to 254`);
  let at = frame;
  for (const [k, told] of [distance, second, third].entries()) {
    if (told === NO_BASE) break;
    distance = told || distance;
    at -= distance;
    if (at <= 0) throw new DecodeError(`frame ${frame}: bases ${bases} lie before the first frame`);
    found[k] = at;
  }
  return found;
}
