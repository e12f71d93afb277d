import { create, type MessageInitShape } from '@bufbuild/protobuf';
import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import type { ListedJoint } from '@jostle/client';
import { JointSchema } from '@jostle/client/gen/scene_pb';
import { JointView } from './joint_view';

const joint = (id: number, entityA: number, entityB: number, kind: MessageInitShape<typeof JointSchema>['kind'], more: MessageInitShape<typeof JointSchema> = {}): ListedJoint => ({
  id,
  entityA,
  entityB,
  form: create(JointSchema, { ...more, kind } as MessageInitShape<typeof JointSchema>),
});
const listOf = (...joints: ListedJoint[]) => new Map(joints.map((one) => [one.id, one]));
const KINDS: MessageInitShape<typeof JointSchema>['kind'][] = [
  { case: 'ball', value: {} },
  { case: 'hinge', value: { motorSpeed: 2 } },
  { case: 'coneTwist', value: {} },
  { case: 'fixed', value: {} },
  { case: 'distance', value: { minLength: 0, maxLength: 5 } },
  { case: 'distance', value: { minLength: 0, maxLength: 5, spring: { hertz: 2 } } },
  { case: 'slider', value: { limit: { lower: -1, upper: 1 } } },
  { case: 'sixDof', value: {} },
  { case: 'wheel', value: { motorSpeed: 1 } },
  { case: 'gear', value: {} },
  { case: 'rack', value: {} },
  { case: 'pulley', value: { pointA: { y: 4 }, pointB: { x: 1, y: 4 } } },
  { case: 'path', value: { points: [{}, { x: 1 }, { x: 2, y: 1 }] } },
];

class Bodies {
  readonly poses = new Map<number, number[]>();
  poseOf = (entity: number) => this.poses.get(entity);
  radiusOf = () => 0.3;
}

describe('joints', () => {
  it('of every kind have solids with finite matrices', () => {
    const bodies = new Bodies();
    bodies.poses.set(1, [0, 2, 0, 0, 0, 0, 1]);
    bodies.poses.set(2, [1, 1, 0, 0, Math.SQRT1_2, 0, Math.SQRT1_2]);
    for (const kind of KINDS) {
      const scene = new THREE.Scene();
      const view = new JointView(scene);
      view.setJoints(listOf(joint(1, 1, 2, kind), joint(2, 0, 2, kind)));
      view.update(bodies);
      expect(view.count, kind!.case).toBe(2);
      for (const mesh of scene.children as THREE.InstancedMesh[])
        expect([...mesh.instanceMatrix.array].every(Number.isFinite), kind!.case).toBe(true);
    }
  });

  it('follow their bodies and disappear when they break or a body leaves', () => {
    const scene = new THREE.Scene();
    const view = new JointView(scene);
    const bodies = new Bodies();
    bodies.poses.set(1, [0, 0, 0, 0, 0, 0, 1]);
    bodies.poses.set(2, [1, 0, 0, 0, 0, 0, 1]);
    const one = joint(1, 1, 2, { case: 'ball', value: {} }, { frameB: { position: { x: -0.5 } } });
    view.setJoints(listOf(one));
    view.update(bodies);
    const positionX = () => (scene.children[0] as THREE.InstancedMesh).instanceMatrix.array[12];
    expect(positionX()).toBe(0.5);
    bodies.poses.set(2, [4, 0, 0, 0, 0, 0, 1]);
    view.update(bodies);
    expect(positionX()).toBe(3.5);
    expect(view.solidCount).toBe(1);
    bodies.poses.delete(1);
    view.update(bodies);
    expect([view.count, view.solidCount]).toEqual([0, 0]);
    bodies.poses.set(1, [0, 0, 0, 0, 0, 0, 1]);
    view.update(bodies);
    expect(view.count).toBe(1);
    view.setJoints(new Map());
    expect(view.solidCount).toBe(0);
  });

  it('ignore numbers that are not finite', () => {
    const view = new JointView(new THREE.Scene());
    const bodies = new Bodies();
    bodies.poses.set(2, [0, 0, 0, 0, 0, 0, 1]);
    view.setJoints(listOf(joint(1, 0, 2, { case: 'ball', value: {} }, { frameA: { position: { x: NaN } } }), joint(2, 0, 2, { case: 'path', value: { points: [{ x: Infinity }, {}] } })));
    view.update(bodies);
    expect(view.count).toBe(1);
  });

  it('redraws 1,000 moving joints in less than 6 ms and resting ones in less than 1 ms', () => {
    const view = new JointView(new THREE.Scene());
    const bodies = new Bodies();
    const links = 1000;
    for (let k = 1; k <= links; k++) bodies.poses.set(k, [k, 0, 0, 0, 0, 0, 1]);
    view.setJoints(listOf(...Array.from({ length: links - 1 }, (_, k) => joint(k + 1, k + 1, k + 2, { case: 'ball', value: {} }))));
    const medianOf = (each: (frame: number) => void) => {
      const times = Array.from({ length: 40 }, (_, frame) => {
        each(frame);
        const startMs = performance.now();
        view.update(bodies);
        return performance.now() - startMs;
      });
      return times.sort((x, y) => x - y)[20]!;
    };
    const moving = medianOf((frame) => bodies.poses.forEach((pose) => (pose[1] = frame)));
    const resting = medianOf(() => {});
    console.log(`1,000 joints: ${moving.toFixed(2)} ms moving, ${resting.toFixed(2)} ms at rest`);
    expect(moving).toBeLessThan(6);
    expect(resting).toBeLessThan(1);
  });
});
