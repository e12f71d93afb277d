import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { frameBox } from './framing';

const FROM = new THREE.Vector3(13, 9, 18).normalize();

/** The corners of the box in the view, -1 to 1. */
function corners(box: THREE.Box3, aspect: number): THREE.Vector3[] {
  const camera = new THREE.PerspectiveCamera(55, aspect, 0.1, 500);
  const { position, target } = frameBox(box, FROM, 55, aspect, 9, 200);
  camera.position.copy(position);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) =>
    new THREE.Vector3(k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z).project(camera),
  );
}

describe('framing', () => {
  for (const [name, box] of [
    ['a flat yard', new THREE.Box3(new THREE.Vector3(-12, 0, -12), new THREE.Vector3(12, 3, 12))],
    ['a tall wall', new THREE.Box3(new THREE.Vector3(-15, 0, -0.5), new THREE.Vector3(15, 30, 0.5))],
    ['a long mole', new THREE.Box3(new THREE.Vector3(18, -2, -22), new THREE.Vector3(22, 8, 10))],
  ] as const)
    for (const aspect of [16 / 9, 0.5])
      it(`fits ${name} between the panels at aspect ${aspect.toFixed(1)}`, () => {
        const points = corners(box, aspect);
        const reach = (of: (v: THREE.Vector3) => number) => Math.max(...points.map(of));
        const [right, top, bottom] = [reach((v) => Math.abs(v.x)), reach((v) => v.y), reach((v) => -v.y)];
        expect(right).toBeLessThan(0.981);
        expect(top).toBeLessThan(0.921);
        expect(bottom).toBeLessThan(0.681);
        expect(Math.max(right / 0.98, top / 0.92, bottom / 0.68)).toBeGreaterThan(0.999);
      });

  it('keeps the minimum distance to a single body', () => {
    const { position, target } = frameBox(new THREE.Box3(new THREE.Vector3(0, 0, 0), new THREE.Vector3(1, 1, 1)), FROM, 55, 1.5, 9, 80);
    expect(position.distanceTo(target)).toBeCloseTo(9, 6);
  });
});
