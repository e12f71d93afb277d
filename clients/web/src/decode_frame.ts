// The twin of proto/wire in TypeScript, decoding only; written from proto/WIRE.md and proved by proto/golden.

import { BitReader, bitWidth, unZigZag } from './bit_reader';
import { crc32 } from './crc32';

export interface EntityState {
  readonly id: number;
  /** Units of 1 / unitsPerMeter m. */
  readonly position: readonly [number, number, number];
  /** Which quaternion component was left out: 0 x, 1 y, 2 z, 3 w. */
  readonly largest: number;
  readonly rotation: readonly [number, number, number];
  readonly atRest: boolean;
}

export interface QuantizedFrame {
  readonly frame: number;
  /** In rising order of id. */
  readonly entities: readonly EntityState[];
}

export interface QuantSpec {
  readonly unitsPerMeter: number;
  readonly rotationComponent: number; // M
}

export interface Bases {
  readonly base?: QuantizedFrame | undefined;
  readonly base2?: QuantizedFrame | undefined;
  readonly base3?: QuantizedFrame | undefined;
}

export class DecodeError extends Error {}

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

/** Whether the arithmetic below is exact with this quantisation (WIRE.md). */
export function isSound({ unitsPerMeter: u, rotationComponent: m }: QuantSpec): boolean {
  return Number.isInteger(u) && u >= 1 && u <= 65536 && Number.isInteger(m) && m >= 1 && m <= 16383;
}

const GAP_ORDER = 4;
const STILL_ORDER = 5;
const POSITION_ORDER = 12;
const MAX_SPACING = 255;
const KP = [0, 0, 0, 1, 2, 2, 3, 3, 4, 5, 6, 7];
const KR = [0, 0, 0, 1, 2, 3, 4, 4, 5, 6, 7, 8];
const INT32_MIN = -2147483648;
const INT32_MAX = 2147483647;

interface Spacing {
  readonly dt1: number;
  readonly dt2: number;
  readonly dt3: number;
}

interface Survivor {
  readonly b1: EntityState;
  readonly b2: EntityState | undefined;
  readonly b3: EntityState | undefined;
}

type Three = [number, number, number];
type Four = [number, number, number, number];

function sameRotation(a: EntityState, b: EntityState): boolean {
  return (
    a.largest === b.largest &&
    a.rotation[0] === b.rotation[0] &&
    a.rotation[1] === b.rotation[1] &&
    a.rotation[2] === b.rotation[2]
  );
}

function samePose(a: EntityState, b: EntityState): boolean {
  return (
    a.position[0] === b.position[0] &&
    a.position[1] === b.position[1] &&
    a.position[2] === b.position[2] &&
    sameRotation(a, b)
  );
}

function isStill(s: Survivor): boolean {
  if (s.b1.atRest || !s.b2) return true;
  return samePose(s.b1, s.b2) && (!s.b3 || samePose(s.b1, s.b3));
}

// ---- prediction: integers, every product below 2^53 ----

/** a / b to the nearest integer, halves away from zero; b > 0. */
function div(a: number, b: number): number {
  const half = Math.trunc(b / 2);
  return a >= 0 ? Math.trunc((a + half) / b) : -Math.trunc((-a + half) / b);
}

function scale(v: number, n: number, d: number): number {
  return n === d ? v : div(v * n, d);
}

function unpack(state: EntityState, n: number, q: Four): Four {
  let sum = 0;
  let from = 0;
  for (let k = 0; k < 4; k++) {
    if (k === state.largest) continue;
    q[k] = state.rotation[from++]!;
    sum += q[k]! * q[k]!;
  }
  // Below 2^53 the square root of a double is off by less than one.
  let root = Math.floor(Math.sqrt(Math.max(0, n - sum)));
  while (root * root > n - sum && root > 0) root--;
  while ((root + 1) * (root + 1) <= n - sum) root++;
  q[state.largest] = root;
  return q;
}

function face(q: Four, towards: Four): void {
  const dot = q[0] * towards[0] + q[1] * towards[1] + q[2] * towards[2] + q[3] * towards[3];
  if (dot < 0) for (let k = 0; k < 4; k++) q[k] = -q[k]!;
}

interface Prediction {
  position: Three;
  largest: number;
  components: Three;
  positionChange: number;
  rotationChange: number;
}

// What predict works in: thousands of bodies sixty times a second should leave nothing to collect.
const q1: Four = [0, 0, 0, 0];
const q2: Four = [0, 0, 0, 0];
const q3: Four = [0, 0, 0, 0];
const q: Four = [0, 0, 0, 0];
const step: Four = [0, 0, 0, 0];
const change: Four = [0, 0, 0, 0];
const prediction: Prediction = {
  position: [0, 0, 0],
  largest: 0,
  components: [0, 0, 0],
  positionChange: 0,
  rotationChange: 0,
};

