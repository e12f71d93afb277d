import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { withValue } from '../testing/golden_modules';
import { testRenderContext } from '../testing/test_render_context';
import { hovercraft, readThrusters } from './hovercraft';

// Handwritten: thrusters at the corners of 2 m by 2 m, 0.5 m below the origin. The first has a ray of 4
// m and full thrust, the last has neither.
const HIGH = 49151; // 1 m, to a step
const LOW = 16384; // -1 m
const BELOW = 24575; // -0.5 m
const VALUES = new Int32Array([
  ...[HIGH, BELOW, HIGH, 65535, 255],
  ...[LOW, BELOW, HIGH, 16383, 51],
  ...[HIGH, BELOW, LOW, 16384, 0],
  ...[LOW, BELOW, LOW, 0, 0],
]);

const render = (values: Int32Array, pose: number[] | undefined) => {
  let requestedEntity = 0;
  const context = testRenderContext((entity) => ((requestedEntity = entity), pose));
  const { lines } = context;
  hovercraft.draw!([{ entity: 258, values, seconds: 0 }], context);
  lines.end();
  const points = lines.object.geometry.getAttribute('position');
  const colors = lines.object.geometry.getAttribute('color');
  const at = (k: number) => [points.getX(k), points.getY(k), points.getZ(k)];
  const colorAt = (k: number) => new THREE.Color(colors.getX(k), colors.getY(k), colors.getZ(k)).getHex();
  return { requestedEntity, count: lines.count, at, colorAt };
};

describe('hovercraft', () => {
  it('is decoded as specified in WIRE.md', () => {
    const [first, second, , last] = readThrusters(VALUES)!;
    first!.position.forEach((x, axis) => expect(x).toBeCloseTo([1, -0.5, 1][axis]!, 3));
    expect(first!.ray).toBe(4);
    expect(first!.thrust).toBe(1);
    expect(second!.position[0]).toBeCloseTo(-1, 3);
    expect(second!.ray).toBeCloseTo(1, 3);
    expect(second!.thrust).toBe(0.2);
    expect(last).toMatchObject({ ray: 0, thrust: 0 });
  });

  it('draws a downward line per thruster, colored by thrust', () => {
    const { requestedEntity, count, at, colorAt } = render(VALUES, [10, 20, 30, 0, 0, 0, 1]);
    expect(requestedEntity).toBe(258);
    expect(count).toBe(8);
    at(0).forEach((x, axis) => expect(x).toBeCloseTo([11, 19.5, 31][axis]!, 3));
    at(1).forEach((x, axis) => expect(x).toBeCloseTo([11, 15.5, 31][axis]!, 3));
    expect(colorAt(0)).toBe(0xffb347);
    expect(colorAt(1)).toBe(0xffb347);
    expect(colorAt(7)).toBe(0x3d7cc9);
  });

  it('rotates the rays with the craft', () => {
    const { at } = render(VALUES, [0, 0, 0, 1, 0, 0, 0]);
    at(0).forEach((x, axis) => expect(x).toBeCloseTo([1, 0.5, -1][axis]!, 3));
    at(1).forEach((x, axis) => expect(x).toBeCloseTo([1, 4.5, -1][axis]!, 3));
  });

  it('draws nothing for truncated or oversized data or an unknown entity', () => {
    const pose = [0, 0, 0, 0, 0, 0, 1];
    for (let size = 0; size < VALUES.length; size++) expect(render(VALUES.slice(0, size), pose).count).toBe(0);
    expect(render(new Int32Array([...VALUES, 0]), pose).count).toBe(0);
    expect(render(withValue(VALUES, 4, 256), pose).count).toBe(0);
    expect(render(VALUES, undefined).count).toBe(0);
  });
});
