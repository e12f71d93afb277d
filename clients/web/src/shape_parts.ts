// A body's shapes as parts that can be drawn: each is a unit geometry, moved and scaled in the body.

import * as THREE from 'three';
import type { Shape } from './gen/jostle/v1/scene_pb';

/** A slab is a box so wide that it is ground; a cap is the end of a capsule. */
export type Kind = 'box' | 'slab' | 'plane' | 'sphere' | 'cap' | 'cylinder';
export const KINDS: readonly Kind[] = ['box', 'slab', 'plane', 'sphere', 'cap', 'cylinder'];

export interface ShapePart {
  readonly kind: Kind;
  readonly local: THREE.Matrix4;
}

export const GEOMETRIES: Record<Kind, () => THREE.BufferGeometry> = {
  box: () => new THREE.BoxGeometry(2, 2, 2),
  slab: () => new THREE.BoxGeometry(2, 2, 2),
  plane: () => new THREE.PlaneGeometry(2, 2).rotateX(-Math.PI / 2),
  sphere: () => new THREE.SphereGeometry(1, 28, 18),
  cap: () => new THREE.SphereGeometry(1, 20, 8, 0, Math.PI * 2, 0, Math.PI / 2),
  cylinder: () => new THREE.CylinderGeometry(1, 1, 2, 20, 1, true),
};

const SLAB_HALF = 30; // m
const PLANE_HALF = 500; // m
const UP = new THREE.Vector3(0, 1, 0);
const UPSIDE_DOWN = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(1, 0, 0), Math.PI);

export function partsOf(shape: Shape): ShapePart[] {
  const p = shape.position;
  const q = shape.rotation;
  const turn = q ? new THREE.Quaternion(q.x, q.y, q.z, q.w) : new THREE.Quaternion();
  if (turn.lengthSq() === 0) turn.identity();
  turn.normalize();
  const part = (kind: Kind, scale: THREE.Vector3, along = 0, turned = new THREE.Quaternion()): ShapePart => {
    const position = new THREE.Vector3(0, along, 0).applyQuaternion(turn);
    if (p) position.add(new THREE.Vector3(p.x, p.y, p.z));
    return { kind, local: new THREE.Matrix4().compose(position, turn.clone().multiply(turned), scale) };
  };
  switch (shape.kind.case) {
    case 'sphere': {
      const r = shape.kind.value.radius;
      return [part('sphere', new THREE.Vector3(r, r, r))];
    }
    case 'box': {
      const h = shape.kind.value.halfExtents;
      const half = new THREE.Vector3(h?.x ?? 0.5, h?.y ?? 0.5, h?.z ?? 0.5);
      return [part(half.x >= SLAB_HALF && half.z >= SLAB_HALF ? 'slab' : 'box', half)];
    }
    case 'capsule': {
      const { radius: r, halfLength: h } = shape.kind.value;
      const round = new THREE.Vector3(r, r, r);
      return [
        part('cylinder', new THREE.Vector3(r, h, r)),
        part('cap', round, h),
        part('cap', round, -h, UPSIDE_DOWN),
      ];
    }
    case 'plane': {
      const n = shape.kind.value.normal;
      const normal = n ? new THREE.Vector3(n.x, n.y, n.z).normalize() : UP;
      const turned = new THREE.Quaternion().setFromUnitVectors(UP, normal);
      return [part('plane', new THREE.Vector3(PLANE_HALF, 1, PLANE_HALF), 0, turned)];
    }
    default:
      return [];
  }
}
