// The module "hovercraft": from each thruster a line down to where its ray ends, the warmer the more it thrusts. WIRE.md has the
// layout.

import * as THREE from 'three';
import type { Drawer } from './drawer';

const THRUSTERS = 4;
const THRUSTER_VALUES = 5;
const STEPS = 65535;
const FARTHEST = 2; // m, of a thruster from the craft's origin, along each axis
const LONGEST_RAY = 4; // m

const IDLE = new THREE.Color(0x3d7cc9);
const FULL = new THREE.Color(0xffb347);

export interface Thruster {
  position: [number, number, number]; // m, in the craft's frame
  ray: number; // m
  thrust: number; // 0 to 1
}

/** Nothing unless the numbers are exactly a hovercraft. */
export function readThrusters(values: Int32Array): Thruster[] | undefined {
  if (values.length !== THRUSTERS * THRUSTER_VALUES) return undefined;
  return Array.from({ length: THRUSTERS }, (_, k): Thruster => {
    const at = k * THRUSTER_VALUES;
    const along = (axis: number) => (values[at + axis]! / STEPS) * 2 * FARTHEST - FARTHEST;
    return { position: [along(0), along(1), along(2)], ray: (values[at + 3]! / STEPS) * LONGEST_RAY, thrust: values[at + 4]! / 255 };
  });
}

const from = new THREE.Vector3();
const to = new THREE.Vector3();
const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const color = new THREE.Color();

export const drawHovercraft: Drawer = ({ entity, values }, { lines, poseOf }) => {
  const thrusters = readThrusters(values);
  const pose = poseOf(entity);
  if (!thrusters || !pose) return;
  origin.set(pose[0]!, pose[1]!, pose[2]!);
  rotation.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
  for (const { position, ray, thrust } of thrusters) {
    from.set(...position);
    to.copy(from).setY(from.y - ray);
    color.lerpColors(IDLE, FULL, thrust);
    for (const end of [from, to]) {
      end.applyQuaternion(rotation).add(origin);
      lines.vertex(end.x, end.y, end.z, color);
    }
  }
};
