// The module "fields": water with its waves, which runs on by itself between ticks, and flashes of blasts; in the debug view arrows
// of the wind and rings round what attracts. fields.h has the layout.

import * as THREE from 'three';
import type { WaterLook } from '../water';
import { ByteReader } from './byte_reader';
import type { Drawer, Drawing } from './drawer';

const KINDS = ['central', 'turbulence', 'user'] as const;
const WAVES_MAX = 8;
const ARROWS = 4; // to each side
const ARROW_SPACING = 3; // m
const RINGS = [1, 2, 4]; // m

interface Wave {
  amplitude: number; // m
  length: number; // m
  heading: number; // rad from x to z
  phase: number; // rad, at the tick
  omega: number; // rad/s
}
interface Water {
  level: number;
  density: number;
  waves: Wave[];
}
type Point = [number, number, number];
type Field = { kind: 'central'; point: Point } | { kind: 'turbulence'; wind: Point; speed: number } | { kind: 'user' };
export interface Fields {
  waters: Water[];
  others: Field[];
  blasts: { point: Point; radius: number }[];
}

const readPoint = (reader: ByteReader): Point => [reader.f32(), reader.f32(), reader.f32()];

function readWater(reader: ByteReader): Water {
  const water: Water = { level: reader.f32(), density: reader.f32(), waves: [] };
  const count = reader.u8();
  if (count > WAVES_MAX) reader.failed = true;
  for (let k = 0; k < count && !reader.failed; k++)
    water.waves.push({
      amplitude: reader.f32(),
      length: reader.f32(),
      heading: reader.quantized(0, 2 * Math.PI, 2),
      phase: reader.quantized(0, 2 * Math.PI, 2),
      omega: reader.f32(),
    });
  if (water.waves.some(({ length }) => !(length > 0))) reader.failed = true;
  return water;
}

function readField(reader: ByteReader): Field {
  const kind = KINDS[reader.u8()];
  if (kind === 'central') return { kind, point: readPoint(reader) };
  if (kind === 'turbulence') return { kind, wind: readPoint(reader), speed: reader.f32() };
  if (kind === undefined) reader.failed = true;
  return { kind: 'user' };
}

function several<T>(reader: ByteReader, read: (reader: ByteReader) => T): T[] {
  const all: T[] = [];
  for (let left = reader.u8(); left > 0 && !reader.failed; left--) all.push(read(reader));
  return all;
}

/** Nothing unless the bytes are exactly what fields tell. */
export function readFields(bytes: Uint8Array): Fields | undefined {
  const reader = new ByteReader(bytes);
  const fields: Fields = {
    waters: several(reader, readWater),
    others: several(reader, readField),
    blasts: several(reader, () => ({ point: readPoint(reader), radius: reader.f32() })),
  };
  return reader.failed || reader.left > 0 ? undefined : fields;
}

/** As it is that long after its tick. */
export function lookOf({ level, waves }: Water, seconds: number): WaterLook {
  return {
    level,
    waves: waves.map(({ amplitude, length, heading, phase, omega }) => ({
      amplitude,
      number: (2 * Math.PI) / length,
      x: Math.cos(heading),
      z: Math.sin(heading),
      turn: phase - omega * seconds,
    })),
  };
}

const WIND = new THREE.Color(0x9ad1ff);
const PULL = new THREE.Color(0xff9df0);

function drawWind(wind: Point, { lines, around }: Drawing): void {
  const [x, y, z] = wind;
  const speed = Math.hypot(x, y, z);
  if (speed === 0) return;
  const reach = Math.min(2.5, 0.4 * speed) / speed;
  const step = (k: number) => k * ARROW_SPACING;
  const from = (value: number) => Math.round(value / ARROW_SPACING) * ARROW_SPACING;
  for (let i = -ARROWS; i <= ARROWS; i++)
    for (let k = -ARROWS; k <= ARROWS; k++) {
      const [px, py, pz] = [from(around.x) + step(i), around.y + 2.5, from(around.z) + step(k)];
      const [tx, ty, tz] = [px + reach * x, py + reach * y, pz + reach * z];
      lines.vertex(px, py, pz, WIND);
      lines.vertex(tx, ty, tz, WIND);
      // The head: two strokes back and to the sides.
      for (const side of [-1, 1]) {
        lines.vertex(tx, ty, tz, WIND);
        lines.vertex(tx - reach * (0.25 * x + side * 0.12 * z), ty - 0.25 * reach * y, tz - reach * (0.25 * z - side * 0.12 * x), WIND);
      }
    }
}

function drawRings([x, y, z]: Point, { lines }: Drawing): void {
  const SIDES = 32;
  for (const radius of RINGS)
    for (let k = 0; k < SIDES; k++)
      for (const end of [k, k + 1]) {
        const angle = (2 * Math.PI * end) / SIDES;
        lines.vertex(x + radius * Math.cos(angle), y, z + radius * Math.sin(angle), PULL);
      }
}

export const fields: Drawer = {
  draw(bytes, drawing) {
    const all = readFields(bytes);
    if (!all) return;
    for (const water of all.waters) drawing.water.add(lookOf(water, drawing.seconds), drawing.around);
    for (const { point, radius } of all.blasts) drawing.blasts.add(...point, radius, drawing.nowMs);
    if (!drawing.debug) return;
    for (const field of all.others) {
      if (field.kind === 'turbulence') drawWind(field.wind, drawing);
      if (field.kind === 'central') drawRings(field.point, drawing);
    }
  },
};
