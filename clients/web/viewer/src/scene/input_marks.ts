// Immediate marks of the user's own inputs, before the server responds: a line from a grabbed point to
// the pointer, and a short flash where a body is spawned.

import * as THREE from 'three';
import type { Grab } from '../interaction/tools';
import type { Solids } from './solids';

const SPAWN_MS = 260;
const LINE = new THREE.Color(0xffd166);
const LINE_RADIUS = 0.018; // m at 10 m from the camera
const UP = new THREE.Vector3(0, 1, 0);

const from = new THREE.Vector3();
const along = new THREE.Vector3();
const turn = new THREE.Quaternion();
const size = new THREE.Vector3();
const color = new THREE.Color();

export class InputMarks {
  private spawns: { at: THREE.Vector3; radius: number; startMs: number }[] = [];

  spawned(at: THREE.Vector3, radius: number, nowMs: number): void {
    this.spawns.push({ at: at.clone(), radius, startMs: nowMs });
  }

  get spawnCount(): number {
    return this.spawns.length;
  }

  /** Call once per rendered frame. `distance`: of the camera, in m. */
  draw(solids: Solids, grab: Grab | undefined, poseOf: (entity: number) => ArrayLike<number> | undefined, distance: number, nowMs: number): void {
    this.spawns = this.spawns.filter(({ startMs }) => nowMs - startMs < SPAWN_MS);
    for (const { at, radius, startMs } of this.spawns) {
      const age = (nowMs - startMs) / SPAWN_MS;
      const r = radius * (1 - age);
      solids.add('sphere', at, turn.identity(), size.set(r, r, r), color.copy(LINE));
    }
    if (grab) this.drawGrab(solids, grab, poseOf, (LINE_RADIUS * distance) / 10);
  }

  private drawGrab(solids: Solids, { entity, point, target }: Grab, poseOf: (entity: number) => ArrayLike<number> | undefined, radius: number): void {
    const pose = poseOf(entity);
    from.copy(point);
    if (pose) from.applyQuaternion(turn.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!)).add(along.set(pose[0]!, pose[1]!, pose[2]!));
    solids.add('sphere', target, turn.identity(), size.setScalar(3 * radius), LINE);
    solids.add('sphere', from, turn.identity(), size.setScalar(2.2 * radius), LINE);
    along.copy(target).sub(from);
    const length = along.length();
    if (length < 1e-3) return;
    turn.setFromUnitVectors(UP, along.divideScalar(length));
    solids.add('cylinder', from.addScaledVector(along, length / 2), turn, size.set(radius, length / 2, radius), LINE);
  }
}
