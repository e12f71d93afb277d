// Camera position that shows a whole box, clear of the panels at the bottom and at the sides.

import * as THREE from 'three';

// In half heights or half widths of the view: how far the box may extend, and how far up it is shifted.
const TOP = 0.92;
const BOTTOM = 0.68;
const SIDE = 0.98;
const RAISED = 0.13;

export interface CameraFrame {
  readonly position: THREE.Vector3;
  readonly target: THREE.Vector3;
}

/**
 * `from`: unit direction from the box to the camera; `fov`: vertical field of view in degrees;
 * distances in m.
 */
export function frameBox(box: THREE.Box3, from: THREE.Vector3, fov: number, aspect: number, minDistance: number, maxDistance: number): CameraFrame {
  const center = box.getCenter(new THREE.Vector3());
  const right = new THREE.Vector3(0, 1, 0).cross(from).normalize();
  const up = from.clone().cross(right);
  const tan = Math.tan((fov * Math.PI) / 360);
  let distance = minDistance;
  for (let corner = 0; corner < 8; corner++) {
    const c = new THREE.Vector3(
      corner & 1 ? box.max.x : box.min.x,
      corner & 2 ? box.max.y : box.min.y,
      corner & 4 ? box.max.z : box.min.z,
    ).sub(center);
    const [x, y, z] = [Math.abs(c.dot(right)), c.dot(up), c.dot(from)];
    // A corner appears at (y + RAISED tan distance) / (distance - z), which must be between -BOTTOM tan
    // and TOP tan.
    distance = Math.max(
      distance,
      x / (SIDE * tan * aspect) + z,
      (y / tan + TOP * z) / (TOP - RAISED),
      (BOTTOM * z - y / tan) / (BOTTOM + RAISED),
    );
  }
  distance = Math.min(distance, maxDistance);
  const target = center.addScaledVector(up, -RAISED * tan * distance);
  return { target, position: target.clone().addScaledVector(from, distance) };
}
