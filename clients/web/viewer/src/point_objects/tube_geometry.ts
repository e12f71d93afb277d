// Tubes around polylines, rewritten with every rendered frame. The ring of each point is perpendicular
// to the curve; from ring to ring it turns only as far as the curve does (Wang et al., "Computation of
// rotation minimizing frames", 2008, with projection instead of double reflection).

import * as THREE from 'three';

/** Rings of a tube around a curve: one per point, and one of radius 0 at each end, which closes it. */
export const ringsOf = (points: number): number => points + 2;

/** Triangles between the rings of tubes; `sizes`: number of rings of each tube. */
export function tubeTriangles(sizes: readonly number[], sides: number): Uint32Array {
  const corners: number[] = [];
  let first = 0;
  for (const rings of sizes) {
    for (let ring = 0; ring + 1 < rings; ring++)
      for (let side = 0; side < sides; side++) {
        const a = first + ring * sides + side;
        const b = first + ring * sides + ((side + 1) % sides);
        corners.push(a, b, a + sides, b, b + sides, a + sides);
      }
    first += rings * sides;
  }
  return Uint32Array.from(corners);
}

const tangent = new THREE.Vector3();
const normal = new THREE.Vector3();
const binormal = new THREE.Vector3();

/**
 * Writes the rings of one tube: `curve` has x y z of each of `points` points; the first vertex is `first`.
 */
export function writeTube(curve: ArrayLike<number>, points: number, radius: number, sides: number, positions: Float32Array, normals: Float32Array, first: number): void {
  normal.set(0, 0, 0);
  const cap = (point: number, ring: number, sign: number) => {
    for (let side = 0; side < sides; side++)
      for (let c = 0; c < 3; c++) {
        const at = 3 * (first + ring * sides + side) + c;
        positions[at] = curve[3 * point + c]!;
        normals[at] = sign * tangent.getComponent(c);
      }
  };
  for (let point = 0; point < points; point++) {
    const [before, after] = [Math.max(0, point - 1), Math.min(points - 1, point + 1)];
    tangent.set(...([0, 1, 2].map((c) => curve[3 * after + c]! - curve[3 * before + c]!) as [number, number, number]));
    if (tangent.lengthSq() < 1e-16) tangent.set(0, 1, 0);
    tangent.normalize();
    normal.addScaledVector(tangent, -normal.dot(tangent));
    if (normal.lengthSq() < 1e-6) {
      normal.set(Math.abs(tangent.y) < 0.9 ? 0 : 1, Math.abs(tangent.y) < 0.9 ? 1 : 0, 0);
      normal.addScaledVector(tangent, -normal.dot(tangent));
    }
    normal.normalize();
    binormal.crossVectors(tangent, normal);
    if (point === 0) cap(0, 0, -1);
    if (point === points - 1) cap(point, points + 1, 1);
    for (let side = 0; side < sides; side++) {
      const angle = (2 * Math.PI * side) / sides;
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      const at = 3 * (first + (point + 1) * sides + side);
      for (let c = 0; c < 3; c++) {
        const n = cos * normal.getComponent(c) + sin * binormal.getComponent(c);
        normals[at + c] = n;
        positions[at + c] = curve[3 * point + c]! + radius * n;
      }
    }
  }
}
