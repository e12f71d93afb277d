// Where a camera stands to see all of a box, clear of the panels below and beside the picture.

import * as THREE from 'three';

// Of half of the picture: how far what is seen may reach, and by how much it is moved up for that.
const TOP = 0.92;
const BOTTOM = 0.68;
const SIDE = 0.98;
const RAISED = 0.13;

export interface CameraFrame {
  readonly position: THREE.Vector3;
  readonly target: THREE.Vector3;
}

/** From a direction (unit, from the box to the camera) and no nearer or further than that, m. `fov` in degrees, upright. */
export function frameOf(box: THREE.Box3, from: THREE.Vector3, fov: number, aspect: number, nearest: number, furthest: number): CameraFrame {
  const middle = box.getCenter(new THREE.Vector3());
  const right = new THREE.Vector3(0, 1, 0).cross(from).normalize();
  const up = from.clone().cross(right);
  const tan = Math.tan((fov * Math.PI) / 360);
  let distance = nearest;
  for (let corner = 0; corner < 8; corner++) {
    const c = new THREE.Vector3(
      corner & 1 ? box.max.x : box.min.x,
      corner & 2 ? box.max.y : box.min.y,
      corner & 4 ? box.max.z : box.min.z,
    ).sub(middle);
    const [x, y, z] = [Math.abs(c.dot(right)), c.dot(up), c.dot(from)];
    // Seen at (y + RAISED tan distance) / (distance - z), which is to be from -BOTTOM tan to TOP tan.
    distance = Math.max(
      distance,
      x / (SIDE * tan * aspect) + z,
      (y / tan + TOP * z) / (TOP - RAISED),
      (BOTTOM * z - y / tan) / (BOTTOM + RAISED),
    );
  }
  distance = Math.min(distance, furthest);
  const target = middle.addScaledVector(up, -RAISED * tan * distance);
  return { target, position: target.clone().addScaledVector(from, distance) };
}
