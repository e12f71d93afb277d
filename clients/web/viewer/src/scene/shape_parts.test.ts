import { create, type MessageInitShape } from '@bufbuild/protobuf';
import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { ShapeSchema } from '@jostle/client/gen/scene_pb';
import { partsOf, UNIT_GEOMETRIES } from './shape_parts';

const shape = (init: MessageInitShape<typeof ShapeSchema>) => create(ShapeSchema, init);
const ball = (x: number) => shape({ kind: { case: 'sphere', value: { radius: 0.5 } }, position: { x, y: 0, z: 0 } });

/** A point of the unit geometry in the frame of the body. */
function inBody(part: { local: THREE.Matrix4 }, x: number, y: number, z: number): number[] {
  return new THREE.Vector3(x, y, z)
    .applyMatrix4(part.local)
    .toArray()
    .map((n) => Math.round(n * 1e6) / 1e6 + 0);
}

describe('parts of shapes', () => {
  it('a cone points along y', () => {
    const [cone] = partsOf(shape({ kind: { case: 'cone', value: { radius: 0.5, halfLength: 2 } } }));
    expect(cone!.kind).toBe('cone');
    expect(inBody(cone!, 0, 1, 0)).toEqual([0, 2, 0]);
    expect(inBody(cone!, 1, -1, 0)).toEqual([0.5, -2, 0]);
    // The unit geometry has its tip at y = 1, too.
    const at = UNIT_GEOMETRIES.cone().getAttribute('position');
    for (let i = 0; i < at.count; i++)
      expect(Math.hypot(at.getX(i), at.getZ(i))).toBeLessThanOrEqual((1 - at.getY(i)) / 2 + 1e-6);
  });

  it('a capsule is a tube with two caps, and a cylinder includes its ends', () => {
    const kinds = (init: 'capsule' | 'cylinder') =>
      partsOf(shape({ kind: { case: init, value: { radius: 1, halfLength: 1 } } })).map((part) => part.kind);
    expect(kinds('capsule')).toEqual(['tube', 'cap', 'cap']);
    expect(kinds('cylinder')).toEqual(['cylinder']);
  });

  it('a compound places its children in its local frame', () => {
    // A quarter turn about z: the child's x is the body's y.
    const quarter = { x: 0, y: 0, z: Math.SQRT1_2, w: Math.SQRT1_2 };
    const dumbbell = shape({
      kind: { case: 'compound', value: { children: [ball(-2), ball(2)] } },
      position: { x: 0, y: 10, z: 0 },
      rotation: quarter,
    });
    const parts = partsOf(dumbbell);
    expect(parts.map((part) => part.kind)).toEqual(['sphere', 'sphere']);
    expect(inBody(parts[0]!, 0, 0, 0)).toEqual([0, 8, 0]);
    expect(inBody(parts[1]!, 0, 0, 0)).toEqual([0, 12, 0]);
    expect(inBody(parts[1]!, 1, 0, 0)).toEqual([0, 12.5, 0]);
  });

  it('equal hulls share a key regardless of their pose', () => {
    const points = [0, 1, 2, 3].map((k) => ({ x: k, y: k * k, z: k * k * k }));
    const hull = (x: number) => shape({ kind: { case: 'hull', value: { points } }, position: { x, y: 0, z: 0 } });
    const [one] = partsOf(hull(0));
    const [two] = partsOf(hull(5));
    expect(one!.key).toBe(two!.key);
    expect(inBody(two!, 1, 0, 0)).toEqual([6, 0, 0]);
    points[3]!.z += 0.1;
    expect(partsOf(hull(0))[0]!.key).not.toBe(one!.key);
  });

  it('a shape without a kind has no parts', () => {
    expect(partsOf(shape({}))).toEqual([]);
  });
});

it('the parts of a plane are small near its center and cover it', () => {
  const points = UNIT_GEOMETRIES.plane().getAttribute('position');
  const columns = [...new Set(Array.from({ length: points.count }, (_, k) => Math.abs(points.getX(k))))].sort((a, b) => a - b);
  expect([columns.length, columns[0], columns.at(-1)]).toEqual([4, 0, 1]);
  expect(columns[1]! * 2000).toBeLessThan(10); // m
});
