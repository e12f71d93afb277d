// Reads the golden point objects for tests.

import { readFileSync } from 'node:fs';
import { expect } from 'vitest';
import type { PointLayout } from '../snapshot/point_layout.js';

/** proto/golden/points.jpnt; tests/proto/snapshot/golden_points.h has the layout. */
export function goldenPoints() {
  const bytes = readFileSync(new URL('../../../../../proto/golden/points.jpnt', import.meta.url));
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 4;
  const u32 = () => view.getUint32((at += 4) - 4, true);
  const list = (length: number) => Int32Array.from({ length }, () => view.getInt32((at += 4) - 4, true));
  expect(bytes.subarray(0, 4).toString()).toBe('JPNT');
  expect(u32()).toBe(1);
  const objects = Array.from({ length: u32() }, () => {
    const [form, points, columns] = [u32(), u32(), u32()];
    const layout: PointLayout = { form, points, columns, strands: [...list(u32())], triangles: [...list(u32())] };
    const updates = Array.from({ length: u32() }, () => {
      const [number, back, levels, crc, size, values, links] = [u32(), u32(), u32(), u32(), u32(), u32(), u32()];
      const update = { number, back, levels, crc, values: list(values), previous: list(links) };
      return { ...update, packed: new Uint8Array(bytes.subarray(at, (at += size))) };
    });
    return { layout, updates };
  });
  expect(at).toBe(bytes.length);
  return objects;
}
