// Renders the module "boat": the outboard motor, turned by the rudder, and foam behind the propeller.
// Layout: boats.h of the module "fields".

import * as THREE from 'three';
import type { ModuleRenderer, RenderContext } from './module_renderer';
import { ValueReader } from './value_reader';

const POSITION_MAX = 8; // m: range of the propeller position along each axis
const RUDDER_ANGLE_MAX = 0.5; // rad: rendered angle at full rudder

export interface Boat {
  propeller: [number, number, number]; // m, in the local frame of the hull
  throttle: number; // -1 to 1
  rudder: number; // -1 to 1, to the right
  wet: boolean;
}

/** undefined if the values are not exactly one boat. */
export function readBoat(values: Int32Array): Boat | undefined {
  const reader = new ValueReader(values);
  const along = () => reader.quantized(-POSITION_MAX, POSITION_MAX, 16);
  const boat: Boat = {
    propeller: [along(), along(), along()],
    throttle: reader.quantized(-1, 1, 8),
    rudder: reader.quantized(-1, 1, 8),
    wet: (reader.value() & 1) !== 0,
  };
  return reader.failed || reader.left > 0 ? undefined : boat;
}

const LEG = new THREE.Color(0x2b2d33);
const HOOD = new THREE.Color(0xd8dde3);
const FOAM = new THREE.Color(0xeef6f7);
const FLECKS = 7;
const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const turn = new THREE.Quaternion();
const point = new THREE.Vector3();
const size = new THREE.Vector3();
const UP = new THREE.Vector3(0, 1, 0);

function drawBoat(boat: Boat, pose: ArrayLike<number>, { solids, nowMs }: RenderContext): void {
  origin.set(pose[0]!, pose[1]!, pose[2]!);
  rotation.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
  turn.setFromAxisAngle(UP, -RUDDER_ANGLE_MAX * boat.rudder).premultiply(rotation);
  const [x, y, z] = boat.propeller;
  // Outside the stern, like an outboard motor.
  const at = (up: number, behind: number) => point.set(x, y + up, z + 0.4 + behind).applyQuaternion(rotation).add(origin);
  solids.add('box', at(0.45, 0), turn, size.set(0.1, 0.7, 0.16), LEG);
  solids.add('box', at(1.15, 0.05), turn, size.set(0.24, 0.26, 0.34), HOOD);
  if (!boat.wet || Math.abs(boat.throttle) < 0.05) return;
  for (let k = 0; k < FLECKS; k++) {
    // Each fleck drifts astern, shrinks and repeats.
    const age = (nowMs / 700 + k / FLECKS) % 1;
    const sideways = 0.5 * Math.sin(5 * k) * age;
    const r = 0.3 * Math.abs(boat.throttle) * (1 - age);
    point.set(x + sideways, y + 0.45, z + 0.7 + 2.2 * age * Math.sign(boat.throttle)).applyQuaternion(rotation).add(origin);
    solids.add('sphere', point, rotation, size.set(r, 0.5 * r, r), FOAM);
  }
}

export const boats: ModuleRenderer = {
  draw(data, context) {
    for (const { entity, values } of data) {
      const boat = readBoat(values);
      const pose = context.poseOf(entity);
      if (boat && pose) drawBoat(boat, pose, context);
    }
  },
  steering: {
    keys: 'W forward · S reverse · A D rudder',
    buttons: [],
    camera: 'behind',
    distance: 11,
    statusText: ({ values }) => (readBoat(values)?.wet === false ? 'propeller out of the water' : ''),
  },
};
