// Drawers of point objects, one per form: spheres, tubes, cloth, meshes and heights. A drawer belongs
// to one object and rewrites its geometry with every rendered frame.

import * as THREE from 'three';
import { subdivideGrid, subdivideStrand, type PointObjectView } from '@jostle/client';
import { PointForm } from '@jostle/client/gen/play_pb';
import { gridNormals, gridTriangles, SurfaceGeometry } from './surface_geometry';
import { ringsOf, tubeTriangles, writeTube } from './tube_geometry';

export interface PointDrawer {
  readonly object: THREE.Object3D;
  /** Draws the sampled positions of the object. */
  update(view: PointObjectView): void;
  dispose(): void;
}

const COLORS: Partial<Record<PointForm, number>> = {
  [PointForm.LOOSE]: 0x9ad1ff,
  [PointForm.STRANDS]: 0xc9a26b,
  [PointForm.GRID]: 0xd8574a,
  [PointForm.TRIANGLES]: 0xd8574a,
  [PointForm.HEIGHTS]: 0x6f9a5b,
};
const POINT_RADIUS = 0.025; // m, of points without a radius
const STRAND_RADIUS = 0.02; // m
const ROUND_POINTS_MAX = 2000; // more points are drawn with fewer triangles
const SMOOTH_POINTS_MAX = 4096; // larger objects are not subdivided
const STRAND_PARTS = 3;
const STRAND_SIDES = 8;
const GRID_PARTS = 2;

function material(form: PointForm, color: number | undefined): THREE.MeshStandardMaterial {
  const sheet = form !== PointForm.LOOSE && form !== PointForm.STRANDS;
  return new THREE.MeshStandardMaterial({
    color: color ?? COLORS[form] ?? 0xffffff,
    roughness: 0.8,
    side: sheet ? THREE.DoubleSide : THREE.FrontSide,
    shadowSide: sheet ? THREE.DoubleSide : null,
  });
}

function mesh(surface: SurfaceGeometry, look: THREE.Material): THREE.Mesh {
  const made = new THREE.Mesh(surface.geometry, look);
  made.castShadow = made.receiveShadow = true;
  made.frustumCulled = false; // the bounds change constantly
  return made;
}

/** Spheres of one size. */
class LooseDrawer implements PointDrawer {
  readonly object = new THREE.Group();
  private instances: THREE.InstancedMesh | undefined;
  private readonly look: THREE.Material;
  private readonly radius: number;

  constructor({ description }: PointObjectView) {
    this.look = material(PointForm.LOOSE, description.color);
    this.radius = description.radius || POINT_RADIUS;
  }

  update({ count, positions }: PointObjectView): void {
    const instances = this.reserve(count);
    instances.count = count;
    const { array } = instances.instanceMatrix;
    for (let k = 0; k < count; k++) for (let c = 0; c < 3; c++) array[16 * k + 12 + c] = positions[3 * k + c]!;
    instances.instanceMatrix.clearUpdateRanges();
    instances.instanceMatrix.addUpdateRange(0, 16 * count);
    instances.instanceMatrix.needsUpdate = true;
  }

  private reserve(count: number): THREE.InstancedMesh {
    if (this.instances && this.instances.instanceMatrix.count >= count) return this.instances;
    this.release();
    const capacity = Math.max(64, Math.ceil(1.5 * count));
    const made = new THREE.InstancedMesh(new THREE.IcosahedronGeometry(1, count > ROUND_POINTS_MAX ? 0 : 1), this.look, capacity);
    const { array } = made.instanceMatrix;
    array.fill(0);
    for (let k = 0; k < capacity; k++) {
      array[16 * k] = array[16 * k + 5] = array[16 * k + 10] = this.radius;
      array[16 * k + 15] = 1;
    }
    made.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    made.castShadow = made.receiveShadow = true;
    made.frustumCulled = false;
    this.object.add(made);
    return (this.instances = made);
  }

