import * as THREE from 'three';
import { expect, it } from 'vitest';
import { BlastMarks } from './blast_marks';

it('a blast shows for half a second, and once however often its tick is drawn', () => {
  const marks = new BlastMarks(new THREE.Scene());
  for (const now of [1000, 1016, 1033]) marks.add(1, 2, 3, 6, now);
  const lit = (now: number) => {
    marks.update(now);
    return marks.activeCount;
  };
  expect([lit(1000), lit(1500), lit(1560)]).toEqual([1, 1, 0]);
  marks.add(1, 2, 3, 6, 2000);
  marks.add(5, 2, 3, 6, 2000);
  expect(lit(2100)).toBe(2);
});
