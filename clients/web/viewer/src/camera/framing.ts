// Camera position that shows all points of a scene in the part of the view that panels do not cover.

import * as THREE from 'three';

const MARGIN = 0.94; // share of the free area that the points may fill

export interface CameraFrame {
  readonly position: THREE.Vector3;
  readonly target: THREE.Vector3;
}

/** Widths of the borders that panels cover, in pixels. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}
export const NO_INSETS: Insets = { top: 0, right: 0, bottom: 0, left: 0 };

const FREE_MIN = 0.35; // share of the view that counts as free, however much panels cover

/** The free part of a view. */
export interface FreeArea {
  /** Tangents of half its horizontal and vertical angle, for a camera whose axis is at its center. */
  readonly tanX: number;
  readonly tanY: number;
  /** From the center of the view to the center of the free area, in pixels to the right and down. */
  readonly offsetX: number;
  readonly offsetY: number;
}

/** `fov`: vertical field of view of the whole view, degrees. */
export function freeArea(width: number, height: number, fov: number, { top, right, bottom, left }: Insets): FreeArea {
  const tan = Math.tan((fov * Math.PI) / 360);
  const shareX = Math.max(FREE_MIN, 1 - (left + right) / width);
  const shareY = Math.max(FREE_MIN, 1 - (top + bottom) / height);
  const limit = (offset: number, size: number, share: number) => Math.max(-1, Math.min(1, offset / (size * (1 - share)) || 0)) * size * (1 - share);
  return {
    tanX: ((tan * width) / height) * shareX,
    tanY: tan * shareY,
    offsetX: limit((left - right) / 2, width, shareX),
    offsetY: limit((top - bottom) / 2, height, shareY),
  };
}

const CENTERINGS = 4; // near points appear farther from the center than distant ones: the target is shifted

/** At least one point. `from`: unit direction from the points to the camera; distances in m. */
export function framePoints(points: readonly THREE.Vector3[], from: THREE.Vector3, area: Pick<FreeArea, 'tanX' | 'tanY'>, minDistance: number, maxDistance: number): CameraFrame {
  const center = new THREE.Box3().setFromPoints([...points]).getCenter(new THREE.Vector3());
  const right = new THREE.Vector3(0, 1, 0).cross(from).normalize();
  const up = from.clone().cross(right);
  const seen = points.map((point) => {
    const p = point.clone().sub(center);
    return { x: p.dot(right), y: p.dot(up), z: p.dot(from) };
  });
  let [x, y] = [0, 0]; // of the target, from the center
  let distance = minDistance;
  for (let pass = 0; ; pass++) {
    // A point appears at (its x - x of the target) / (distance - z), which must be within tanX.
    distance = minDistance;
    for (const p of seen) distance = Math.max(distance, p.z + Math.max(Math.abs(p.x - x) / (MARGIN * area.tanX), Math.abs(p.y - y) / (MARGIN * area.tanY)));
    distance = Math.min(maxDistance, distance);
    if (pass === CENTERINGS || distance === minDistance) break;
    const [low, high] = [new THREE.Vector2(Infinity, Infinity), new THREE.Vector2(-Infinity, -Infinity)];
    for (const p of seen) {
      const at = new THREE.Vector2(p.x - x, p.y - y).divideScalar(Math.max(0.1, distance - p.z));
      low.min(at);
      high.max(at);
    }
    x += (distance * (low.x + high.x)) / 2;
    y += (distance * (low.y + high.y)) / 2;
  }
  const target = center.addScaledVector(right, x).addScaledVector(up, y);
  return { target, position: target.clone().addScaledVector(from, distance) };
}

/** Half the height in m of an orthographic view along z that shows the box in the free area. */
export function frameFlat(box: THREE.Box3, { tanX, tanY }: Pick<FreeArea, 'tanX' | 'tanY'>, fov: number): number {
  const tan = Math.tan((fov * Math.PI) / 360);
  const size = box.getSize(new THREE.Vector3());
  return Math.max((size.x / 2 / MARGIN) * (tan / tanX), (size.y / 2 / MARGIN) * (tan / tanY));
}

const SCENE_ASPECT = 1.2; // width by height of the part of a view that a scene defines
const NARROW_DISTANCE_MAX = 2.4;

/** By which factor the view of a scene is more distant on a narrow screen, so that it shows the same width. */
export function narrowDistance(aspect: number): number {
  return Math.min(NARROW_DISTANCE_MAX, Math.max(1, SCENE_ASPECT / aspect));
}
