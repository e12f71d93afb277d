import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { withValue } from '../testing/golden_modules';
import { testRenderContext } from '../testing/test_render_context';
import { readCar, vehicles } from './vehicle';

// Handwritten: second gear; one wheel of 0.5 m radius and 0.25 m width, 1 m ahead of the origin of the
// chassis; it touches, slides, has turned by a quarter and does not steer.
const CAR = new Int32Array([2, 128, 64, 64, 0x7fff, 0x7fff, 0x6fff, 3, 0x4000, 0x7fff, 0x7fff]);
const SPIN = 9; // index of the value
const data = (values: Int32Array, seconds = 0) => ({ entity: 7, values, seconds });

describe('vehicle', () => {
  it('is decoded as the module encodes it', () => {
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
  it('is undefined for missing or out-of-range values', () => {
    for (let end = 3; end < CAR.length; end++) expect(readCar(CAR.subarray(0, end))).toBeUndefined();
    expect(readCar(new Int32Array())).toBeUndefined();
    for (const step of [-1, 0x10000]) expect(readCar(withValue(CAR, SPIN, step))).toBeUndefined();
  });
  it('draws rotated and steered wheels at the chassis pose', () => {
    const context = testRenderContext((entity) => (entity === 7 ? [10, 0, 0, 0, 0, 0, 1] : undefined));
    vehicles.draw!([data(CAR)], context);
    const { solids } = context;
    expect(solids.countOf('cylinder')).toBe(2); // tire and rim
    const tire = solids.matrixOf('cylinder', 0);
    const at = new THREE.Vector3().setFromMatrixPosition(tire);
    expect(at.distanceTo(new THREE.Vector3(10, 0, -1))).toBeLessThan(0.01);
    // Its axis is the x axis of the chassis, and its former top points forward after a quarter turn.
    const axis = new THREE.Vector3(0, 1, 0).transformDirection(tire);
    expect(Math.abs(axis.x)).toBeCloseTo(1, 3);
    const spoke = solids.matrixOf('box', 0);
    expect(new THREE.Vector3(0, 1, 0).transformDirection(spoke).z).toBeCloseTo(-1, 3);
  });
  it('extrapolates wheel rotation between ticks', () => {
    const spun = withValue(CAR, SPIN, 36044); // 40 rad/s
    const context = testRenderContext();
    vehicles.draw!([data(spun, Math.PI / 80)], context);
    // A quarter turn later the former top points down.
    expect(new THREE.Vector3(0, 1, 0).transformDirection(context.solids.matrixOf('box', 0)).y).toBeCloseTo(-1, 2);
  });
  it('reports speed and gear', () => {
    expect(vehicles.steering!.statusText!(data(CAR))).toBe('0 km/h · gear 2');
    expect(vehicles.steering!.statusText!(data(withValue(CAR, 0, -1)))).toBe('0 km/h · reverse');
    expect(vehicles.steering!.statusText!(data(CAR.subarray(0, 5)))).toBe('');
  });
});