/** The result is good until the next call. */
function predict(s: Survivor, t: Spacing, m: number): Prediction {
  const { b1 } = s;
  const b2 = b1.atRest ? undefined : s.b2;
  const b3 = b2 ? s.b3 : undefined;
  const { position, components } = prediction;
  let positionChange = 0;
  for (let k = 0; k < 3; k++) {
    const d = b2 ? b1.position[k]! - b2.position[k]! : 0;
    const before = b2 && b3 ? scale(b2.position[k]! - b3.position[k]!, t.dt2, t.dt3) : d;
    position[k] = Math.min(INT32_MAX, Math.max(INT32_MIN, b1.position[k]! + scale(d, t.dt1, t.dt2)));
    positionChange += Math.abs(d - before);
  }

  const n = 2 * m * m;
  unpack(b1, n, q1);
  for (let k = 0; k < 4; k++) {
    q[k] = q1[k]!;
    change[k] = 0;
  }
  if (b2 && !(sameRotation(b1, b2) && (!b3 || sameRotation(b2, b3)))) {
    face(unpack(b2, n, q2), q1);
    let step2 = 0;
    for (let k = 0; k < 4; k++) {
      step[k] = q1[k]! - q2[k]!;
      step2 += step[k]! * step[k]!;
    }
    if (b3) {
      face(unpack(b3, n, q3), q2);
      for (let k = 0; k < 4; k++) change[k] = step[k]! - scale(q2[k]! - q3[k]!, t.dt2, t.dt3);
    }
    if (step2 <= Math.trunc(n / 2)) {
      const bend =
        t.dt1 === t.dt2 ? step2 : div(step2 * t.dt1 * (t.dt1 + t.dt2), 2 * t.dt2 * t.dt2);
      const bends = bend * m >= Math.trunc(n / 4);
      for (let k = 0; k < 4; k++)
        q[k] = q1[k]! + scale(step[k]!, t.dt1, t.dt2) - (bends ? div(q1[k]! * bend, n) : 0);
    }
  }
  let largest = 0;
  for (let k = 1; k < 4; k++) if (Math.abs(q[k]!) > Math.abs(q[largest]!)) largest = k;
  const sign = q[largest]! < 0 ? -1 : 1;
  let rotationChange = 0;
  let to = 0;
  for (let k = 0; k < 4; k++) {
    if (k === largest) continue;
    components[to++] = sign * q[k]!;
    rotationChange += Math.abs(change[k]!);
  }
  prediction.largest = largest;
  prediction.positionChange = positionChange;
  prediction.rotationChange = rotationChange;
  return prediction;
}

// ---- decoding ----

/** Walks a frame's entities along rising ids. */
class Finder {
  private at = 0;
  constructor(private readonly frame: QuantizedFrame | undefined) {}
  find(id: number): EntityState | undefined {
    const entities = this.frame?.entities;
    if (!entities) return undefined;
    while (this.at < entities.length && entities[this.at]!.id < id) this.at++;
    const found = entities[this.at];
    return found?.id === id ? found : undefined;
  }
}

class Decoder {
  private readonly in: BitReader;

  constructor(
    packed: Uint8Array,
    private readonly spec: QuantSpec,
  ) {
    this.in = new BitReader(packed);
  }

  decode(bases: Bases, t: Spacing, maxEntities: number): EntityState[] {
    const removed = new Set(this.readPositions(bases.base?.entities.length ?? 0, 'removed'));
    const survivors = this.survivors(bases, removed);
    const spawned = this.readSpawned(bases, maxEntities - survivors.length);
    const kept = this.readSurvivors(survivors, t);
    if (!this.in.atCleanEnd()) this.fail('bits are left over or missing');
    return merge(kept, spawned);
  }

  private fail(what: string): never {
    throw new DecodeError(`${what} (at bit ${this.in.position})`);
  }

  private checkEnd(): void {
    if (this.in.pastEnd) this.fail('the data ends early');
  }

  private readPositions(size: number, what: string): number[] {
    const count = this.in.expGolomb(0);
    this.checkEnd();
    if (count > size) this.fail(`${what}: more than there are`);
    const positions: number[] = [];
    let next = 0;
    for (let i = 0; i < count; i++) {
      const position = next + this.in.expGolomb(GAP_ORDER);
      this.checkEnd();
      if (position >= size) this.fail(`${what}: a position past the end`);
      positions.push(position);
      next = position + 1;
    }
    return positions;
  }

  private survivors(bases: Bases, removed: Set<number>): Survivor[] {
    const in2 = new Finder(bases.base2);
    const in3 = new Finder(bases.base2 ? bases.base3 : undefined);
    const out: Survivor[] = [];
    (bases.base?.entities ?? []).forEach((b1, i) => {
      if (removed.has(i)) return;
      const b2 = in2.find(b1.id);
      out.push({ b1, b2, b3: b2 ? in3.find(b1.id) : undefined });
    });
    return out;
  }

