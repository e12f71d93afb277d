import * as THREE from 'three';
import { expect, it } from 'vitest';
import { Solids } from './solids';

const STILL = new THREE.Quaternion();
const ONE = new THREE.Vector3(1, 1, 1);
const RED = new THREE.Color(0xff0000);

it('renders only the solids of the current frame', () => {
  const scene = new THREE.Scene();
  const solids = new Solids(scene);
  const draw = (count: number) => {
    solids.begin();
    for (let k = 0; k < count; k++) solids.add('box', new THREE.Vector3(k, 0, 0), STILL, ONE, RED);
    solids.end();
    const mesh = scene.children[0] as THREE.InstancedMesh;
    const matrix = new THREE.Matrix4();
    let visible = 0;
    for (let slot = 0; slot < mesh.count; slot++) {
      mesh.getMatrixAt(slot, matrix);
      if (matrix.getMaxScaleOnAxis() > 0) visible++;
    }
    return visible;
  };
  expect([draw(3), draw(100), draw(2), draw(0), draw(5)]).toEqual([3, 100, 2, 0, 5]);
  expect(solids.count).toBe(5);
  expect(new THREE.Vector3().setFromMatrixPosition(solids.matrixOf('box', 4)).x).toBe(4);
  expect(scene.children).toHaveLength(1); // one mesh per kind
});
