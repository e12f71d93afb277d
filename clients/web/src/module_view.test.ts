import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import type { Drawer } from './drawers/drawer';
import { NO_CHUNKS } from './module_chunks';
import { ModuleView } from './module_view';

const WHITE = new THREE.Color(0xffffff);

/** One line for each byte, where the entity of that number is. */
const drawBytes: Drawer = (bytes, { lines, poseOf }) => {
  for (const entity of bytes) {
    const x = poseOf(entity)?.[0] ?? 0;
    lines.vertex(x, 0, 0, WHITE);
    lines.vertex(x, 1, 0, WHITE);
  }
};

describe('what modules tell', () => {
  it('is drawn by the drawer of its tag, each picture anew, and gone with the chunk', () => {
    const scene = new THREE.Scene();
    const view = new ModuleView(scene, new Map([['bytes', drawBytes]]));
    const poseOf = (entity: number) => [entity * 10];
    view.update(new Map([['bytes', new Uint8Array([7, 8])]]), poseOf);
    expect(scene.children).toContain(view.lines.object);
    expect(view.lines.count).toBe(4);
    expect(view.lines.object.geometry.getAttribute('position').getX(2)).toBe(80);
    view.update(new Map([['bytes', new Uint8Array([9])]]), poseOf);
    expect(view.lines.count).toBe(2);
    view.update(NO_CHUNKS, poseOf);
    expect(view.lines.count).toBe(0);
    expect(view.lines.object.visible).toBe(false);
  });

  it('is not shown when nobody knows the tag, whatever that is', () => {
    const view = new ModuleView(new THREE.Scene());
    const chunks = ['counter', 'constructor', '__proto__', ''].map((tag) => [tag, new Uint8Array([1])] as const);
    view.update(new Map(chunks), () => undefined);
    expect(view.lines.count).toBe(0);
  });

  it('knows the hovercraft', () => {
    const view = new ModuleView(new THREE.Scene());
    view.update(new Map([['hovercraft', new Uint8Array(40)]]), () => [0, 0, 0, 0, 0, 0, 1]);
    expect(view.lines.count).toBe(8);
  });
});
