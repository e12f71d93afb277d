import { create, type MessageInitShape } from '@bufbuild/protobuf';
import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { DebugView, islandTints, normalLength } from './debug_view';
import { DebugResponseSchema } from '@jostle/client/gen/query_pb';
import { summary } from '../panels/debug';

const response = (init: MessageInitShape<typeof DebugResponseSchema>) => create(DebugResponseSchema, init);
const all = { contacts: true, islands: true, bounds: true, joints: true, broadPhase: true };
const none = { contacts: false, islands: false, bounds: false, joints: false, broadPhase: false };
const noPose = () => undefined;

const scene = response({
  contacts: [
    { point: { x: 1, y: 0, z: 0 }, normal: { x: 0, y: 1, z: 0 }, impulse: 100, touching: true },
    { point: { x: 2, y: 0, z: 0 }, normal: { x: 0, y: 1, z: 0 } },
    { point: { x: 3, y: 0, z: 0 }, normal: { x: 0, y: 1, z: 0 }, impulse: 1, touching: true },
  ],
  bounds: [{ low: { x: 0, y: 0, z: 0 }, high: { x: 1, y: 2, z: 3 } }],
  broadPhase: [{ high: { x: 1, y: 1, z: 1 } }, { high: { x: 2, y: 2, z: 2 } }],
  joints: [{ entityA: 1, entityB: 2, anchorA: { x: 0, y: 1, z: 0 }, anchorB: { x: 0, y: 1.1, z: 0 } }],
  islands: [{ entities: [7, 3] }],
});
const lines = (view: DebugView) =>
  [view.contactLines, view.boundLines, view.jointLines, view.cellLines].map((buffer) => buffer.count / 2);

describe('debug lines', () => {
  it('draws a contact as a point and a line, a box as twelve lines, and a joint as one line plus one per dynamic body', () => {
    const view = new DebugView(new THREE.Scene());
    view.show(scene, all, noPose);
    expect(lines(view)).toEqual([3, 12, 1, 24]);
    expect([view.contactPoints.count, view.jointPoints.count]).toEqual([3, 2]);
    view.show(scene, all, (entity) => (entity === 2 ? [0, 5, 0] : undefined));
    expect(view.jointLines.count / 2).toBe(2);
  });

  it('draws only enabled layers, and nothing after clear', () => {
    const view = new DebugView(new THREE.Scene());
    view.show(scene, { ...none, bounds: true }, noPose);
    expect(lines(view)).toEqual([0, 12, 0, 0]);
    expect([view.boundLines.object.visible, view.contactLines.object.visible]).toEqual([true, false]);
    view.clear();
    expect(lines(view)).toEqual([0, 0, 0, 0]);
    expect(view.boundLines.object.visible).toBe(false);
  });

  it('draws a box from its lower to its upper corner', () => {
    const view = new DebugView(new THREE.Scene());
    view.show(scene, { ...none, bounds: true }, noPose);
    const { geometry } = view.boundLines.object;
    const total = [0, 0, 0];
    const at = geometry.getAttribute('position');
    for (let i = 0; i < 24; i += 2) {
      total[0]! += Math.abs(at.getX(i + 1) - at.getX(i));
      total[1]! += Math.abs(at.getY(i + 1) - at.getY(i));
      total[2]! += Math.abs(at.getZ(i + 1) - at.getZ(i));
    }
    expect(total).toEqual([4 * 1, 4 * 2, 4 * 3]); // four edges each way
  });

  it('colors touching and near contacts differently', () => {
    const view = new DebugView(new THREE.Scene());
    view.show(scene, all, noPose);
    const color = view.contactPoints.object.geometry.getAttribute('color');
    expect(color.getX(0)).toBe(color.getX(2));
    expect(color.getX(0)).not.toBe(color.getX(1));
  });

  it('scales normals with the impulse up to 1.5 m', () => {
    expect([0, 1, 100, 1e9].map((impulse) => +normalLength(impulse).toFixed(2))).toEqual([0.12, 0.18, 0.72, 1.5]);
  });

  it('reuses its buffers and grows them when needed', () => {
    const view = new DebugView(new THREE.Scene());
    view.show(scene, all, noPose);
    const { geometry } = view.boundLines.object;
    const memory = geometry.getAttribute('position');
    for (let i = 0; i < 50; i++) view.show(scene, all, noPose);
    expect(geometry.getAttribute('position')).toBe(memory);
    const many = response({ bounds: Array.from({ length: 1000 }, () => ({ high: { x: 1, y: 1, z: 1 } })) });
    view.show(many, all, noPose);
    expect(lines(view)[1]).toBe(12_000);
    expect(view.boundLines.capacity).toBe(32_768); // 24,000 vertices, rounded up by doubling
  });
});

describe('islands', () => {
  it('get one color per island, independent of body order', () => {
    const tints = islandTints(response({ islands: [{ entities: [7, 3] }, { entities: [4] }, { entities: [] }] }).islands);
    expect(tints.size).toBe(3);
    expect(tints.get(7)).toBe(tints.get(3));
    expect(tints.get(4)).not.toBe(tints.get(3));
    expect(islandTints(response({ islands: [{ entities: [3, 9, 7] }] }).islands).get(9)).toBe(tints.get(3));
  });
});

it('summarizes the counts', () => {
  expect(summary(scene, all)).toBe('3 contacts, 1 island, 1 box, 1 joint, 2 cells');
  expect(summary(response({ truncated: true }), { ...none, contacts: true })).toBe('0 contacts; truncated');
});
