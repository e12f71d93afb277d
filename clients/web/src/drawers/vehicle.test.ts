import { describe, expect, it } from 'vitest';
import { VertexBuffer } from '../vertex_buffer';
import { drawVehicle, readCar } from './vehicle';

// Written by hand: second gear, one wheel of half a metre, a quarter of a metre wide, at the origin of the chassis but a metre ahead; it
// touches, slides, has turned by a quarter and steers by nothing.
const CAR = new Int32Array([2, 128, 64, 64, 0x7fff, 0x7fff, 0x6fff, 3, 0x4000, 0x7fff, 0x7fff]);

describe('vehicle', () => {
  it('is read as the module writes it', () => {
    const car = readCar(CAR)!;
    expect(car.gear).toBe(2);
    const [wheel] = car.wheels;
    expect(wheel!.radius).toBeCloseTo(0.5, 2);
    expect(wheel!.width).toBeCloseTo(0.25, 2);
    expect(wheel!.center[2]).toBeCloseTo(-1, 3);
    expect(wheel).toMatchObject({ touches: true, slides: true });
    expect(wheel!.angle).toBeCloseTo(Math.PI / 2, 3);
    expect(wheel!.steering).toBeCloseTo(0, 3);
  });
  it('is nothing when numbers are missing', () => {
    for (let end = 3; end < CAR.length; end++) expect(readCar(CAR.subarray(0, end))).toBeUndefined();
    expect(readCar(new Int32Array())).toBeUndefined();
  });
  it('is drawn as two rims with spokes, where the chassis is', () => {
    const lines = VertexBuffer.lines(1);
    lines.begin();
    drawVehicle({ entity: 7, values: CAR, seconds: 0 }, { lines, poseOf: (entity) => (entity === 7 ? [10, 0, 0, 0, 0, 0, 1] : undefined) });
    lines.end();
    expect(lines.count).toBe(2 * (16 + 4) * 2);
    const points = lines.object.geometry.getAttribute('position');
    for (let k = 0; k < lines.count; k++) {
      expect(Math.abs(points.getX(k) - 10)).toBeCloseTo(0.125, 2);
      expect(Math.hypot(points.getY(k), points.getZ(k) + 1)).toBeLessThan(0.52);
    }
  });
});
