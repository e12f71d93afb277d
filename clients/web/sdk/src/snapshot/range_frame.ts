// Decodes frames of codec 2, as proto/snapshot/include/jostle/snapshot/range_frame_serializer.h;
// written from proto/WIRE.md.

import { bitWidth } from './bit_reader.js';
import * as M from './frame_models.js';
import {
  DecodeError,
  Finder,
  INT32_MAX,
  INT32_MIN,
  isRotation,
  merge,
  samePose,
  survivorsOf,
  type Baselines,
  type EntityState,
  type QuantSpec,
  type Spacing,
  type Survivor,
  type Three,
} from './frame_state.js';
import { predict, type Prediction } from './predict.js';
import { RangeDecoder } from './range_decoder.js';
import { readCount, readNumber } from './range_numbers.js';

const MOTIONLESS = 0;
const MOVING = 1;
const STOPPED = 2;

function motionClassOf(s: Survivor): number {
  if (!s.b2 || s.b2.atRest || !samePose(s.b1, s.b2)) return MOVING;
  return s.b3 && samePose(s.b1, s.b3) ? MOTIONLESS : STOPPED;
}

const width = (v: number, most: number) => Math.min(bitWidth(Math.abs(v)), most);

/** Classes: -4 and below, -3 and -2, -1, 0, 1, 2 and 3, 4 and above. */
function signedClass(v: number): number {
  if (v < 0) return v <= -4 ? 0 : v <= -2 ? 1 : 2;
  return v >= 4 ? 6 : v >= 2 ? 5 : v === 1 ? 4 : 3;
}

function sizeClass(v: number): number {
  return v === 0 ? 0 : v <= 3 ? 1 : 2;
}

// Reused between calls to avoid garbage for thousands of bodies at 60 Hz.
const r: Three = [0, 0, 0];
const step: Three = [0, 0, 0];
const acceleration: Three = [0, 0, 0];

const NO_ENTITY: EntityState = { id: 0, position: [0, 0, 0], largest: 3, rotation: [0, 0, 0], atRest: false };

export class RangeFrameReader {
  private in!: RangeDecoder;

  constructor(
    private readonly packed: Uint8Array,
    private readonly spec: QuantSpec,
  ) {}

  decode(baselines: Baselines, t: Spacing, maxEntities: number): EntityState[] {
    this.in = new RangeDecoder(this.packed, M.initialModels(t.dt1));
    const baselineSize = baselines.baseline?.entities.length ?? 0;
    const changes = this.in.bit(M.CHANGES_ENTITIES);
    const removed = changes ? this.readRemoved(baselineSize) : new Set<number>();
    const limit = maxEntities - (baselineSize - removed.size);
    if (limit < 0) this.fail('more entities than the limit');
    const spawned = changes ? this.readSpawned(baselines, limit) : [];
    const updated = this.readSurvivors(survivorsOf(baselines, removed), t);
    this.checkEnd();
    if (!this.in.atCleanEnd) this.fail('unexpected bytes at the end');
    return merge(updated, spawned);
  }

  private fail(what: string): never {
    throw new DecodeError(`${what} (at byte ${this.in.position})`);
  }

  private checkEnd(): void {
    if (this.in.pastEnd) this.fail('truncated data');
  }

  private count(models: number): number {
    return readCount(this.in, models);
  }

  private number(models: number, tail: number): number {
    return readNumber(this.in, models, tail);
  }

  // ---- removed and spawned entities ----

  private readRemoved(size: number): Set<number> {
    const total = this.count(M.REMOVED);
    if (total > size) this.fail(`removed: count ${total} exceeds ${size}`);
    const positions = new Set<number>();
    let next = 0;
    for (let i = 0; i < total; i++) {
      const position = next + this.count(M.REMOVED_GAP);
      if (position >= size) this.fail('removed: index out of range');
      positions.add(position);
      next = position + 1;
    }
    this.checkEnd();
    return positions;
  }

  private readSpawned(baselines: Baselines, limit: number): EntityState[] {
    const total = this.count(M.SPAWNED);
    if (total > limit) this.fail('spawned: more entities than the limit');
    const known = new Finder(baselines.baseline);
    const out: EntityState[] = [];
    let previous = NO_ENTITY;
    for (let i = 0; i < total; i++) {
      previous = this.readSpawnedEntity(previous);
      this.checkEnd();
      if (known.find(previous.id)) this.fail('spawned: id is already in the baseline');
      out.push(previous);
    }
    return out;
  }

