// Picks the joint whose anchor is closest to the pointer.

import type { ListedJoint } from '@jostle/client';
import * as THREE from 'three';

const ANGLE_MAX = 0.02; // rad between the ray and the anchor

const anchor = new THREE.Vector3();
const turn = new THREE.Quaternion();

/** The anchor of the joint in its second body, in the world; undefined: the body is not rendered. */
export function anchorOf({ entityB, form }: ListedJoint, poseOf: (entity: number) => ArrayLike<number> | undefined): THREE.Vector3 | undefined {
  const pose = poseOf(entityB);
  if (!pose) return undefined;
  const { x = 0, y = 0, z = 0 } = form.frameB?.position ?? {};
  anchor.set(x, y, z).applyQuaternion(turn.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!));
  return anchor.set(anchor.x + pose[0]!, anchor.y + pose[1]!, anchor.z + pose[2]!);
}

/** The id of the joint; undefined: none is close. */
export function pickJoint(joints: ReadonlyMap<number, ListedJoint>, ray: THREE.Ray, poseOf: (entity: number) => ArrayLike<number> | undefined): number | undefined {
  let [best, found]: [number, number | undefined] = [ANGLE_MAX, undefined];
  const to = new THREE.Vector3();
  for (const joint of joints.values()) {
    const at = anchorOf(joint, poseOf);
    if (!at) continue;
    const angle = to.copy(at).sub(ray.origin).angleTo(ray.direction);
    if (angle < best) [best, found] = [angle, joint.id];
  }
  return found;
}
