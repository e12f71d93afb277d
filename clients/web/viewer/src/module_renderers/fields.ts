// Renders the module "fields". Kind "fields.waves", sent at a low rate: water whose waves the client
// advances. Kind "fields": explosion marks, and in the debug view wind arrows and rings around
// attractors. Layouts: fields.h.

import * as THREE from 'three';
import type { WaterSurface } from '../scene/water';
import type { ModuleRenderer, RenderContext } from './module_renderer';
import { ValueReader } from './value_reader';

const KINDS = ['central', 'turbulence', 'user'] as const;
// Limits of the module.
const WATERS_MAX = 4;
const WAVES_MAX = 8;
const FIELDS_MAX = 64;
const BLASTS_MAX = 8;
const ARROWS = 4; // per side
const ARROW_SPACING = 3; // m
const RINGS = [1, 2, 4]; // m, radii

interface Wave {
  amplitude: number; // m
  length: number; // m
  heading: number; // rad from x to z
  phase: number; // rad, at the tick of the data
  omega: number; // rad/s
}
export interface WavyWater {
  level: number;
  density: number;
  waves: Wave[];
}
type Point = [number, number, number];
type Field = { kind: 'central'; point: Point } | { kind: 'turbulence'; wind: Point; speed: number } | { kind: 'user' };
export interface Fields {
  others: Field[];
  blasts: { point: Point; radius: number }[];
}

const readPoint = (reader: ValueReader): Point => [reader.f32(), reader.f32(), reader.f32()];

/** A count, then that many items; fails if the count exceeds `max`. */
function counted<T>(reader: ValueReader, max: number, read: (reader: ValueReader) => T): T[] {
  const count = reader.value();
  if (count < 0 || count > max) reader.failed = true;
  const all: T[] = [];
  while (!reader.failed && all.length < count) all.push(read(reader));
  return all;
}

/** Items until the end; fails if there are more than `max`. */
function untilEnd<T>(reader: ValueReader, max: number, read: (reader: ValueReader) => T): T[] {
  const all: T[] = [];
  while (!reader.failed && reader.left > 0) {
    if (all.length === max) reader.failed = true;
    else all.push(read(reader));
  }
  return all;
}

function readWave(reader: ValueReader): Wave {
  const wave = {
    amplitude: reader.f32(),
    length: reader.f32(),
    heading: reader.quantized(0, 2 * Math.PI, 16),
    phase: reader.quantized(0, 2 * Math.PI, 16),
    omega: reader.f32(),
  };
  if (!(wave.length > 0)) reader.failed = true;
  return wave;
}

function readWater(reader: ValueReader): WavyWater {
  return { level: reader.f32(), density: reader.f32(), waves: counted(reader, WAVES_MAX, readWave) };
}

/** undefined if the values are malformed. */
export function readWaters(values: Int32Array): WavyWater[] | undefined {
  const reader = new ValueReader(values);
  const waters = untilEnd(reader, WATERS_MAX, readWater);
  return reader.failed ? undefined : waters;
}

function readField(reader: ValueReader): Field {
  const kind = KINDS[reader.value()];
  if (kind === 'central') return { kind, point: readPoint(reader) };
  if (kind === 'turbulence') return { kind, wind: readPoint(reader), speed: reader.f32() };
  if (kind === undefined) reader.failed = true;
  return { kind: 'user' };
}

/** undefined if the values are malformed. */
export function readFields(values: Int32Array): Fields | undefined {
  const reader = new ValueReader(values);
  const others = counted(reader, FIELDS_MAX, readField);
  const blasts = untilEnd(reader, BLASTS_MAX, () => ({ point: readPoint(reader), radius: reader.f32() }));
  return reader.failed ? undefined : { others, blasts };
}

/** The surface `seconds` after the tick of the data. */
export function waterSurface({ level, waves }: WavyWater, seconds: number): WaterSurface {
  return {
    level,
    waves: waves.map(({ amplitude, length, heading, phase, omega }) => ({
      amplitude,
      number: (2 * Math.PI) / length,
      x: Math.cos(heading),
      z: Math.sin(heading),
      phase: phase - omega * seconds,
    })),
  };
}

const WIND = new THREE.Color(0x9ad1ff);
const PULL = new THREE.Color(0xff9df0);

function drawWind(wind: Point, { lines, cameraTarget }: RenderContext): void {
  const [x, y, z] = wind;
  const speed = Math.hypot(x, y, z);
  if (speed === 0) return;
  const reach = Math.min(2.5, 0.4 * speed) / speed;
  const step = (k: number) => k * ARROW_SPACING;
  const from = (value: number) => Math.round(value / ARROW_SPACING) * ARROW_SPACING;
  for (let i = -ARROWS; i <= ARROWS; i++)
    for (let k = -ARROWS; k <= ARROWS; k++) {
      const [px, py, pz] = [from(cameraTarget.x) + step(i), cameraTarget.y + 2.5, from(cameraTarget.z) + step(k)];
      const [tx, ty, tz] = [px + reach * x, py + reach * y, pz + reach * z];
      lines.vertex(px, py, pz, WIND);
      lines.vertex(tx, ty, tz, WIND);
      // The arrow head: two strokes.
      for (const side of [-1, 1]) {
        lines.vertex(tx, ty, tz, WIND);
        lines.vertex(tx - reach * (0.25 * x + side * 0.12 * z), ty - 0.25 * reach * y, tz - reach * (0.25 * z - side * 0.12 * x), WIND);
      }
    }
}

function drawRings([x, y, z]: Point, { lines }: RenderContext): void {
  const SIDES = 32;
  for (const radius of RINGS)
    for (let k = 0; k < SIDES; k++)
      for (const end of [k, k + 1]) {
        const angle = (2 * Math.PI * end) / SIDES;
        lines.vertex(x + radius * Math.cos(angle), y, z + radius * Math.sin(angle), PULL);
      }
}

export const waves: ModuleRenderer = {
  draw(data, { water, cameraTarget }) {
    for (const { values, seconds } of data) for (const one of readWaters(values) ?? []) water.add(waterSurface(one, seconds), cameraTarget);
  },
};

export const fields: ModuleRenderer = {
  draw(data, context) {
    for (const { values } of data) {
      const { others, blasts } = readFields(values) ?? { others: [], blasts: [] };
      for (const { point, radius } of blasts) context.blasts.add(...point, radius, context.nowMs);
      if (!context.debug) continue;
      for (const field of others) {
        if (field.kind === 'turbulence') drawWind(field.wind, context);
        if (field.kind === 'central') drawRings(field.point, context);
      }
    }
  },
};
