// Reads the golden channels of modules for tests; tests/modules/golden has the layout.

import { readFileSync } from 'node:fs';
import { expect } from 'vitest';
import type { ChannelData } from '../module_renderers/module_renderer';

/** The channels of one kind, which is an index in the module's channels(). */
export function goldenModule(tag: string, kind = 0): ChannelData[] {
  const text = readFileSync(new URL('../../../../../proto/golden_modules.txt', import.meta.url), 'utf8');
  const lines = text.trimEnd().split('\n').filter((line) => line.startsWith(`${tag} ${kind} `));
  expect(lines).not.toEqual([]);
  return lines.map((line) => {
    const [entity, ...values] = line.split(' ').slice(2).map(Number);
    return { entity: entity!, values: Int32Array.from(values), seconds: 0 };
  });
}

/** Values that a reader must reject: truncated ones, and one too many. */
export function* broken(values: Int32Array): Iterable<Int32Array> {
  for (let end = 0; end < values.length; end++) yield values.subarray(0, end);
  yield new Int32Array([...values, 0]);
}

/** A copy with one value replaced. */
export const withValue = (values: Int32Array, at: number, value: number) => values.map((old, k) => (k === at ? value : old));