  private readSpawnedEntity(previous: EntityState): EntityState {
    const id = previous.id + 1 + this.count(M.ID_GAP);
    if (id > 0xffffffff) this.fail('spawned: id exceeds 32 bits');
    const position: Three = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const size = this.count(M.POSITION_STEP + k * M.COUNT);
      const negative = size !== 0 && this.in.bit(M.POSITION_NEGATIVE);
      position[k] = this.int32(previous.position[k]! + (negative ? -size : size), 'spawned: position');
    }
    let { largest, rotation } = previous;
    if (this.in.bit(M.TURNED)) ({ largest, rotation } = this.readComponents());
    return { id, position, largest, rotation, atRest: this.in.bit(M.SPAWNED_AT_REST) };
  }

  private readComponents(): { largest: number; rotation: Three } {
    const largest = this.in.raw(2);
    const bits = bitWidth(this.spec.rotationComponent) + 1;
    const rotation: Three = [0, 0, 0];
    for (let k = 0; k < 3; k++) rotation[k] = this.in.raw(bits) - 2 ** (bits - 1);
    this.checkRotation(rotation);
    return { largest, rotation };
  }

  private checkRotation(rotation: readonly number[]): void {
    if (!isRotation(rotation, this.spec.rotationComponent)) this.fail('invalid rotation');
  }

  private int32(v: number, what: string): number {
    if (v < INT32_MIN || v > INT32_MAX) this.fail(`${what} out of range`);
    return v;
  }

  // ---- surviving entities ----

  private readSurvivors(survivors: Survivor[], t: Spacing): EntityState[] {
    const out: EntityState[] = [];
    let resting = 0;
    for (const s of survivors) if (s.b1.atRest) resting++;
    let run = this.restingRun(resting);
    for (const s of survivors) {
      if (!s.b1.atRest) {
        out.push(this.readAwake(s, t));
        continue;
      }
      resting--;
      if (run > 0) {
        run--;
        out.push(s.b1);
        continue;
      }
      const atRest = this.in.bit(M.STAYS_AT_REST);
      out.push(this.readPose(s, t, atRest));
      run = this.restingRun(resting);
    }
    return out;
  }

  /** Number of resting entities that are unchanged before the next changed one, of `left` remaining. */
  private restingRun(left: number): number {
    if (left === 0) return 0;
    if (this.in.bit(M.NONE_WAKE)) return left;
    const run = this.count(M.RESTING_RUN);
    if (run >= left) this.fail('run of resting entities exceeds the frame');
    this.checkEnd();
    return run;
  }

  private readAwake(s: Survivor, t: Spacing): EntityState {
    const motionClass = motionClassOf(s);
    const changed = this.in.bit(M.CHANGES + motionClass);
    const atRest = this.in.bit(M.FALLS_ASLEEP + 2 * motionClass + (changed ? 1 : 0));
    if (changed) return this.readPose(s, t, atRest);
    return atRest ? { ...s.b1, atRest } : s.b1;
  }

  private readPose(s: Survivor, t: Spacing, atRest: boolean): EntityState {
    const p = predict(s, t, this.spec.rotationComponent);
    const position: Three = [0, 0, 0];
    let off = 0; // sum of the magnitudes so far
    for (let k = 0; k < 3; k++) {
      const d = p.positionStep[k]!;
      const dd = p.positionAcceleration[k]!;
      const mirrored = (d !== 0 ? d : dd) < 0;
      const bitCount = width(d, 3);
      const others = sizeClass(p.positionChange - Math.abs(dd));
      const previous = k === 0 ? 0 : 1 + (width(off, 4) >> 1);
      const context = (((bitCount * 2 + (k === 1 ? 1 : 0)) * 7 + signedClass(mirrored ? -dd : dd)) * 3 + others) * 4 + previous;
      const residual = this.number(M.POSITION + context * M.MAGNITUDE, M.POSITION_TAIL + bitCount * M.TAIL);
      position[k] = this.int32(p.position[k]! + (mirrored ? -residual : residual), 'position');
      off += Math.abs(residual);
    }
    const largest = this.readLargest(p);
    const rotation = this.readRotation(p, largest, off !== 0);
    this.checkEnd();
    return { id: s.b1.id, position, largest, rotation, atRest };
  }

  /** The omitted component: mostly the predicted one, less likely the smaller its lead. */
  private readLargest(p: Prediction): number {
    let second = 0;
    for (let k = 0; k < 4; k++) if (k !== p.largest) second = Math.max(second, Math.abs(p.rotation[k]!));
    const lead = width(Math.abs(p.rotation[p.largest]!) - second, 15) >> 2;
    if (this.in.bit(M.SAME_LARGEST + lead)) return p.largest;
    let on = 2;
    if (!this.in.bit(M.OTHER_LARGEST)) on = this.in.bit(M.OTHER_LARGEST + 1) ? 1 : 0;
    return (p.largest + 1 + on) & 3;
  }

  private readRotation(p: Prediction, largest: number, movedOff: boolean): Three {
    const sign = p.rotation[largest]! < 0 ? -1 : 1;
    let to = 0;
    let change = 0;
    for (let k = 0; k < 4; k++) {
      if (k === largest) continue;
      r[to] = sign * p.rotation[k]!;
      step[to] = sign * p.rotationStep[k]!;
      acceleration[to] = sign * p.rotationAcceleration[k]!;
      change += Math.abs(acceleration[to++]!);
    }
    const rotation: Three = [0, 0, 0];
    let off = 0;
    for (let k = 0; k < 3; k++) {
      const d = step[k]!;
      const dd = acceleration[k]!;
      const mirrored = (d !== 0 ? d : dd) < 0;
      const bitCount = width(d, 3);
      const previous = k === 0 ? (movedOff ? 1 : 0) : 2 + width(off, 2);
      const context = ((bitCount * 7 + signedClass(mirrored ? -dd : dd)) * 3 + sizeClass(change - Math.abs(dd))) * 5 + previous;
      const residual = this.number(M.ROTATION + context * M.MAGNITUDE, M.ROTATION_TAIL + bitCount * M.TAIL);
      rotation[k] = r[k]! + (mirrored ? -residual : residual) + 0; // + 0: no negative zero
      off += Math.abs(residual);
    }
    this.checkRotation(rotation);
    return rotation;
  }
}
