import { describe, expect, it } from 'vitest';
import { VertexBuffer } from '../vertex_buffer';
import { drawVehicles, readCars } from './vehicle';

// Written by hand: entity 7 in second gear with one wheel of half a metre, a quarter of a metre wide, at the origin of the chassis but
// a metre ahead; it touches, slides, has turned by a quarter and steers by nothing.
const CAR = new Uint8Array([
  ...[7, 0, 0, 0, 3, 128, 1],
  ...[64, 64, 0xff, 0x7f, 0xff, 0x7f, 0xff, 0x6f, 3, 0x00, 0x40, 0xff, 0x7f, 0xff, 0x7f],
]);

describe('vehicle', () => {
  it('is read as the module writes it', () => {
    const [car] = readCars(CAR)!;
    expect(car).toMatchObject({ entity: 7, gear: 2 });
    const [wheel] = car!.wheels;
    expect(wheel!.radius).toBeCloseTo(0.5, 2);
    expect(wheel!.width).toBeCloseTo(0.25, 2);
    expect(wheel!.center[2]).toBeCloseTo(-1, 3);
    expect(wheel).toMatchObject({ touches: true, slides: true });
    expect(wheel!.angle).toBeCloseTo(Math.PI / 2, 3);
    expect(wheel!.steering).toBeCloseTo(0, 3);
  });
  it('is nothing when bytes are missing', () => {
    for (let end = 1; end < CAR.length; end++) expect(readCars(CAR.subarray(0, end))).toBeUndefined();
    expect(readCars(new Uint8Array())).toEqual([]);
  });
  it('is drawn as two rims with spokes, where the chassis is', () => {
    const lines = VertexBuffer.lines(1);
    lines.begin();
    drawVehicles(CAR, { lines, poseOf: (entity) => (entity === 7 ? [10, 0, 0, 0, 0, 0, 1] : undefined) });
    lines.end();
    expect(lines.count).toBe(2 * (16 + 4) * 2);
    const points = lines.object.geometry.getAttribute('position');
    for (let k = 0; k < lines.count; k++) {
      expect(Math.abs(points.getX(k) - 10)).toBeCloseTo(0.125, 2);
      expect(Math.hypot(points.getY(k), points.getZ(k) + 1)).toBeLessThan(0.52);
    }
  });
});
