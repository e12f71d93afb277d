// The part of a world that a camera should show: bodies that rolled or fell away are ignored.

import * as THREE from 'three';

export interface PlacedBody {
  readonly box: THREE.Box3; // m
  readonly dynamic: boolean;
}

const FENCE = 3; // interquartile ranges beyond the quartiles
const FENCE_MIN = 6; // m
const STRAYS_MAX = 0.2; // share of the dynamic bodies; if more are far away, they belong to the scene

/** Corners of the boxes of all bodies except strays. */
export function sceneExtent(bodies: readonly PlacedBody[]): THREE.Vector3[] {
  return bodiesInScene(bodies).flatMap(({ box: { min, max } }) =>
    [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new THREE.Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z)),
  );
}

function bodiesInScene(bodies: readonly PlacedBody[]): readonly PlacedBody[] {
  const fixed = bodies.filter(({ dynamic }) => !dynamic);
  const moving = bodies.filter(({ dynamic }) => dynamic);
  if (moving.length === 0) return fixed;
  const fence = fenceOf(moving.map(({ box }) => box.getCenter(new THREE.Vector3())));
  // A dynamic body within the static parts of a scene is where it belongs.
  for (const { box } of fixed) fence.union(box);
  const near = moving.filter(({ box }) => fence.containsPoint(box.getCenter(new THREE.Vector3())));
  return near.length < (1 - STRAYS_MAX) * moving.length ? bodies : [...fixed, ...near];
}

/** Tukey's fence along each axis. */
function fenceOf(centers: readonly THREE.Vector3[]): THREE.Box3 {
  const fence = new THREE.Box3();
  for (const axis of ['x', 'y', 'z'] as const) {
    const sorted = centers.map((center) => center[axis]).sort((a, b) => a - b);
    const quartile = (share: number) => sorted[Math.round(share * (sorted.length - 1))]!;
    const [low, high] = [quartile(0.25), quartile(0.75)];
    const margin = Math.max(FENCE_MIN, FENCE * (high - low));
    fence.min[axis] = low - margin;
    fence.max[axis] = high + margin;
  }
  return fence;
}
