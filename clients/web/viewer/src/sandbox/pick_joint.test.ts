import { create } from '@bufbuild/protobuf';
import { JointSchema } from '@jostle/client/gen/scene_pb';
import * as THREE from 'three';
import { expect, it } from 'vitest';
import { pickJoint } from './pick_joint';
import { Selection } from './selection';

const form = create(JointSchema, { frameB: { position: { x: 0, y: 1, z: 0 } } });
const joints = new Map([[1, { id: 1, entityA: 0, entityB: 5, form }], [2, { id: 2, entityA: 5, entityB: 6, form }]]);
const poses = new Map([[5, [0, 0, -10, 0, 0, 0, 1]], [6, [0.1, 0, -10, 0, 0, 0, 1]]]);
const ray = (x: number, y: number, z: number) => new THREE.Ray(new THREE.Vector3(0, 0, 0), new THREE.Vector3(x, y, z).normalize());

it('picks the joint with the anchor closest to the ray', () => {
  const poseOf = (entity: number) => poses.get(entity);
  expect(pickJoint(joints, ray(0.01, 1, -10), poseOf)).toBe(1);
  expect(pickJoint(joints, ray(0.09, 1, -10), poseOf)).toBe(2);
  expect(pickJoint(joints, ray(0, 0, -1), poseOf)).toBeUndefined();
});

it('the selection ends with its joint', () => {
  const selection = new Selection();
  const changes: unknown[] = [];
  selection.onChange((selected) => changes.push(selected));
  selection.select({ kind: 'joint', id: 2 });
  selection.retain(() => false, (id) => id === 2);
  expect(selection.current?.id).toBe(2);
  selection.retain(() => true, () => false);
  expect(changes).toEqual([{ kind: 'joint', id: 2 }, undefined]);
});
