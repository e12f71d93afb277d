// Replays the calls of tests/determinism/predictor_golden_main.cpp and compares the results with the
// native build.

import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { predictorModule } from '../testing/yard.js';
import { instantiate, type PredictorExports } from './predictor.js';

const file = new URL('../../../../../tests/determinism/predictor_golden.json', import.meta.url);
const script = JSON.parse(readFileSync(file, 'utf8')) as [string, ...number[]][];

/** Calls whose last number is their result. */
const CALLS_WITH_RESULT = ['set_shapes', 'frame', 'control'];

it('matches the native build bit for bit', async () => {
  const api = await instantiate(await predictorModule(), () => {});
  const self = api.create();
  const list = (count: number) => new Float64Array(api.memory.buffer, api.buffer(self, count), count);
  let poses = 0;
  for (const [recorded, ...values] of script) {
    const call = recorded === 'drive' ? 'control' : recorded; // golden files before the export was renamed
    if (call === 'put') list(values.length).set(values);
    else if (call === 'sample') {
      const [position, nowUs, count, ...expected] = values as [number, number, number, ...number[]];
      expect(api.sample(self, position, nowUs, count)).toBe(count);
      expect([...list(count * 8)], `tick ${position}`).toEqual(expected);
      poses += count;
    } else {
      const exported = api[call as keyof PredictorExports] as (...numbers: number[]) => number | undefined;
      const args = CALLS_WITH_RESULT.includes(call) ? values.slice(0, -1) : values;
      const result = exported(self, ...args);
      if (CALLS_WITH_RESULT.includes(call)) expect(result, call).toBe(values[values.length - 1]);
    }
  }
  expect(poses).toBeGreaterThan(100);
});
