// Encodes the shapes of a body as the numbers that the predictor decodes
// (clients/cpp/prediction/wasm/shape_encoding.h).

import { Combine, type Shape } from '../gen/jostle/v1/scene_pb.js';

type Point = { readonly x: number; readonly y: number; readonly z: number };

const DEFAULT_DENSITY = 1000; // kg/m^3
const ORIGIN: Point = { x: 0, y: 0, z: 0 };
const UP: Point = { x: 0, y: 1, z: 0 };
const ALL_CATEGORIES = 0xffffffff;

/** undefined: the solver of the predictor does not support a shape, or the shape is unknown. */
export function encodeShapes(shapes: readonly Shape[]): number[] | undefined {
  const out: number[] = [shapes.length];
  for (const shape of shapes) {
    if (!putGeometry(out, shape, false)) return undefined;
    putMaterial(out, shape);
  }
  return out;
}

function put(out: number[], { x, y, z }: Point): void {
  out.push(x, y, z);
}

/** Combine rule, from 0. */
const rule = (value: Combine, fallback: Combine) => (value === Combine.UNSPECIFIED ? fallback : value) - 1;

function putMaterial(out: number[], shape: Shape): void {
  out.push(shape.friction ?? 0.5, shape.restitution ?? 0, shape.rollingFriction ?? 0, shape.torsionalFriction ?? 0);
  put(out, shape.surfaceVelocity ?? ORIGIN);
  out.push(rule(shape.frictionRule, Combine.GEOMETRIC_MEAN), rule(shape.restitutionRule, Combine.MAXIMUM));
  const { filter } = shape;
  out.push(filter?.category ?? 1, filter?.mask ?? ALL_CATEGORIES, filter?.group ?? 0, shape.trigger ? 1 : 0);
  out.push(shape.density ?? DEFAULT_DENSITY, shape.mass ?? 0);
}

function putGeometry(out: number[], shape: Shape, inside: boolean): boolean {
  const { kind, position, rotation: q } = shape;
  const begin = (number: number) => {
    out.push(number);
    put(out, position ?? ORIGIN);
    out.push(q?.x ?? 0, q?.y ?? 0, q?.z ?? 0, q ? q.w : 1);
  };
  switch (kind.case) {
    case 'sphere':
      begin(1);
      out.push(kind.value.radius);
      return true;
    case 'capsule':
      begin(2);
      out.push(kind.value.radius, kind.value.halfLength);
      return true;
    case 'box':
      begin(3);
      put(out, kind.value.halfExtents ?? ORIGIN);
      return true;
    case 'plane':
      begin(4);
      put(out, kind.value.normal ?? UP);
      return true;
    case 'cylinder':
    case 'cone':
      begin(kind.case === 'cylinder' ? 5 : 6);
      out.push(kind.value.radius, kind.value.halfLength);
      return true;
    case 'hull':
      begin(7);
      out.push(kind.value.points.length);
      for (const point of kind.value.points) put(out, point);
      return true;
    case 'mesh': {
      const { vertices, indices } = kind.value;
      if (indices.length % 3 !== 0) return false;
      begin(8);
      out.push(vertices.length);
      for (const vertex of vertices) put(out, vertex);
      out.push(indices.length / 3);
      for (const index of indices) out.push(index);
      return true;
    }
    case 'heightField': {
      const { columns, rows, spacingX, spacingZ, heights, holes } = kind.value;
      if (heights.length !== columns * rows) return false;
      begin(9);
      out.push(columns, rows, spacingX, spacingZ);
      for (const height of heights) out.push(height);
      out.push(holes.length);
      for (const hole of holes) out.push(hole);
      return true;
    }
    case 'compound':
      if (inside) return false;
      begin(10);
      out.push(kind.value.children.length);
      return kind.value.children.every((child) => putGeometry(out, child, true));
    default:
      return false;
  }
}
