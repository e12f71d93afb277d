// Quantized state of frames, and helpers of the decoders of both codecs. As in
// proto/snapshot/include/jostle/snapshot/entity_state.h and entity_diff.h.

export interface EntityState {
  readonly id: number;
  /** In units of 1 / unitsPerMeter m. */
  readonly position: readonly [number, number, number];
  /** Index of the omitted quaternion component: 0 x, 1 y, 2 z, 3 w. */
  readonly largest: number;
  readonly rotation: readonly [number, number, number];
  readonly atRest: boolean;
}

export interface QuantizedFrame {
  readonly frame: number;
  /** In ascending order of id. */
  readonly entities: readonly EntityState[];
}

export interface QuantSpec {
  readonly unitsPerMeter: number;
  readonly rotationComponent: number; // M of WIRE.md
}

export interface Baselines {
  readonly baseline?: QuantizedFrame | undefined;
  readonly baseline2?: QuantizedFrame | undefined;
  readonly baseline3?: QuantizedFrame | undefined;
}

export class DecodeError extends Error {}

/** Whether the integer arithmetic is exact with this quantization (WIRE.md). */
export function isValidSpec({ unitsPerMeter: u, rotationComponent: m }: QuantSpec): boolean {
  return Number.isInteger(u) && u >= 1 && u <= 65536 && Number.isInteger(m) && m >= 1 && m <= 16383;
}

export const INT32_MIN = -2147483648;
export const INT32_MAX = 2147483647;

export interface Spacing {
  readonly dt1: number;
  readonly dt2: number;
  readonly dt3: number;
}

export interface Survivor {
  readonly b1: EntityState;
  readonly b2: EntityState | undefined;
  readonly b3: EntityState | undefined;
}

export type Three = [number, number, number];
export type Four = [number, number, number, number];

export function sameRotation(a: EntityState, b: EntityState): boolean {
  return (
    a.largest === b.largest &&
    a.rotation[0] === b.rotation[0] &&
    a.rotation[1] === b.rotation[1] &&
    a.rotation[2] === b.rotation[2]
  );
}

export function samePose(a: EntityState, b: EntityState): boolean {
  return (
    a.position[0] === b.position[0] &&
    a.position[1] === b.position[1] &&
    a.position[2] === b.position[2] &&
    sameRotation(a, b)
  );
}

/** Looks up entities of a frame by ascending ids. */
export class Finder {
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

/** Entities of the baseline that still exist; `removed` has indices in the baseline. */
export function survivorsOf(baselines: Baselines, removed: Set<number>): Survivor[] {
  const in2 = new Finder(baselines.baseline2);
  const in3 = new Finder(baselines.baseline2 ? baselines.baseline3 : undefined);
  const out: Survivor[] = [];
  (baselines.baseline?.entities ?? []).forEach((b1, i) => {
    if (removed.has(i)) return;
    const b2 = in2.find(b1.id);
    out.push({ b1, b2, b3: b2 ? in3.find(b1.id) : undefined });
  });
  return out;
}

export function isRotation(r: readonly number[], m: number): boolean {
  let sum = 0;
  let largest = 0;
  for (let k = 0; k < 3; k++) {
    sum += r[k]! * r[k]!;
    largest = Math.max(largest, Math.abs(r[k]!));
  }
  return largest <= m && sum <= 2 * m * m;
}

/** Survivors and spawned entities in ascending order of id. */
export function merge(survivors: EntityState[], spawned: EntityState[]): EntityState[] {
  if (spawned.length === 0) return survivors;
  return [...survivors, ...spawned].sort((a, b) => a.id - b.id);
}
