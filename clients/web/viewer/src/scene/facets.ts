// Geometries of hulls, meshes and height fields, in m. Facets are flat; the attribute `edge` gives the
// shader the distance of a pixel to the nearest crease.

import * as THREE from 'three';
import { ConvexGeometry } from 'three/examples/jsm/geometries/ConvexGeometry.js';
import type { HeightField, Hull, Mesh } from '@jostle/client/gen/scene_pb';

const NO_EDGE = 1e4; // m: distance to an edge that is not a crease
const SAME_FACET = Math.cos((2 * Math.PI) / 180);
const CREASE = Math.cos((20 * Math.PI) / 180); // triangles of a mesh at a smaller angle form one surface

/** The convex hull of the points; undefined for too few or non-finite points. */
export function hullGeometry(hull: Hull): THREE.BufferGeometry | undefined {
  const points = hull.points.map((p) => new THREE.Vector3(p.x, p.y, p.z));
  if (points.length < 4 || !points.every((p) => Number.isFinite(p.lengthSq()))) return undefined;
  const convex = new ConvexGeometry(points);
  const corners = convex.getAttribute('position').array as Float32Array;
  if (corners.length === 0) return undefined;
  return facets(corners, SAME_FACET);
}

export function meshGeometry(mesh: Mesh): THREE.BufferGeometry | undefined {
  const corners: number[] = [];
  for (let i = 0; i + 2 < mesh.indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => mesh.vertices[mesh.indices[i + k]!]);
    if (a && b && c) corners.push(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  }
  if (corners.length === 0) return undefined;
  return facets(new Float32Array(corners), CREASE);
}

/**
 * Two triangles per cell, with the diagonal from (column, row) to (column + 1, row + 1); none in holes.
 */
export function fieldGeometry(field: HeightField): THREE.BufferGeometry | undefined {
  const { columns, rows, heights } = field;
  if (columns < 2 || rows < 2 || heights.length < columns * rows) return undefined;
  const positions = new Float32Array(columns * rows * 3);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const at = row * columns + column;
      const height = heights[at]!;
      positions[3 * at] = (column - (columns - 1) / 2) * field.spacingX;
      positions[3 * at + 1] = Number.isFinite(height) ? height : 0;
      positions[3 * at + 2] = (row - (rows - 1) / 2) * field.spacingZ;
    }
  const open = new Set(field.holes);
  const indices: number[] = [];
  for (let row = 0; row + 1 < rows; row++)
    for (let column = 0; column + 1 < columns; column++) {
      if (open.has(row * (columns - 1) + column)) continue;
      const near = row * columns + column;
      const far = near + columns; // the next row
      // A non-finite height opens the cells around it.
      if (![near, near + 1, far, far + 1].every((at) => Number.isFinite(heights[at]!))) continue;
      indices.push(near, far, far + 1, near, far + 1, near + 1);
    }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setIndex(indices);
  geometry.computeVertexNormals(); // the material is flat shaded; normals only offset shadows
  return geometry;
}

/** Number of flat faces of a facet geometry: connected coplanar triangles count once. */
export function countFacets(geometry: THREE.BufferGeometry): number {
  const edge = geometry.getAttribute('edge');
  let hidden = 0;
  for (let corner = 0; corner < edge.count; corner++) if (edge.getComponent(corner, corner % 3) >= NO_EDGE) hidden++;
  return edge.count / 3 - hidden / 2; // a hidden side joins two triangles and is counted by both
}

/** Triangles of three corners each, with a normal per triangle and the distances to its three sides. */
function facets(corners: Float32Array, creaseCosine: number): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
  geometry.computeVertexNormals(); // flat, because there is no index
  const normals = geometry.getAttribute('normal').array as Float32Array;
  geometry.setAttribute('edge', new THREE.BufferAttribute(edgeDistances(corners, normals, creaseCosine), 3));
  return geometry;
}

// Component k of a corner is its distance from the side opposite corner k of its triangle. It is 0 on
// that side, so linear interpolation gives the exact distance.
function edgeDistances(corners: Float32Array, normals: Float32Array, creaseCosine: number): Float32Array {
  const count = corners.length / 3;
  const vertices = weld(corners);
  // Side k of a triangle runs from corner k + 1 to corner k + 2. The first two triangles of a side
  // decide.
  const sides = new Map<number, number[]>();
  for (let corner = 0; corner < count; corner++) {
    const first = corner - (corner % 3);
    const from = vertices[first + ((corner + 1) % 3)]!;
    const to = vertices[first + ((corner + 2) % 3)]!;
    const key = Math.min(from, to) * count + Math.max(from, to);
    const known = sides.get(key);
    if (known) known.push(corner);
    else sides.set(key, [corner]);
  }
  const creased = new Uint8Array(count).fill(1);
  for (const [one, two, ...more] of sides.values()) {
    if (two === undefined || more.length > 0) continue; // a border, or more than two triangles
    let cosine = 0;
    for (let c = 0; c < 3; c++) cosine += normals[3 * one! + c]! * normals[3 * two + c]!;
    if (cosine >= creaseCosine) creased[one!] = creased[two] = 0;
  }
  const out = new Float32Array(corners.length);
  const [a, b, c] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  for (let first = 0; first < count; first += 3)
    for (let k = 0; k < 3; k++) {
      if (creased[first + k] === 0) {
        for (let corner = 0; corner < 3; corner++) out[3 * (first + corner) + k] = NO_EDGE;
        continue;
      }
      a.fromArray(corners, 3 * (first + k));
      b.fromArray(corners, 3 * (first + ((k + 1) % 3)));
      c.fromArray(corners, 3 * (first + ((k + 2) % 3)));
      const side = c.sub(b);
      const length = side.length();
      const doubleArea = side.cross(a.sub(b)).length();
      out[3 * (first + k) + k] = length > 0 ? doubleArea / length : 0;
    }
  return out;
}

/** A vertex number per corner; coincident corners share it. */
function weld(corners: Float32Array): Uint32Array {
  const numbers = new Map<string, number>();
  const out = new Uint32Array(corners.length / 3);
  for (let i = 0; i < out.length; i++) {
    const key = `${corners[3 * i]},${corners[3 * i + 1]},${corners[3 * i + 2]}`;
    let number = numbers.get(key);
    if (number === undefined) numbers.set(key, (number = numbers.size));
    out[i] = number;
  }
  return out;
}