  private checkRotation(r: readonly number[]): void {
    const m = this.spec.rotationComponent;
    let sum = 0;
    let most = 0;
    for (let k = 0; k < 3; k++) {
      sum += r[k]! * r[k]!;
      most = Math.max(most, Math.abs(r[k]!));
    }
    if (most > m || sum > 2 * m * m) this.fail('a rotation that is none');
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

  private readSpawned(bases: Bases, limit: number): EntityState[] {
    const count = this.in.expGolomb(0);
    this.checkEnd();
    if (count > limit) this.fail('spawned: more entities than the limit');
    const known = new Finder(bases.base);
    const out: EntityState[] = [];
    let nextId = 1;
    for (let i = 0; i < count; i++) {
      const id = nextId + this.in.expGolomb(GAP_ORDER);
      if (id > 0xffffffff) this.fail('spawned: an id beyond 32 bits');
      const position: Three = [0, 0, 0];
      for (let k = 0; k < 3; k++)
        position[k] = this.int32(unZigZag(this.in.expGolomb(POSITION_ORDER)), 'spawned: a position');
      const { largest, rotation } = this.readComponents();
      const atRest = this.in.bits(1) === 1;
      this.checkEnd();
      if (known.find(id)) this.fail('spawned: an id that the base has');
      out.push({ id, position, largest, rotation, atRest });
      nextId = id + 1;
    }
    return out;
  }

  private readMoved(s: Survivor, t: Spacing): EntityState {
    const p = predict(s, t, this.spec.rotationComponent);
    let { positionChange, rotationChange } = p;
    if (isStill(s) || !s.b3 || samePose(s.b1, s.b2!)) {
      positionChange = Math.max(positionChange, 4 * t.dt1);
      rotationChange = Math.max(rotationChange, 4 * t.dt1);
    }
    const kp = KP[Math.min(bitWidth(positionChange), 11)]!;
    const kr = KR[Math.min(bitWidth(rotationChange), 11)]!;
    const position: Three = [0, 0, 0];
    for (let k = 0; k < 3; k++)
      position[k] = this.int32(p.position[k]! + unZigZag(this.in.rice(kp)), 'a position');
    if (!(rotationChange === 0 && this.in.bits(1) === 1)) {
      if (this.in.takeEscape()) {
        const { largest, rotation } = this.readComponents();
        return { id: s.b1.id, position, largest, rotation, atRest: false };
      }
      for (let k = 0; k < 3; k++) p.components[k]! += unZigZag(this.in.rice(kr));
    }
    this.checkEnd();
    this.checkRotation(p.components);
    const rotation: Three = [p.components[0], p.components[1], p.components[2]];
    return { id: s.b1.id, position, largest: p.largest, rotation, atRest: false };
  }

  private readSurvivors(survivors: Survivor[], t: Spacing): EntityState[] {
    const out: EntityState[] = [];
    let run = this.in.expGolomb(STILL_ORDER);
    for (const s of survivors) {
      const still = isStill(s);
      let changed: boolean;
      if (still) {
        changed = run === 0;
        if (!changed) run--;
      } else {
        changed = this.in.bits(1) === 1;
      }
      if (changed) {
        out.push(this.readMoved(s, t));
        if (still) run = this.in.expGolomb(STILL_ORDER);
      } else {
        out.push(s.b1);
      }
      this.checkEnd();
    }
    if (run !== 0) this.fail('a run of still entities past the end');
    for (const i of this.readPositions(out.length, 'rest toggles'))
      out[i] = { ...out[i]!, atRest: !out[i]!.atRest };
    return out;
  }
}

function merge(kept: EntityState[], spawned: EntityState[]): EntityState[] {
  if (spawned.length === 0) return kept;
  return [...kept, ...spawned].sort((a, b) => a.id - b.id);
}

/** Foreign bytes: throws DecodeError that says what was wrong and where. */
export function decodeFrame(
  frame: number,
  packed: Uint8Array,
  bases: Bases,
  spec: QuantSpec,
  maxEntities = 1 << 20,
): QuantizedFrame {
  if (!isSound(spec)) throw new DecodeError('a quantisation out of range');
  const base2 = bases.base ? bases.base2 : undefined;
  const base3 = base2 ? bases.base3 : undefined;
  const t: Spacing = {
    dt1: bases.base ? frame - bases.base.frame : 1,
    dt2: bases.base && base2 ? bases.base.frame - base2.frame : 1,
    dt3: base2 && base3 ? base2.frame - base3.frame : 1,
  };
  for (const dt of [t.dt1, t.dt2, t.dt3])
    if (dt < 1 || dt > MAX_SPACING)
      throw new DecodeError(`frame ${frame} is not 1 to 255 ticks after its bases`);
  const entities = new Decoder(packed, spec).decode({ base: bases.base, base2, base3 }, t, maxEntities);
  return { frame, entities };
}

/** The CRC of WIRE.md: 24 bytes per entity. */
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
