// The module "character": a face where it looks, arms and feet that swing with the way it goes. character.h has the layout.

import * as THREE from 'three';
import type { ModuleRenderer, RenderContext } from './module_renderer';
import { ValueReader } from './value_reader';

const GROUNDS = ['on ground', 'slides', 'in the air'] as const;
const STRIDE = 1.5; // m for one step of each foot

export interface Character {
  rigid: boolean;
  crouched: boolean;
  ground: (typeof GROUNDS)[number];
  heading: number; // rad about y, from -z, to the left
  speed: number; // m/s over the ground
  rising: number; // m/s
}

/** Nothing unless the numbers are exactly a character. */
export function readCharacter(values: Int32Array): Character | undefined {
  const reader = new ValueReader(values);
  const bits = reader.value();
  const ground = GROUNDS[(bits >> 2) & 3];
  if (!ground) return undefined;
  const character: Character = {
    rigid: (bits & 1) !== 0,
    crouched: (bits & 2) !== 0,
    ground,
    heading: reader.quantized(-Math.PI, Math.PI, 8),
    speed: reader.quantized(0, 20, 8),
    rising: reader.quantized(-20, 20, 8),
  };
  return reader.failed || reader.left > 0 ? undefined : character;
}

const GLASS = new THREE.Color(0x10141a);
const SHOE = new THREE.Color(0x22252b);
const GLOVE = new THREE.Color(0xf1e3d3);
const PACK = new THREE.Color(0x5a4632);
const UP = new THREE.Vector3(0, 1, 0);
const turn = new THREE.Quaternion();
const place = new THREE.Vector3();
const size = new THREE.Vector3();

function drawCharacter(who: Character, entity: number, pose: ArrayLike<number>, { solids, entityOf }: RenderContext): void {
  const shape = entityOf(entity)?.shapes[0];
  if (shape?.kind.case !== 'capsule') return;
  const { radius: r, halfLength } = shape.kind.value;
  turn.setFromAxisAngle(UP, who.heading);
  const middle = pose[1]! + (shape.position?.y ?? 0);
  const add = (kind: 'sphere' | 'box', aside: number, up: number, ahead: number, x: number, y: number, z: number, color: THREE.Color) => {
    place.set(aside, 0, -ahead).applyQuaternion(turn);
    place.set(pose[0]! + place.x, middle + up, pose[2]! + place.z);
    solids.add(kind, place, turn, size.set(x, y, z), color);
  };
  // How far it has come along its heading says where its feet are: they stand still on ground that they stand on.
  const way = -pose[0]! * Math.sin(who.heading) - pose[2]! * Math.cos(who.heading);
  const swing = who.ground === 'in the air' ? 0.9 : Math.sin((Math.PI * way) / STRIDE) * Math.min(1, who.speed / 2);
  const head = halfLength + 0.12 * r;
  add('sphere', 0, head, 0.62 * r, 0.62 * r, 0.36 * r, 0.5 * r, GLASS);
  add('box', 0, 0.35 * halfLength, -0.95 * r, 0.55 * r, 0.45 * halfLength, 0.3 * r, PACK);
  for (const side of [-1, 1]) {
    add('sphere', side * 0.5 * r, -halfLength - 0.82 * r, side * swing * 0.9 * r + 0.15 * r, 0.36 * r, 0.26 * r, 0.55 * r, SHOE);
    add('sphere', side * 1.12 * r, -0.05 * halfLength, -side * swing * 0.9 * r + 0.2 * r, 0.3 * r, 0.3 * r, 0.3 * r, GLOVE);
  }
}

export const characters: ModuleRenderer = {
  draw(data, context) {
    for (const { entity, values } of data) {
      const who = readCharacter(values);
      const pose = context.poseOf(entity);
      if (who && pose) drawCharacter(who, entity, pose, context);
    }
  },
  steering: {
    keys: 'W A S D walk as the camera looks · drag to look round · space jumps · shift crouches',
    camera: 'free',
    distance: 5.5,
    statusText({ values }) {
      const who = readCharacter(values);
      return who ? `${who.speed.toFixed(1)} m/s${who.ground === 'on ground' ? '' : ` · ${who.ground}`}${who.crouched ? ' · crouched' : ''}` : '';
    },
  },
};
