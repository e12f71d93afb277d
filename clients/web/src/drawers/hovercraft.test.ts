import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { hovercraft, readHovercraft } from './hovercraft';
import { testDrawing } from './test_drawing';

// Written by hand: entity 258; thrusters at the corners of 2 by 2 m, half a metre below the origin. The first has a ray of 4 m and full
// thrust, the last none of either.
const HIGH = [0xff, 0xbf]; // 49151: 1 m, to a step
const LOW = [0x00, 0x40]; // 16384: -1 m
const BELOW = [0xff, 0x5f]; // 24575: -0.5 m
const CHUNK = new Uint8Array([
  ...[2, 1, 0, 0],
  ...[...HIGH, ...BELOW, ...HIGH, 0xff, 0xff, 255],
  ...[...LOW, ...BELOW, ...HIGH, 0xff, 0x3f, 51],
  ...[...HIGH, ...BELOW, ...LOW, 0x00, 0x40, 0],
  ...[...LOW, ...BELOW, ...LOW, 0, 0, 0],
]);

const drawn = (bytes: Uint8Array, pose: number[] | undefined) => {
  let asked = 0;
  const drawing = testDrawing((entity) => ((asked = entity), pose));
  const { lines } = drawing;
  hovercraft.draw!(bytes, drawing);
  lines.end();
  const points = lines.object.geometry.getAttribute('position');
  const colors = lines.object.geometry.getAttribute('color');
  const at = (k: number) => [points.getX(k), points.getY(k), points.getZ(k)];
  const colorAt = (k: number) => new THREE.Color(colors.getX(k), colors.getY(k), colors.getZ(k)).getHex();
  return { asked, count: lines.count, at, colorAt };
};

describe('hovercraft', () => {
  it('is read as WIRE.md says', () => {
    const craft = readHovercraft(CHUNK)!;
    expect(craft.entity).toBe(258);
    expect(craft.thrusters.length).toBe(4);
    const [first, second, , last] = craft.thrusters;
    first!.position.forEach((x, axis) => expect(x).toBeCloseTo([1, -0.5, 1][axis]!, 3));
    expect(first!.ray).toBe(4);
    expect(first!.thrust).toBe(1);
    expect(second!.position[0]).toBeCloseTo(-1, 3);
    expect(second!.ray).toBeCloseTo(1, 3);
    expect(second!.thrust).toBe(0.2);
    expect(last).toMatchObject({ ray: 0, thrust: 0 });
  });

  it('is read from the middle of a message', () => {
    const message = new Uint8Array(CHUNK.length + 7);
    message.set(CHUNK, 5);
    expect(readHovercraft(message.subarray(5, 5 + CHUNK.length))).toEqual(readHovercraft(CHUNK));
  });

  it('draws a line from each thruster down, warmer the more it thrusts', () => {
    const { asked, count, at, colorAt } = drawn(CHUNK, [10, 20, 30, 0, 0, 0, 1]);
    expect(asked).toBe(258);
    expect(count).toBe(8);
    at(0).forEach((x, axis) => expect(x).toBeCloseTo([11, 19.5, 31][axis]!, 3));
    at(1).forEach((x, axis) => expect(x).toBeCloseTo([11, 15.5, 31][axis]!, 3));
    expect(colorAt(0)).toBe(0xffb347);
    expect(colorAt(1)).toBe(0xffb347);
    expect(colorAt(7)).toBe(0x3d7cc9);
  });

  it('turns with its craft: upside down its rays go up', () => {
    const { at } = drawn(CHUNK, [0, 0, 0, 1, 0, 0, 0]);
    at(0).forEach((x, axis) => expect(x).toBeCloseTo([1, 0.5, -1][axis]!, 3));
    at(1).forEach((x, axis) => expect(x).toBeCloseTo([1, 4.5, -1][axis]!, 3));
  });

  it('draws nothing of bytes that end early or go on, or of a craft that is not there', () => {
    const pose = [0, 0, 0, 0, 0, 0, 1];
    for (let size = 0; size < CHUNK.length; size++) expect(drawn(CHUNK.slice(0, size), pose).count).toBe(0);
    expect(drawn(new Uint8Array([...CHUNK, 0]), pose).count).toBe(0);
    expect(drawn(CHUNK, undefined).count).toBe(0);
  });
});
