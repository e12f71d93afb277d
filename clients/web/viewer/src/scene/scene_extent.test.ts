import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { sceneExtent as cornersOf, type PlacedBody } from './scene_extent';

const body = (x: number, y = 0.5, z = 0, dynamic = true): PlacedBody => ({
  box: new THREE.Box3(new THREE.Vector3(x - 0.5, y - 0.5, z - 0.5), new THREE.Vector3(x + 0.5, y + 0.5, z + 0.5)),
  dynamic,
});
const sceneExtent = (bodies: readonly PlacedBody[]) => new THREE.Box3().setFromPoints(cornersOf(bodies));
const wall = Array.from({ length: 20 }, (_, k) => body(k % 5, 0.5 + Math.floor(k / 5)));

describe('extent of a scene', () => {
  it('ignores a ball that rolled 300 m away and a box that fell', () => {
    const { min, max } = sceneExtent([...wall, body(300), body(2, -400)]);
    expect([min.x, max.x]).toEqual([-0.5, 4.5]);
    expect(min.y).toBe(0);
  });
  it('contains a second group of bodies', () => {
    expect(sceneExtent([...wall, ...wall.map((_, k) => body(80 + (k % 5)))]).max.x).toBe(84.5);
  });
  it('contains bodies that rest on distant static parts', () => {
    expect(sceneExtent([...wall, body(40, 0.5, 0, false), body(39)]).max.x).toBe(40.5);
  });
  it('is empty without bodies', () => {
    expect(sceneExtent([]).isEmpty()).toBe(true);
  });
});
