// The module "hovercraft": from each thruster a line down to where its ray ends, the warmer the more it thrusts. WIRE.md has the
// layout.

import * as THREE from 'three';
import type { Drawer, Drawing } from './drawer';

const THRUSTERS = 4;
const HEAD_BYTES = 4;
const THRUSTER_BYTES = 9;
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

export interface Hovercraft {
  entity: number;
  thrusters: Thruster[];
}

/** Nothing unless the bytes are exactly a hovercraft. */
export function readHovercraft(bytes: Uint8Array): Hovercraft | undefined {
  if (bytes.length !== HEAD_BYTES + THRUSTERS * THRUSTER_BYTES) return undefined;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const thrusters = Array.from({ length: THRUSTERS }, (_, k): Thruster => {
    const at = HEAD_BYTES + k * THRUSTER_BYTES;
    const along = (axis: number) => (view.getUint16(at + 2 * axis, true) / STEPS) * 2 * FARTHEST - FARTHEST;
    return {
      position: [along(0), along(1), along(2)],
      ray: (view.getUint16(at + 6, true) / STEPS) * LONGEST_RAY,
      thrust: view.getUint8(at + 8) / 255,
    };
  });
  return { entity: view.getUint32(0, true), thrusters };
}

const from = new THREE.Vector3();
const to = new THREE.Vector3();
const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const color = new THREE.Color();

function drawHovercraft(bytes: Uint8Array, { lines, poseOf }: Pick<Drawing, 'lines' | 'poseOf'>): void {
  const craft = readHovercraft(bytes);
  const pose = craft && poseOf(craft.entity);
  if (!pose) return;
  origin.set(pose[0]!, pose[1]!, pose[2]!);
  rotation.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
  for (const { position, ray, thrust } of craft.thrusters) {
    from.set(...position);
    to.copy(from).setY(from.y - ray);
    color.lerpColors(IDLE, FULL, thrust);
    for (const end of [from, to]) {
      end.applyQuaternion(rotation).add(origin);
      lines.vertex(end.x, end.y, end.z, color);
    }
  }
}

export const hovercraft: Drawer = {
  draw: drawHovercraft,
  steering: {
    entities: (bytes) => {
      const craft = readHovercraft(bytes);
      return craft ? [craft.entity] : [];
    },
    keys: 'W S ahead and back · A D turn',
    camera: 'behind',
    distance: 9,
  },
};
