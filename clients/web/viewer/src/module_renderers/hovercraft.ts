// Renders the module "hovercraft": a line from each thruster down to the end of its ray, colored by
// thrust. Layout: WIRE.md.

import * as THREE from 'three';
import type { ModuleRenderer, RenderContext, ChannelData } from './module_renderer';
import { ValueReader } from './value_reader';

const THRUSTERS = 4;
const POSITION_MAX = 2; // m: range of a thruster position along each axis
const RAY_MAX = 4; // m

const IDLE = new THREE.Color(0x3d7cc9);
const FULL = new THREE.Color(0xffb347);

export interface Thruster {
  position: [number, number, number]; // m, in the local frame of the craft
  ray: number; // m
  thrust: number; // 0 to 1
}

/** undefined if the values are not exactly one hovercraft. */
export function readThrusters(values: Int32Array): Thruster[] | undefined {
  const reader = new ValueReader(values);
  const along = () => reader.quantized(-POSITION_MAX, POSITION_MAX, 16);
  const thrusters = Array.from(
    { length: THRUSTERS },
    (): Thruster => ({
      position: [along(), along(), along()],
      ray: reader.quantized(0, RAY_MAX, 16),
      thrust: reader.quantized(0, 1, 8),
    }),
  );
  return reader.failed || reader.left > 0 ? undefined : thrusters;
}

const from = new THREE.Vector3();
const to = new THREE.Vector3();
const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const color = new THREE.Color();

function drawHovercraft({ entity, values }: ChannelData, { lines, poseOf }: Pick<RenderContext, 'lines' | 'poseOf'>): void {
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
}

export const hovercraft: ModuleRenderer = {
  draw(data, context) {
    for (const one of data) drawHovercraft(one, context);
  },
  steering: { keys: 'W S forward and back · A D turn', buttons: [], camera: 'behind', distance: 9 },
};
