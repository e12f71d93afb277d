import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import type { Pick } from '../interaction/pick';
import { createJointInput, defaultJointOptions, type JointEnd, type JointKind } from './joint_options';
import { JointTool } from './joint_tool';

// Turned by 90 degrees about z: the x axis of the body is the y axis of the world.
const TURNED = [1, 2, 3, 0, 0, Math.SQRT1_2, Math.SQRT1_2];
const end = (entity: number, x: number, y: number, z: number, pose?: number[]): JointEnd => ({ entity, point: new THREE.Vector3(x, y, z), normal: new THREE.Vector3(1, 0, 0), pose });

describe('createJointInput', () => {
  const create = (kind: JointKind, first: JointEnd, second: JointEnd) => createJointInput(first, second, { ...defaultJointOptions(), kind, motorSpeed: 3 });

  it('gives ends of a rope in the frames of their bodies and their distance', () => {
    const input = create('rope', end(7, 1, 4, 3, TURNED), end(8, 1, 4, 7, [0, 0, 0, 0, 0, 0, 1]))!;
    const { x, y, z } = input.joint!.frameA!.position as THREE.Vector3Like;
    expect([x, y, z].map((value) => Number(value.toFixed(6)) + 0)).toEqual([2, 0, 0]);
    expect(input.joint!.frameB!.position).toEqual({ x: 1, y: 4, z: 7 });
    expect(input.joint!.kind).toEqual({ case: 'distance', value: { minLength: 0, maxLength: 4 } });
  });

  it('turns the z axis of a hinge to the normal of the second point, and of a slider along the points', () => {
    const axis = (kind: JointKind) => {
      const { rotation } = create(kind, end(7, 0, 0, 0, TURNED), end(8, 0, 5, 0, TURNED))!.joint!.frame!;
      const { x = 0, y = 0, z = 0, w = 1 } = rotation!;
      return new THREE.Vector3(0, 0, 1).applyQuaternion(new THREE.Quaternion(x, y, z, w)).toArray().map((value) => Number(value.toFixed(6)) + 0);
    };
    expect(axis('hinge')).toEqual([1, 0, 0]);
    expect(axis('slider')).toEqual([0, 1, 0]);
    const hinge = create('hinge', end(7, 0, 0, 0, TURNED), end(8, 0, 5, 0, TURNED))!;
    expect(hinge.joint!.kind).toEqual({ case: 'hinge', value: { motorSpeed: 3, motorMaxTorque: 500 } });
  });

  it('has the world as first body, and needs two different bodies', () => {
    const input = create('fixed', end(7, 0, 0, 0, TURNED), end(0, 1, 1, 1))!;
    expect([input.entityA, input.entityB]).toEqual([0, 7]);
    expect(create('ball', end(7, 0, 0, 0, TURNED), end(7, 1, 0, 0, TURNED))).toBeUndefined();
  });
});

describe('JointTool', () => {
  const poses = new Map([[7, [0, 0, 0, 0, 0, 0, 1]], [8, [5, 0, 0, 0, 0, 0, 1]]]);
  const hit = (entity: number, x: number): Pick => ({ entity, shape: 0, point: new THREE.Vector3(x, 0, 0), normal: new THREE.Vector3(0, 1, 0), distance: 1 });
  const setUp = () => {
    const sent: unknown[] = [];
    const hints: string[] = [];
    const tool = new JointTool({
      options: defaultJointOptions(),
      poseOf: (entity) => poses.get(entity),
      isDynamic: (entity) => entity === 7 || entity === 8,
      nameOf: (entity) => `body ${entity}`,
      isPlanar: () => false,
      send: (kind) => sent.push(kind),
      onHint: (text) => hints.push(text),
    });
    tool.setSelected(true);
    return { tool, sent, hints };
  };

  it('creates a joint with the second click and starts again', () => {
    const { tool, sent, hints } = setUp();
    tool.click(hit(7, 1));
    expect(tool.start?.toArray()).toEqual([1, 0, 0]);
    expect(hints.at(-1)).toContain('from body 7');
    tool.click(hit(8, 4));
    expect(sent).toMatchObject([{ case: 'createJoint', value: { entityA: 7, entityB: 8, joint: { frame: { position: { x: 4, y: 0, z: 0 } } } } }]);
    expect(tool.start).toBeUndefined();
  });

  it('joins to the world at static bodies, refuses the same body and can be cancelled', () => {
    const { tool, sent, hints } = setUp();
    tool.click(hit(7, 1));
    tool.click(hit(7, 0.5));
    expect(sent).toEqual([]);
    expect(hints.at(-1)).toBe('Choose a point of a body other than body 7');
    tool.click(hit(3, 2));
    expect(sent).toMatchObject([{ value: { entityA: 0, entityB: 7 } }]);
    tool.click(hit(8, 4));
    expect(tool.cancel()).toBe(true);
    expect(tool.cancel()).toBe(false);
  });
});
