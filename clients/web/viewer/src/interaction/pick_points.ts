// Picks ropes and cloth. A ray that passes a rope within a few pixels hits it.

import * as THREE from 'three';
import type { PointObjectView } from '@jostle/client';
import { PointForm } from '@jostle/client/gen/play_pb';

export interface PointPick {
  readonly object: number; // id of the point object
  readonly point: THREE.Vector3;
  readonly distance: number; // m from the ray origin
}

const TOLERANCE = 0.012; // rad: about ten pixels

/** The first rope or cloth on a ray. */
export function pickPoints(objects: ReadonlyMap<number, PointObjectView>, ray: THREE.Ray): PointPick | undefined {
  let first: PointPick | undefined;
  for (const [object, view] of objects) {
    if (!view.hasPoints || view.description.entity !== 0) continue;
    const point = view.layout.form === PointForm.STRANDS ? pickStrands(view, ray) : pickSheet(view, ray);
    const distance = point?.distanceTo(ray.origin) ?? Infinity;
    if (point && distance < (first?.distance ?? Infinity)) first = { object, point, distance };
  }
  return first;
}

const pointAt = (view: PointObjectView, index: number): THREE.Vector3 => new THREE.Vector3().fromArray(view.positions, 3 * index);

function pickStrands(view: PointObjectView, ray: THREE.Ray): THREE.Vector3 | undefined {
  const onRay = new THREE.Vector3();
  const onStrand = new THREE.Vector3();
  let picked: THREE.Vector3 | undefined;
  let nearest = Infinity;
  let start = 0;
  for (const size of view.layout.strands) {
    for (let k = start; k + 1 < start + size; k++) {
      const apart = Math.sqrt(ray.distanceSqToSegment(pointAt(view, k), pointAt(view, k + 1), onRay, onStrand));
      const distance = onRay.distanceTo(ray.origin);
      if (apart > Math.max(view.description.radius, TOLERANCE * distance) || distance >= nearest) continue;
      nearest = distance;
      picked = onStrand.clone();
    }
    start += size;
  }
  return picked;
}

/** Indices of the corners of all triangles of a sheet. */
function* trianglesOf({ layout }: PointObjectView): Generator<[number, number, number]> {
  if (layout.form === PointForm.TRIANGLES)
    for (let k = 0; k + 2 < layout.triangles.length; k += 3) yield [layout.triangles[k]!, layout.triangles[k + 1]!, layout.triangles[k + 2]!];
  if (layout.form !== PointForm.GRID) return;
  for (let k = 0; k + layout.columns + 1 < layout.points; k++) {
    if ((k + 1) % layout.columns === 0) continue;
    yield [k, k + 1, k + layout.columns];
    yield [k + 1, k + layout.columns + 1, k + layout.columns];
  }
}

function pickSheet(view: PointObjectView, ray: THREE.Ray): THREE.Vector3 | undefined {
  const hit = new THREE.Vector3();
  let picked: THREE.Vector3 | undefined;
  for (const [a, b, c] of trianglesOf(view)) {
    if (!ray.intersectTriangle(pointAt(view, a), pointAt(view, b), pointAt(view, c), false, hit)) continue;
    if (!picked || hit.distanceToSquared(ray.origin) < picked.distanceToSquared(ray.origin)) picked = hit.clone();
  }
  return picked;
}
