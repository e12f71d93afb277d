import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import type { Drawer } from './drawers/drawer';
import { NO_CHUNKS } from './module_chunks';
import { ModuleView, type Moment } from './module_view';

const WHITE = new THREE.Color(0xffffff);

/** One line for each byte, where the entity of that number is. */
const drawBytes: Drawer = {
  draw(bytes, { lines, poseOf }) {
    for (const entity of bytes) {
      const x = poseOf(entity)?.[0] ?? 0;
      lines.vertex(x, 0, 0, WHITE);
      lines.vertex(x, 1, 0, WHITE);
    }
  },
  steering: { entities: (bytes) => [...bytes], keys: 'W', camera: 'behind', distance: 5, words: (_bytes, entity) => `number ${entity}` },
  dress: (bytes) => new Map([...bytes].map((entity) => [entity, 0x100000 + entity])),
  words: (bytes) => `${bytes.length} of them`,
};

const moment = (poseOf: Moment['poseOf']): Moment => ({
  seconds: 0,
  nowMs: 0,
  around: { x: 0, y: 0, z: 0 },
  poseOf,
  entityOf: () => undefined,
});

describe('what modules tell', () => {
  it('is drawn by the drawer of its tag, each picture anew, and gone with the chunk', () => {
    const scene = new THREE.Scene();
    const view = new ModuleView(scene, new Map([['bytes', drawBytes]]));
    const where = moment((entity) => [entity * 10]);
    view.update(new Map([['bytes', new Uint8Array([7, 8])]]), where);
    expect(scene.children).toContain(view.lines.object);
    expect(view.lines.count).toBe(4);
    expect(view.lines.object.geometry.getAttribute('position').getX(2)).toBe(80);
    view.update(new Map([['bytes', new Uint8Array([9])]]), where);
    expect(view.lines.count).toBe(2);
    view.update(NO_CHUNKS, where);
    expect(view.lines.count).toBe(0);
    expect(view.lines.object.visible).toBe(false);
  });

  it('is not shown when nobody knows the tag, whatever that is', () => {
    const view = new ModuleView(new THREE.Scene());
    const chunks = ['counter', 'constructor', '__proto__', ''].map((tag) => [tag, new Uint8Array([1])] as const);
    view.update(new Map(chunks), moment(() => undefined));
    expect(view.lines.count).toBe(0);
  });

  it('knows the hovercraft', () => {
    const view = new ModuleView(new THREE.Scene());
    view.update(new Map([['hovercraft', new Uint8Array(40)]]), moment(() => [0, 0, 0, 0, 0, 0, 1]));
    expect(view.lines.count).toBe(8);
  });

  it('says who can be driven, and how', () => {
    const view = new ModuleView(new THREE.Scene(), new Map([['bytes', drawBytes]]));
    view.update(new Map([['bytes', new Uint8Array([7, 8])]]), moment(() => undefined));
    expect(view.steeringOf(8)?.keys).toBe('W');
    expect(view.steeringOf(9)).toBeUndefined();
    expect(view.drivenWords(7)).toBe('number 7');
    expect(view.drivenWords(9)).toBe('');
    expect(view.words()).toBe('2 of them');
  });

  it('dresses bodies anew only when the bytes or the bodies are others', () => {
    const view = new ModuleView(new THREE.Scene(), new Map([['bytes', drawBytes]]));
    const told = (...bytes: number[]) => new Map([['bytes', new Uint8Array(bytes)]]);
    const chunks = told(7);
    expect(view.dress(chunks, false, new Map())).toEqual(new Map([[7, 0x100007]]));
    expect(view.dress(chunks, false, new Map())).toBeUndefined();
    expect(view.dress(chunks, true, new Map())).toBeDefined();
    expect(view.dress(told(9), false, new Map())).toEqual(new Map([[9, 0x100009]]));
  });
});
