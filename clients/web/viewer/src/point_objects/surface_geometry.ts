// The triangles of a grid of points, whose positions are rewritten with every rendered frame. Normals
// are those of the surface through the neighbours of each point.

import * as THREE from 'three';

/** Two triangles per cell of a grid of columns x rows points, row by row. */
export function gridTriangles(columns: number, rows: number): Uint32Array {
  const cells = Math.max(0, columns - 1) * Math.max(0, rows - 1);
  const corners = new Uint32Array(6 * cells);
  let at = 0;
  for (let row = 0; row + 1 < rows; row++)
    for (let column = 0; column + 1 < columns; column++) {
      const a = row * columns + column;
      corners.set([a, a + columns, a + 1, a + 1, a + columns, a + columns + 1], at);
      at += 6;
    }
  return corners;
}

/** Normals of a grid: the cross product of the differences along columns and rows. */
export function gridNormals(positions: ArrayLike<number>, columns: number, rows: number, normals: Float32Array): void {
  const difference = (to: number, from: number, c: number) => positions[3 * to + c]! - positions[3 * from + c]!;
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const at = row * columns + column;
      const [left, right] = [column > 0 ? at - 1 : at, column + 1 < columns ? at + 1 : at];
      const [up, down] = [row > 0 ? at - columns : at, row + 1 < rows ? at + columns : at];
      const [ux, uy, uz] = [0, 1, 2].map((c) => difference(right, left, c)) as [number, number, number];
      const [vx, vy, vz] = [0, 1, 2].map((c) => difference(down, up, c)) as [number, number, number];
      const n = [vy * uz - vz * uy, vz * ux - vx * uz, vx * uy - vy * ux];
      const length = Math.hypot(...n) || 1;
      for (let c = 0; c < 3; c++) normals[3 * at + c] = n[c]! / length;
    }
}

/** A geometry with positions and normals of a constant number of points. */
export class SurfaceGeometry {
  readonly geometry = new THREE.BufferGeometry();
  readonly positions: Float32Array;
  readonly normals: Float32Array;

  constructor(points: number, triangles: Uint32Array) {
    this.positions = new Float32Array(3 * points);
    this.normals = new Float32Array(3 * points);
    for (const [name, array] of [
      ['position', this.positions],
      ['normal', this.normals],
    ] as const)
      this.geometry.setAttribute(name, new THREE.BufferAttribute(array, 3).setUsage(THREE.DynamicDrawUsage));
    this.geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  }

  /** The arrays were rewritten. */
  changed(): void {
    this.geometry.getAttribute('position').needsUpdate = true;
    this.geometry.getAttribute('normal').needsUpdate = true;
  }
}
