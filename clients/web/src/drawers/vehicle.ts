// The module "vehicle": each wheel as two rims and its spokes, redder where the tyre slides. vehicle.h has the layout.

import * as THREE from 'three';
import type { Drawer } from './drawer';

const HEAD_VALUES = 2;
const WHEEL_VALUES = 9;
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
  gear: number;
  wheels: Wheel[];
}

/** Nothing unless the numbers are exactly a car. */
export function readCar(values: Int32Array): Car | undefined {
  if (values.length < HEAD_VALUES || (values.length - HEAD_VALUES) % WHEEL_VALUES !== 0) return undefined;
  const car: Car = { gear: values[0]!, wheels: [] };
  for (let at = HEAD_VALUES; at < values.length; at += WHEEL_VALUES) {
    const part = (k: number) => values[at + k]! / STEPS;
    const along = (axis: number) => (2 * part(2 + axis) - 1) * FARTHEST;
    car.wheels.push({
      radius: (values[at]! / 255) * 2,
      width: values[at + 1]! / 255,
      center: [along(0), along(1), along(2)],
      touches: (values[at + 5]! & 1) !== 0,
      slides: (values[at + 5]! & 2) !== 0,
      angle: part(6) * 2 * Math.PI,
      steering: (part(8) - 0.5) * Math.PI,
    });
  }
  return car;
}

const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const point = new THREE.Vector3();
const UP = new THREE.Vector3(0, 1, 0);

export const drawVehicle: Drawer = ({ entity, values }, { lines, poseOf }) => {
  const car = readCar(values);
  const pose = poseOf(entity);
  if (!car || !pose) return;
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
};
