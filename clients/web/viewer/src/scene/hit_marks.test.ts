import * as THREE from 'three';
import { expect, it } from 'vitest';
import { HitMarks } from './hit_marks';

it('shows a hit for 0.3 s from its rendered time, shrinking', () => {
  const marks = new HitMarks(new THREE.Scene());
  marks.add(1, 2, 3, 5, 1100);
  const size = (now: number) => {
    marks.update(now);
    const matrix = new THREE.Matrix4();
    marks.mesh.getMatrixAt(0, matrix);
    return matrix.getMaxScaleOnAxis();
  };
  expect(size(1050)).toBe(0);
  expect(size(1100)).toBeCloseTo(0.06 + 5 * 0.03);
  expect(new THREE.Vector3().setFromMatrixPosition(currentMatrix(marks)).toArray()).toEqual([1, 2, 3]);
  expect(size(1300)).toBeLessThan(size(1200));
  expect([size(1399) > 0, size(1400)]).toEqual([true, 0]);
  expect(marks.mesh.visible).toBe(false);
});

it('shows at most 64 marks', () => {
  const marks = new HitMarks(new THREE.Scene());
  for (let i = 0; i < 100; i++) marks.add(i, 0, 0, 1, 0);
  marks.update(10);
  expect(marks.activeCount).toBe(64);
});

function currentMatrix(marks: HitMarks): THREE.Matrix4 {
  const matrix = new THREE.Matrix4();
  marks.mesh.getMatrixAt(0, matrix);
  return matrix;
}
