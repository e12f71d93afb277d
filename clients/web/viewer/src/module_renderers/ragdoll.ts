// Renders the module "ragdoll": clothes, and faces for human figures. Layout: ragdoll.h. The ids of the
// bones are consecutive, from that of the first bone.

import * as THREE from 'three';
import type { Entity } from '@jostle/client/gen/play_pb';
import { isOfModule, type ModuleRenderer, type ChannelData } from './module_renderer';

const MODES = ['limp', 'powered', 'kinematic'] as const;
const BONES_MAX = 64;
// Bone indices of human_figure(): pelvis, chest, head, upper arms, lower arms, upper legs, lower legs.
const PERSON_BONES = 11;
const HEAD = 2;
const SHIRT_BONES = [1, 3, 4];
const SKIN_BONES = [HEAD, 5, 6];

const SHIRTS = [0xe63946, 0x1d7874, 0xf4a261, 0x457b9d, 0x8338ec, 0x2a9d8f, 0xffb703, 0xd4a5a5, 0x588157, 0xbc6c25];
const TROUSERS = [0x2b2d42, 0x344e41, 0x5e503f, 0x3d405b];
const SKINS = [0xf2cda7, 0xd9a066, 0x8d5a3b, 0xe8b48a];

export type Mode = (typeof MODES)[number];

/** undefined if the values are not exactly one mode. */
export function readMode(values: Int32Array): Mode | undefined {
  return values.length === 1 ? MODES[values[0]!] : undefined;
}

/** The first bones of the figures that can be decoded. */
const rootsOf = (data: readonly ChannelData[]) => data.filter(({ values }) => readMode(values)).map(({ entity }) => entity);

/** The bones of each figure, by its first bone. */
export function bonesOf(roots: readonly number[], entities: ReadonlyMap<number, Entity>): number[][] {
  const others = new Set(roots);
  return roots.map((root) => {
    const bones: number[] = [];
    for (let id = root; bones.length < BONES_MAX && (id === root || !others.has(id)); id++) {
      const bone = entities.get(id);
      if (!bone || !isOfModule(bone) || bone.shapes[0]?.kind.case !== 'capsule') break;
      bones.push(id);
    }
    return bones;
  });
}

const origin = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const point = new THREE.Vector3();
const size = new THREE.Vector3();
const EYE = new THREE.Color(0x16181d);
const HAIR = new THREE.Color(0x3b2a20);

export const ragdolls: ModuleRenderer = {
  draw(data, { solids, poseOf, entityOf }) {
    for (const entity of rootsOf(data)) {
      const head = entity + HEAD;
      const shape = entityOf(head)?.shapes[0];
      const pose = poseOf(head);
      if (!pose || shape?.kind.case !== 'capsule' || !isPerson(entity, entityOf)) continue;
      const { radius: r, halfLength } = shape.kind.value;
      origin.set(pose[0]!, pose[1]!, pose[2]!);
      rotation.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
      const add = (x: number, y: number, z: number, across: number, up: number, deep: number, color: THREE.Color) => {
        point.set(x, y, z).applyQuaternion(rotation).add(origin);
        solids.add('sphere', point, rotation, size.set(across, up, deep), color);
      };
      // The face is at +z.
      for (const side of [-1, 1]) add(side * 0.38 * r, 0.4 * halfLength, 0.88 * r, 0.15 * r, 0.18 * r, 0.15 * r, EYE);
      add(0, halfLength + 0.25 * r, -0.16 * r, 1.02 * r, 0.88 * r, 1.0 * r, HAIR);
    }
  },
  bodyColors(data, entities) {
    const colors = new Map<number, number>();
    bonesOf(rootsOf(data), entities).forEach((bones, k) => {
      const shirt = SHIRTS[k % SHIRTS.length]!;
      const trousers = TROUSERS[k % TROUSERS.length]!;
      const skin = SKINS[k % SKINS.length]!;
      const person = bones.length === PERSON_BONES;
      bones.forEach((id, bone) => {
        const color = !person || SHIRT_BONES.includes(bone) ? shirt : SKIN_BONES.includes(bone) ? skin : trousers;
        colors.set(id, color);
      });
    });
    return colors;
  },
};

function isPerson(root: number, entityOf: (id: number) => Entity | undefined): boolean {
  for (let bone = 0; bone < PERSON_BONES; bone++) {
    const entity = entityOf(root + bone);
    if (!entity || !isOfModule(entity) || entity.shapes[0]?.kind.case !== 'capsule') return false;
  }
  return true;
}
