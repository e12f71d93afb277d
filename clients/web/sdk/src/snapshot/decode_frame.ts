// Decodes snapshots: the TypeScript counterpart of proto/snapshot, written from proto/WIRE.md and
// verified by proto/golden. This file has codec 1; range_frame.ts has codec 2.

import { BitReader, bitWidth, zigZagDecode } from './bit_reader.js';
import { crc32 } from './crc32.js';
import {
  DecodeError,
  Finder,
  INT32_MAX,
  INT32_MIN,
  isRotation,
  isValidSpec,
  merge,
  samePose,
  survivorsOf,
  type Baselines,
  type EntityState,
  type Four,
  type QuantSpec,
  type QuantizedFrame,
  type Spacing,
  type Survivor,
  type Three,
} from './frame_state.js';
import { predict } from './predict.js';
import { RangeFrameReader } from './range_frame.js';

export { DecodeError, isValidSpec, type Baselines, type EntityState, type QuantSpec, type QuantizedFrame } from './frame_state.js';

/** The highest codec that decodeFrame() supports. */
export const NEWEST_CODEC = 2;

const GAP_ORDER = 4;
const MOTIONLESS_RUN_ORDER = 5;
const POSITION_ORDER = 12;
const MAX_SPACING = 255;
const KP = [0, 0, 0, 1, 2, 2, 3, 3, 4, 5, 6, 7];
const KR = [0, 0, 0, 1, 2, 3, 4, 4, 5, 6, 7, 8];
function isMotionless(s: Survivor): boolean {
  if (s.b1.atRest || !s.b2) return true;
  return samePose(s.b1, s.b2) && (!s.b3 || samePose(s.b1, s.b3));
}

class BitFrameReader {
  private readonly in: BitReader;

  constructor(
    packed: Uint8Array,
    private readonly spec: QuantSpec,
  ) {
    this.in = new BitReader(packed);
  }

  decode(baselines: Baselines, t: Spacing, maxEntities: number): EntityState[] {
    const removed = new Set(this.readPositions(baselines.baseline?.entities.length ?? 0, 'removed'));
    const survivors = survivorsOf(baselines, removed);
    const spawned = this.readSpawned(baselines, maxEntities - survivors.length);
    const updated = this.readSurvivors(survivors, t);
    if (!this.in.atCleanEnd()) this.fail('unexpected or missing bits at the end');
    return merge(updated, spawned);
  }

  private fail(what: string): never {
    throw new DecodeError(`${what} (at bit ${this.in.position})`);
  }

  private checkEnd(): void {
    if (this.in.pastEnd) this.fail('truncated data');
  }

  private readPositions(size: number, what: string): number[] {
    const count = this.in.expGolomb(0);
    this.checkEnd();
    if (count > size) this.fail(`${what}: count ${count} exceeds ${size}`);
    const indices: number[] = [];
    let next = 0;
    for (let i = 0; i < count; i++) {
      const position = next + this.in.expGolomb(GAP_ORDER);
      this.checkEnd();
      if (position >= size) this.fail(`${what}: index out of range`);
      indices.push(position);
      next = position + 1;
    }
    return indices;
  }

  private checkRotation(r: readonly number[]): void {
    if (!isRotation(r, this.spec.rotationComponent)) this.fail('invalid rotation');
  }

