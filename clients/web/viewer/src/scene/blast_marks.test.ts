import * as THREE from 'three';
import { expect, it } from 'vitest';
import { BlastMarks } from './blast_marks';

it('shows each blast once for half a second', () => {
  const marks = new BlastMarks(new THREE.Scene());
  for (const now of [1000, 1016, 1033]) marks.add(1, 2, 3, 6, now);
  const activeAt = (now: number) => {
    marks.update(now);
    return marks.activeCount;
  };
  expect([activeAt(1000), activeAt(1500), activeAt(1560)]).toEqual([1, 1, 0]);
  marks.add(1, 2, 3, 6, 2000);
  marks.add(5, 2, 3, 6, 2000);
  expect(activeAt(2100)).toBe(2);
});
