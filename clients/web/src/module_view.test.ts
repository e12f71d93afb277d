import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import type { Drawer } from './drawers/drawer';
import { DRAWN_KINDS, ModuleView } from './module_view';

const WHITE = new THREE.Color(0xffffff);
const KINDS = [
  { name: 'rare', divisor: 60 },
  { name: 'lines', divisor: 1 },
];

/** One line for each number, where the entity is. */
const drawLines: Drawer = ({ entity, values }, { lines, poseOf }) => {
  for (const value of values) {
    const x = poseOf(entity)?.[0] ?? 0;
    lines.vertex(x, 0, 0, WHITE);
    lines.vertex(x, value, 0, WHITE);
  }
};

const shown = (...channels: { kind: number; entity: number; values: Int32Array }[]) => ({ frame: 31, channels, later: -0.01, kinds: KINDS, tickHz: 60 });
const poseOf = (entity: number) => [entity * 10];

describe('what modules tell', () => {
  it('is drawn by the drawer of its kind, each picture anew, and gone with the channel', () => {
    const scene = new THREE.Scene();
    const view = new ModuleView(scene, new Map([['lines', drawLines]]));
    view.update(shown({ kind: 1, entity: 8, values: new Int32Array([1, 2]) }), poseOf);
    expect(scene.children).toContain(view.lines.object);
    expect(view.lines.count).toBe(4);
    expect(view.lines.object.geometry.getAttribute('position').getX(2)).toBe(80);
    view.update(shown({ kind: 1, entity: 8, values: new Int32Array([3]) }), poseOf);
    expect(view.lines.count).toBe(2);
    view.update(shown(), poseOf);
    expect(view.lines.count).toBe(0);
    expect(view.lines.object.visible).toBe(false);
  });

  it('knows how long ago it was told: half a second, of one that is told once a second', () => {
    const ages: number[] = [];
    const view = new ModuleView(new THREE.Scene(), new Map([['rare', ({ seconds }) => ages.push(seconds)]]));
    view.update(shown({ kind: 0, entity: 0, values: new Int32Array() }), poseOf);
    expect(ages).toHaveLength(1);
    expect(ages[0]).toBeCloseTo(0.49, 9);
  });

  it('is not shown when nobody knows the kind, whatever that is', () => {
    const view = new ModuleView(new THREE.Scene());
    const channels = [0, 7].map((kind) => ({ kind, entity: 1, values: new Int32Array([1]) }));
    for (const name of ['counter', 'constructor', '__proto__', ''])
      view.update({ ...shown(...channels), kinds: [{ name, divisor: 0 }] }, poseOf);
    expect(view.lines.count).toBe(0);
  });

  it('is asked for by kinds that can be drawn', () => {
    expect(DRAWN_KINDS).toContain('hovercraft');
    const view = new ModuleView(new THREE.Scene());
    const craft = { kind: 0, entity: 3, values: new Int32Array(20) };
    view.update({ ...shown(craft), kinds: [{ name: 'hovercraft', divisor: 1 }] }, () => [0, 0, 0, 0, 0, 0, 1]);
    expect(view.lines.count).toBe(8);
  });
});
