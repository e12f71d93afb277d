import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { testDrawing } from './test_drawing';
import { readCars, vehicles } from './vehicle';

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
  it('is drawn as wheels that have turned and steer, where the chassis is', () => {
    const drawing = testDrawing((entity) => (entity === 7 ? [10, 0, 0, 0, 0, 0, 1] : undefined));
    vehicles.draw!(CAR, drawing);
    const { solids } = drawing;
    expect(solids.countOf('cylinder')).toBe(2); // tyre and rim
    const tyre = solids.matrixOf('cylinder', 0);
    const at = new THREE.Vector3().setFromMatrixPosition(tyre);
    expect(at.distanceTo(new THREE.Vector3(10, 0, -1))).toBeLessThan(0.01);
    // Its axis is the chassis's x, and what was its top looks ahead, after a quarter of a turn.
    const axis = new THREE.Vector3(0, 1, 0).transformDirection(tyre);
    expect(Math.abs(axis.x)).toBeCloseTo(1, 3);
    const spoke = solids.matrixOf('box', 0);
    expect(new THREE.Vector3(0, 1, 0).transformDirection(spoke).z).toBeCloseTo(-1, 3);
  });
  it('rolls on between ticks', () => {
    const spun = CAR.slice();
    new DataView(spun.buffer).setUint16(7 + 11, 36044, true); // 40 rad/s
    const drawing = testDrawing(undefined, undefined, { seconds: Math.PI / 80 });
    vehicles.draw!(spun, drawing);
    // A quarter more: the top is behind the hub's height again, upside down.
    expect(new THREE.Vector3(0, 1, 0).transformDirection(drawing.solids.matrixOf('box', 0)).y).toBeCloseTo(-1, 2);
  });
  it('says how fast and in which gear', () => {
    expect(vehicles.steering!.entities(CAR)).toEqual([7]);
    expect(vehicles.steering!.words!(CAR, 7)).toBe('0 km/h · gear 2');
    expect(vehicles.steering!.words!(CAR, 8)).toBe('');
  });
});