  private release(): void {
    if (!this.instances) return;
    this.object.remove(this.instances);
    this.instances.geometry.dispose();
    this.instances.dispose();
  }

  dispose(): void {
    this.release();
    this.look.dispose();
  }
}

/** Smooth tubes. */
class StrandDrawer implements PointDrawer {
  readonly object: THREE.Mesh;
  private readonly surface: SurfaceGeometry;
  private readonly parts: number;
  private readonly radius: number;

  constructor({ description, layout }: PointObjectView) {
    this.parts = layout.points > SMOOTH_POINTS_MAX ? 1 : STRAND_PARTS;
    this.radius = description.radius || STRAND_RADIUS;
    const rings = layout.strands.map((size) => ringsOf((size - 1) * this.parts + 1));
    this.surface = new SurfaceGeometry(STRAND_SIDES * rings.reduce((a, b) => a + b, 0), tubeTriangles(rings, STRAND_SIDES));
    this.object = mesh(this.surface, material(PointForm.STRANDS, description.color));
  }

  update({ layout, positions }: PointObjectView): void {
    let first = 0;
    let vertex = 0;
    for (const size of layout.strands) {
      const curve = subdivideStrand(positions, this.parts, first, size);
      const points = curve.length / 3;
      writeTube(curve, points, this.radius, STRAND_SIDES, this.surface.positions, this.surface.normals, vertex);
      first += size;
      vertex += ringsOf(points) * STRAND_SIDES;
    }
    this.surface.changed();
  }

  dispose(): void {
    this.surface.geometry.dispose();
    (this.object.material as THREE.Material).dispose();
  }
}

/** Cloth and heights. */
class GridDrawer implements PointDrawer {
  readonly object: THREE.Mesh;
  private readonly surface: SurfaceGeometry;
  private readonly parts: number;
  private readonly rows: number;

  constructor({ description, layout }: PointObjectView) {
    this.parts = layout.form === PointForm.HEIGHTS || layout.points > SMOOTH_POINTS_MAX ? 1 : GRID_PARTS;
    this.rows = layout.points / layout.columns;
    const [columns, rows] = this.fine(layout.columns);
    this.surface = new SurfaceGeometry(columns * rows, gridTriangles(columns, rows));
    this.object = mesh(this.surface, material(layout.form, description.color));
  }

  update({ layout, positions, count }: PointObjectView): void {
    const points = this.parts === 1 ? positions.subarray(0, 3 * count) : subdivideGrid(positions, layout.columns, this.rows, this.parts);
    this.surface.positions.set(points);
    gridNormals(points, ...this.fine(layout.columns), this.surface.normals);
    this.surface.changed();
  }

  private fine(columns: number): [number, number] {
    return [(columns - 1) * this.parts + 1, (this.rows - 1) * this.parts + 1];
  }

  dispose(): void {
    this.surface.geometry.dispose();
    (this.object.material as THREE.Material).dispose();
  }
}

class MeshDrawer implements PointDrawer {
  readonly object: THREE.Mesh;
  private readonly surface: SurfaceGeometry;

  constructor({ description, layout }: PointObjectView) {
    this.surface = new SurfaceGeometry(layout.points, Uint32Array.from(layout.triangles));
    this.object = mesh(this.surface, material(PointForm.TRIANGLES, description.color));
  }

  update({ positions, count }: PointObjectView): void {
    this.surface.positions.set(positions.subarray(0, 3 * count));
    this.surface.geometry.computeVertexNormals();
    this.surface.changed();
  }

  dispose(): void {
    this.surface.geometry.dispose();
    (this.object.material as THREE.Material).dispose();
  }
}

export function pointDrawer(view: PointObjectView): PointDrawer {
  switch (view.layout.form as PointForm) {
    case PointForm.STRANDS:
      return new StrandDrawer(view);
    case PointForm.GRID:
    case PointForm.HEIGHTS:
      return new GridDrawer(view);
    case PointForm.TRIANGLES:
      return new MeshDrawer(view);
    default:
      return new LooseDrawer(view);
  }
}
