// Shapes as parts that can be rendered. Spheres, boxes and the like are scaled unit geometries; hulls,
// meshes and height fields have geometries of their own.

import * as THREE from 'three';
import { contentKey, keyOf } from './content_key';
import { fieldGeometry, hullGeometry, meshGeometry } from './facets';
import type { Hull, Mesh, Shape } from '@jostle/client/gen/scene_pb';

/** slab: a box wide enough to be ground; cap: an end of a capsule; tube: its middle. */
export type UnitKind = 'box' | 'slab' | 'plane' | 'sphere' | 'cap' | 'tube' | 'cylinder' | 'cone';
export const UNIT_KINDS: readonly UnitKind[] = ['box', 'slab', 'plane', 'sphere', 'cap', 'tube', 'cylinder', 'cone'];
export type OwnKind = 'hull' | 'mesh' | 'field';
export type Kind = UnitKind | OwnKind;

export interface ShapePart {
  readonly kind: Kind;
  /** Parts with the same key share a geometry. */
  readonly key: string;
  /** Creates the geometry; undefined if there is nothing to render. */
  readonly geometry: () => THREE.BufferGeometry | undefined;
  readonly local: THREE.Matrix4;
}

export const UNIT_GEOMETRIES: Record<UnitKind, () => THREE.BufferGeometry> = {
  box: () => new THREE.BoxGeometry(2, 2, 2),
  slab: () => new THREE.BoxGeometry(2, 2, 2),
  plane: gradedPlane,
  sphere: () => new THREE.SphereGeometry(1, 28, 18),
  cap: () => new THREE.SphereGeometry(1, 20, 8, 0, Math.PI * 2, 0, Math.PI / 2),
  tube: () => new THREE.CylinderGeometry(1, 1, 2, 20, 1, true),
  cylinder: () => new THREE.CylinderGeometry(1, 1, 2, 32),
  cone: () => new THREE.ConeGeometry(1, 2, 32, 6),
};

/** A square whose parts are small near the center: the depth of one triangle of 4 km is off by 0.2 m in places. */
function gradedPlane(): THREE.BufferGeometry {
  const geometry = new THREE.PlaneGeometry(2, 2, 6, 6).rotateX(-Math.PI / 2);
  const points = geometry.getAttribute('position');
  for (let k = 0; k < points.count; k++) points.setXYZ(k, points.getX(k) ** 5, 0, points.getZ(k) ** 5);
  return geometry;
}

const SLAB_HALF = 30; // m
const PLANE_HALF = 2000; // m, beyond the fog
const UP = new THREE.Vector3(0, 1, 0);
const ONE = new THREE.Vector3(1, 1, 1);
const UPSIDE_DOWN = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(1, 0, 0), Math.PI);

/** `parent`: pose of the enclosing compound in the body. */
export function partsOf(shape: Shape, parent = new THREE.Matrix4()): ShapePart[] {
  const frame = parent.clone().multiply(localMatrix(shape));
  const part = (kind: UnitKind, scale: THREE.Vector3, along = 0, rotation = new THREE.Quaternion()): ShapePart => {
    const local = new THREE.Matrix4().compose(new THREE.Vector3(0, along, 0), rotation, scale);
    return { kind, key: kind, geometry: UNIT_GEOMETRIES[kind], local: local.premultiply(frame) };
  };
  const own = (kind: OwnKind, key: string, geometry: ShapePart['geometry']): ShapePart[] => [
    { kind, key, geometry, local: frame },
  ];
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
        part('tube', new THREE.Vector3(r, h, r)),
        part('cap', round, h),
        part('cap', round, -h, UPSIDE_DOWN),
      ];
    }
    case 'cylinder':
    case 'cone': {
      const { radius: r, halfLength: h } = shape.kind.value;
      return [part(shape.kind.case, new THREE.Vector3(r, h, r))];
    }
    case 'plane': {
      const n = shape.kind.value.normal;
      const normal = n ? new THREE.Vector3(n.x, n.y, n.z).normalize() : UP;
      const rotation = new THREE.Quaternion().setFromUnitVectors(UP, normal);
      return [part('plane', new THREE.Vector3(PLANE_HALF, 1, PLANE_HALF), 0, rotation)];
    }
    case 'hull': {
      const hull = shape.kind.value;
      return own('hull', keyOf(hull, () => contentKey('hull', coordinates(hull.points))), () => hullGeometry(hull));
    }
    case 'mesh': {
      const mesh = shape.kind.value;
      const key = keyOf(mesh, () => contentKey('mesh', coordinates(mesh.vertices), mesh.indices));
      return own('mesh', key, () => meshGeometry(mesh));
    }
    case 'heightField': {
      const field = shape.kind.value;
      const grid = [field.columns, field.rows, field.spacingX, field.spacingZ];
      const key = keyOf(field, () => contentKey('field', grid, field.heights, field.holes));
      return own('field', key, () => fieldGeometry(field));
    }
    case 'compound':
      return shape.kind.value.children.flatMap((child) => partsOf(child, frame));
    default:
      return [];
  }
}

function localMatrix({ position: p, rotation: q }: Shape): THREE.Matrix4 {
  const turn = q ? new THREE.Quaternion(q.x, q.y, q.z, q.w) : new THREE.Quaternion();
  if (turn.lengthSq() === 0) turn.identity();
  const translation = p ? new THREE.Vector3(p.x, p.y, p.z) : new THREE.Vector3();
  return new THREE.Matrix4().compose(translation, turn.normalize(), ONE);
}

function* coordinates(points: Hull['points'] | Mesh['vertices']): Iterable<number> {
  for (const { x, y, z } of points) {
    yield x;
    yield y;
    yield z;
  }
}
