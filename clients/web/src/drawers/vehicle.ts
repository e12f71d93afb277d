// The module "vehicle": each wheel as two rims and its spokes, redder where the tyre slides. vehicle.h has the layout.

import * as THREE from 'three';
import type { Drawer } from './drawer';

const HEAD_BYTES = 7;
const WHEEL_BYTES = 15;
const STEPS = 65535;
const FARTHEST = 8; // m, of a wheel from the chassis's origin, along each axis
const SIDES = 16;
const SPOKES = 4;

const RUBBER = new THREE.Color(0x2b2d42);
const SLIDING = new THREE.Color(0xef476f);

export interface Wheel {
  radius: number; // m
  width: number; // m
  center: [number, number, number]; // m, in the chassis
  touches: boolean;
  slides: boolean;
  angle: number; // rad that it has turned
  steering: number; // rad, to the right
}
export interface Car {
  entity: number;
  gear: number;
  wheels: Wheel[];
}

/** Nothing unless the bytes are exactly so many cars. */
export function readCars(bytes: Uint8Array): Car[] | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const cars: Car[] = [];
  let at = 0;
  while (at < bytes.length) {
    if (at + HEAD_BYTES > bytes.length) return undefined;
    const count = view.getUint8(at + 6);
    if (at + HEAD_BYTES + count * WHEEL_BYTES > bytes.length) return undefined;
    const car: Car = { entity: view.getUint32(at, true), gear: view.getUint8(at + 4) - 1, wheels: [] };
    at += HEAD_BYTES;
    for (let k = 0; k < count; k++, at += WHEEL_BYTES) {
      const part = (offset: number) => view.getUint16(at + offset, true) / STEPS;
      const along = (axis: number) => (2 * part(2 + 2 * axis) - 1) * FARTHEST;
      const bits = view.getUint8(at + 8);
      car.wheels.push({
        radius: (view.getUint8(at) / 255) * 2,
        width: view.getUint8(at + 1) / 255,
        center: [along(0), along(1), along(2)],
        touches: (bits & 1) !== 0,
        slides: (bits & 2) !== 0,
        angle: part(9) * 2 * Math.PI,
        steering: (part(13) - 0.5) * Math.PI,
      });
    }
    cars.push(car);
  }
  return cars;
}

const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const point = new THREE.Vector3();
const UP = new THREE.Vector3(0, 1, 0);

export const drawVehicles: Drawer = (bytes, { lines, poseOf }) => {
  for (const car of readCars(bytes) ?? []) {
    const pose = poseOf(car.entity);
    if (!pose) continue;
    origin.set(pose[0]!, pose[1]!, pose[2]!);
    rotation.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
    for (const wheel of car.wheels) {
      const color = wheel.slides ? SLIDING : RUBBER;
      const center = new THREE.Vector3(...wheel.center);
      const vertex = (side: number, part: number, reach: number) => {
        // Ahead is -z: a wheel that rolls ahead turns from the top towards -z.
        const turn = 2 * Math.PI * part + wheel.angle;
        point.set(side * 0.5 * wheel.width, reach * Math.cos(turn), -reach * Math.sin(turn));
        point.applyAxisAngle(UP, -wheel.steering).add(center).applyQuaternion(rotation).add(origin);
        lines.vertex(point.x, point.y, point.z, color);
      };
      for (const side of [-1, 1]) {
        for (let k = 0; k < SIDES; k++) {
          vertex(side, k / SIDES, wheel.radius);
          vertex(side, (k + 1) / SIDES, wheel.radius);
        }
        for (let k = 0; k < SPOKES; k++) {
          vertex(side, k / SPOKES, 0);
          vertex(side, k / SPOKES, wheel.radius);
        }
      }
    }
  }
};