  private readComponents(): { largest: number; rotation: Three } {
    const bits = bitWidth(this.spec.rotationComponent) + 1;
    const largest = this.in.bits(2);
    const rotation: Three = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const raw = this.in.bits(bits);
      rotation[k] = raw >= 2 ** (bits - 1) ? raw - 2 ** bits : raw;
    }
    this.checkRotation(rotation);
    return { largest, rotation };
  }

  private int32(v: number, what: string): number {
    if (v < INT32_MIN || v > INT32_MAX) this.fail(`${what} out of range`);
    return v;
  }

  private readSpawned(baselines: Baselines, limit: number): EntityState[] {
    const count = this.in.expGolomb(0);
    this.checkEnd();
    if (count > limit) this.fail('spawned: more entities than the limit');
    const known = new Finder(baselines.baseline);
    const out: EntityState[] = [];
    let nextId = 1;
    for (let i = 0; i < count; i++) {
      const id = nextId + this.in.expGolomb(GAP_ORDER);
      if (id > 0xffffffff) this.fail('spawned: id exceeds 32 bits');
      const position: Three = [0, 0, 0];
      for (let k = 0; k < 3; k++)
        position[k] = this.int32(zigZagDecode(this.in.expGolomb(POSITION_ORDER)), 'spawned: position');
      const { largest, rotation } = this.readComponents();
      const atRest = this.in.bits(1) === 1;
      this.checkEnd();
      if (known.find(id)) this.fail('spawned: id is already in the baseline');
      out.push({ id, position, largest, rotation, atRest });
      nextId = id + 1;
    }
    return out;
  }

  private readMoved(s: Survivor, t: Spacing): EntityState {
    const p = predict(s, t, this.spec.rotationComponent);
    let { positionChange, rotationChange } = p;
    if (isMotionless(s) || !s.b3 || samePose(s.b1, s.b2!)) {
      positionChange = Math.max(positionChange, 4 * t.dt1);
      rotationChange = Math.max(rotationChange, 4 * t.dt1);
    }
    const kp = KP[Math.min(bitWidth(positionChange), 11)]!;
    const kr = KR[Math.min(bitWidth(rotationChange), 11)]!;
    const position: Three = [0, 0, 0];
    for (let k = 0; k < 3; k++)
      position[k] = this.int32(p.position[k]! + zigZagDecode(this.in.rice(kp)), 'position');
    if (!(rotationChange === 0 && this.in.bits(1) === 1)) {
      if (this.in.takeEscape()) {
        const { largest, rotation } = this.readComponents();
        return { id: s.b1.id, position, largest, rotation, atRest: false };
      }
      for (let k = 0; k < 3; k++) p.components[k]! += zigZagDecode(this.in.rice(kr));
    }
    this.checkEnd();
    this.checkRotation(p.components);
    const rotation: Three = [p.components[0], p.components[1], p.components[2]];
    return { id: s.b1.id, position, largest: p.largest, rotation, atRest: false };
  }

  private readSurvivors(survivors: Survivor[], t: Spacing): EntityState[] {
    const out: EntityState[] = [];
    let run = this.in.expGolomb(MOTIONLESS_RUN_ORDER);
    for (const s of survivors) {
      const motionless = isMotionless(s);
      let changed: boolean;
      if (motionless) {
        changed = run === 0;
        if (!changed) run--;
      } else {
        changed = this.in.bits(1) === 1;
      }
      if (changed) {
        out.push(this.readMoved(s, t));
        if (motionless) run = this.in.expGolomb(MOTIONLESS_RUN_ORDER);
      } else {
        out.push(s.b1);
      }
      this.checkEnd();
    }
    if (run !== 0) this.fail('run of unchanged entities exceeds the frame');
    for (const i of this.readPositions(out.length, 'rest toggles'))
      out[i] = { ...out[i]!, atRest: !out[i]!.atRest };
    return out;
  }
}

/** Decodes a frame. Throws DecodeError, which names the defect and its position, for malformed bytes. */
export function decodeFrame(
  frame: number,
  packed: Uint8Array,
  baselines: Baselines,
  spec: QuantSpec,
  maxEntities = 1 << 20,
  codec = 1,
): QuantizedFrame {
  if (!isValidSpec(spec)) throw new DecodeError('quantization out of range');
  if (codec < 1 || codec > NEWEST_CODEC) throw new DecodeError(`unknown codec ${codec}; supported: 1 and 2`);
  const baseline2 = baselines.baseline ? baselines.baseline2 : undefined;
  const baseline3 = baseline2 ? baselines.baseline3 : undefined;
  const t: Spacing = {
    dt1: baselines.baseline ? frame - baselines.baseline.frame : 1,
    dt2: baselines.baseline && baseline2 ? baselines.baseline.frame - baseline2.frame : 1,
    dt3: baseline2 && baseline3 ? baseline2.frame - baseline3.frame : 1,
  };
  for (const dt of [t.dt1, t.dt2, t.dt3])
    if (dt < 1 || dt > MAX_SPACING)
      throw new DecodeError(`frame ${frame}: baseline distances must be 1 to 255 ticks`);
  const reader = codec === 2 ? new RangeFrameReader(packed, spec) : new BitFrameReader(packed, spec);
  const entities = reader.decode({ baseline: baselines.baseline, baseline2, baseline3 }, t, maxEntities);
  return { frame, entities };
}

/** The CRC of WIRE.md over 24 bytes per entity. */
export function frameCrc(frame: QuantizedFrame): number {
  const bytes = new Uint8Array(24 * frame.entities.length);
  const view = new DataView(bytes.buffer);
  let at = 0;
  for (const e of frame.entities) {
    view.setUint32(at, e.id, true);
    for (let k = 0; k < 3; k++) view.setInt32(at + 4 + 4 * k, e.position[k]!, true);
    view.setUint8(at + 16, e.largest);
    for (let k = 0; k < 3; k++) view.setInt16(at + 17 + 2 * k, e.rotation[k]!, true);
    view.setUint8(at + 23, e.atRest ? 1 : 0);
    at += 24;
  }
  return crc32(bytes);
}

export interface Pose {
  position: Three;
  rotation: Four;
}

export function dequantize(e: EntityState, spec: QuantSpec): Pose {
  const scaleBy = 1 / (spec.rotationComponent * Math.SQRT2);
  const rotation: Four = [0, 0, 0, 0];
  let rest = 1;
  let from = 0;
  for (let k = 0; k < 4; k++) {
    if (k === e.largest) continue;
    rotation[k] = e.rotation[from++]! * scaleBy;
    rest -= rotation[k]! * rotation[k]!;
  }
  rotation[e.largest] = Math.sqrt(Math.max(0, rest));
  return {
    position: [
      e.position[0] / spec.unitsPerMeter,
      e.position[1] / spec.unitsPerMeter,
      e.position[2] / spec.unitsPerMeter,
    ],
    rotation,
  };
}
