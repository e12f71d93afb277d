// Reads the golden channels of modules for tests; tests/modules/golden has the layout.

import { readFileSync } from 'node:fs';
import { expect } from 'vitest';
import type { ChannelData } from '../module_renderers/module_renderer';

/** The channels of one kind, which is an index in the module's channels(). */
export function goldenModule(tag: string, kind = 0): ChannelData[] {
  const bytes = readFileSync(new URL(`../../../../../proto/golden_modules/${tag}.bin`, import.meta.url));
  let at = 0;
  const i32 = () => bytes.readInt32LE((at += 4) - 4);
  const channels = Array.from({ length: i32() }, () => {
    const [ofKind, entity, length] = [i32(), i32(), i32()];
    return { ofKind, entity: entity!, values: Int32Array.from({ length: length! }, i32), seconds: 0 };
  });
  expect(at).toBe(bytes.length);
  return channels.filter(({ ofKind }) => ofKind === kind).map(({ entity, values, seconds }) => ({ entity, values, seconds }));
}

/** Values that a reader must reject: truncated ones, and one too many. */
export function* broken(values: Int32Array): Iterable<Int32Array> {
  for (let end = 0; end < values.length; end++) yield values.subarray(0, end);
  yield new Int32Array([...values, 0]);
}

/** A copy with one value replaced. */
export const withValue = (values: Int32Array, at: number, value: number) => values.map((old, k) => (k === at ? value : old));
