// Renders the module "character": a visor, a backpack, and hands and feet that swing with the walked
// distance. Layout: character.h.

import * as THREE from 'three';
import type { ModuleRenderer, RenderContext } from './module_renderer';
import { ValueReader } from './value_reader';

const GROUNDS = ['on ground', 'sliding', 'airborne'] as const;
const STRIDE = 1.5; // m per step of each foot

export interface Character {
  rigid: boolean;
  crouched: boolean;
  ground: (typeof GROUNDS)[number];
  heading: number; // rad about y, from -z, to the left
  speed: number; // m/s over the ground
  verticalSpeed: number; // m/s
}

/** undefined if the values are not exactly one character. */
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
    verticalSpeed: reader.quantized(-20, 20, 8),
  };
  return reader.failed || reader.left > 0 ? undefined : character;
}

const GLASS = new THREE.Color(0x10141a);
const SHOE = new THREE.Color(0x22252b);
const GLOVE = new THREE.Color(0xf1e3d3);
const PACK = new THREE.Color(0x5a4632);
const UP = new THREE.Vector3(0, 1, 0);
const turn = new THREE.Quaternion();
const point = new THREE.Vector3();
const size = new THREE.Vector3();

function drawCharacter(character: Character, entity: number, pose: ArrayLike<number>, { solids, entityOf }: RenderContext): void {
  const shape = entityOf(entity)?.shapes[0];
  if (shape?.kind.case !== 'capsule') return;
  const { radius: r, halfLength } = shape.kind.value;
  turn.setFromAxisAngle(UP, character.heading);
  const middle = pose[1]! + (shape.position?.y ?? 0);
  const add = (kind: 'sphere' | 'box', sideways: number, up: number, ahead: number, x: number, y: number, z: number, color: THREE.Color) => {
    point.set(sideways, 0, -ahead).applyQuaternion(turn);
    point.set(pose[0]! + point.x, middle + up, pose[2]! + point.z);
    solids.add(kind, point, turn, size.set(x, y, z), color);
  };
  // The position along the heading sets the swing, so that feet on the ground stand still.
  const distance = -pose[0]! * Math.sin(character.heading) - pose[2]! * Math.cos(character.heading);
  const swing = character.ground === 'airborne' ? 0.9 : Math.sin((Math.PI * distance) / STRIDE) * Math.min(1, character.speed / 2);
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
      const character = readCharacter(values);
      const pose = context.poseOf(entity);
      if (character && pose) drawCharacter(character, entity, pose, context);
    }
  },
  steering: {
    keys: 'W A S D walk relative to the camera · drag to turn the camera · Space jump · Shift crouch',
    buttons: ['Jump', 'Crouch'],
    camera: 'free',
    distance: 5.5,
    statusText({ values }) {
      const character = readCharacter(values);
      return character ? `${character.speed.toFixed(1)} m/s${character.ground === 'on ground' ? '' : ` · ${character.ground}`}${character.crouched ? ' · crouched' : ''}` : '';
    },
  },
};
