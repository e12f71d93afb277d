// The module, told a story, answers with the bits of the native build (tests/determinism/predictor_golden_main.cpp).

import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { predictorModule } from '../testing/yard.js';
import { instantiate, type PredictorExports } from './predictor.js';

const story = JSON.parse(readFileSync(new URL('../../../../../tests/determinism/predictor_golden.json', import.meta.url), 'utf8')) as [string, ...number[]][];

/** Calls whose last number is their answer. */
const ANSWERS = ['set_shapes', 'frame', 'drive'];

it('answers a story with the bits of the native build', async () => {
  const calls = await instantiate(await predictorModule(), () => {});
  const self = calls.create();
  const list = (count: number) => new Float64Array(calls.memory.buffer, calls.buffer(self, count), count);
  let poses = 0;
  for (const [call, ...values] of story) {
    if (call === 'put') list(values.length).set(values);
    else if (call === 'sample') {
      const [position, nowUs, count, ...right] = values as [number, number, number, ...number[]];
      expect(calls.sample(self, position, nowUs, count)).toBe(count);
      expect([...list(count * 8)], `tick ${position}`).toEqual(right);
      poses += count;
    } else {
      const made = calls[(call === 'drive' ? 'control' : call) as keyof PredictorExports] as (...numbers: number[]) => number | undefined;
      const given = ANSWERS.includes(call) ? values.slice(0, -1) : values;
      const answer = made(self, ...given);
      if (ANSWERS.includes(call)) expect(answer, call).toBe(values[values.length - 1]);
    }
  }
  expect(poses).toBeGreaterThan(100);
});
