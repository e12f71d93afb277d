// Renders the module "vehicle": wheels, which are not bodies, reddened while the tire slides. Layout:
// vehicle.h.

import * as THREE from 'three';
import type { ModuleRenderer, RenderContext } from './module_renderer';
import { ValueReader } from './value_reader';

const POSITION_MAX = 8; // m: range of a wheel position along each axis

const RUBBER = new THREE.Color(0x15161a);
const SLIDING = new THREE.Color(0x7a1f2e);
const RIM = new THREE.Color(0xc9ced6);
const SPOKE = new THREE.Color(0x3a3f4a);

export interface Wheel {
  radius: number; // m
  width: number; // m
  center: [number, number, number]; // m, in the local frame of the chassis
  touches: boolean;
  slides: boolean;
  angle: number; // rad, accumulated rotation
  spin: number; // rad/s
  steering: number; // rad, to the right
}
export interface Car {
  gear: number; // -1 reverse, 0 neutral
  engine: number; // 0 to 1 of the maximum
  wheels: Wheel[];
}

function readWheel(reader: ValueReader): Wheel {
  const radius = reader.quantized(0, 2, 8);
  const width = reader.quantized(0, 1, 8);
  const along = () => reader.quantized(-POSITION_MAX, POSITION_MAX, 16);
  const center: Wheel['center'] = [along(), along(), along()];
  const bits = reader.value();
  return {
    radius,
    width,
    center,
    touches: (bits & 1) !== 0,
    slides: (bits & 2) !== 0,
    angle: reader.quantized(0, 2 * Math.PI, 16),
    spin: reader.quantized(-400, 400, 16),
    steering: reader.quantized(-Math.PI / 2, Math.PI / 2, 16),
  };
}

/** undefined if the values are malformed. */
export function readCar(values: Int32Array): Car | undefined {
  const reader = new ValueReader(values);
  const car: Car = { gear: reader.value(), engine: reader.quantized(0, 1, 8), wheels: [] };
  while (reader.left > 0 && !reader.failed) car.wheels.push(readWheel(reader));
  return reader.failed ? undefined : car;
}

const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const center = new THREE.Vector3();
const turn = new THREE.Quaternion();
const scratch = new THREE.Quaternion();
const size = new THREE.Vector3();
const X = new THREE.Vector3(1, 0, 0);
const Y = new THREE.Vector3(0, 1, 0);
const AXIS_TO_X = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 0, 1), -Math.PI / 2); // rotates the axis of a cylinder from y to x

function drawWheel(wheel: Wheel, seconds: number, { solids }: RenderContext): void {
  center.set(...wheel.center).applyQuaternion(rotation).add(origin);
  // Forward is -z: the top of a wheel that rolls forward moves towards -z.
  turn.copy(rotation);
  turn.multiply(scratch.setFromAxisAngle(Y, -wheel.steering));
  turn.multiply(scratch.setFromAxisAngle(X, -(wheel.angle + wheel.spin * seconds)));
  const half = 0.5 * wheel.width;
  const across = scratch.copy(turn).multiply(AXIS_TO_X);
  solids.add('cylinder', center, across, size.set(wheel.radius, half, wheel.radius), wheel.slides ? SLIDING : RUBBER);
  solids.add('cylinder', center, across, size.set(0.64 * wheel.radius, 1.03 * half, 0.64 * wheel.radius), RIM);
  solids.add('box', center, turn, size.set(1.08 * half, 0.6 * wheel.radius, 0.09 * wheel.radius), SPOKE);
  solids.add('box', center, turn, size.set(1.08 * half, 0.09 * wheel.radius, 0.6 * wheel.radius), SPOKE);
}

function speedOf({ wheels }: Car): number {
  return wheels.length === 0 ? 0 : wheels.reduce((sum, { spin, radius }) => sum + spin * radius, 0) / wheels.length;
}

export const vehicles: ModuleRenderer = {
  draw(data, context) {
    for (const { entity, values, seconds } of data) {
      const car = readCar(values);
      const pose = context.poseOf(entity);
      if (!car || !pose) continue;
      origin.set(pose[0]!, pose[1]!, pose[2]!);
      rotation.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
      for (const wheel of car.wheels) drawWheel(wheel, seconds, context);
    }
  },
  steering: {
    keys: 'W throttle · S brake, then reverse · A D steer · Space hand brake · E Q shift gears (manual gearbox)',
    buttons: ['Hand brake', '', 'Gear +', 'Gear −'],
    camera: 'behind',
    distance: 8,
    statusText({ values }) {
      const car = readCar(values);
      if (!car) return '';
      const gear = car.gear < 0 ? 'reverse' : car.gear === 0 ? 'neutral' : `gear ${car.gear}`;
      return `${Math.abs(3.6 * speedOf(car)).toFixed(0)} km/h · ${gear}`;
    },
  },
};
