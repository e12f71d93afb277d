import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { PointForm } from '@jostle/client/gen/play_pb';
import { PointObjectsView } from './point_objects_view';
import { gridNormals, gridTriangles } from './surface_geometry';
import { ringsOf, tubeTriangles, writeTube } from './tube_geometry';
import { pointObject } from '../testing/point_object';

const plane = (columns: number, rows: number) => Array.from({ length: columns * rows }, (_, k) => [k % columns, 0, Math.floor(k / columns)]).flat();
const noPose = () => undefined;

describe('point objects', () => {
  it('of every form are drawn and removed', () => {
    const scene = new THREE.Scene();
    const drawn = new PointObjectsView(scene);
    const objects = new Map([
      [1, pointObject({ form: PointForm.LOOSE }, [1, 2, 3, 4, 5, 6])],
      [2, pointObject({ form: PointForm.STRANDS, points: 3, strands: [3] }, [0, 0, 0, 1, 0, 0, 2, 0, 0])],
      [3, pointObject({ form: PointForm.GRID, points: 6, columns: 3 }, plane(3, 2))],
      [4, pointObject({ form: PointForm.TRIANGLES, points: 3, triangles: [0, 1, 1] }, plane(3, 1))],
      [5, pointObject({ form: PointForm.HEIGHTS, points: 6, columns: 3 }, plane(3, 2))],
    ]);
    drawn.update(objects, noPose);
    expect(drawn.count).toBe(5);
    expect(scene.children.length).toBe(5);
    objects.delete(3);
    drawn.update(objects, noPose);
    expect(scene.children.length).toBe(4);
  });

  it('attached to an entity move with it and are hidden without it', () => {
    const scene = new THREE.Scene();
    const drawn = new PointObjectsView(scene);
    const objects = new Map([[1, pointObject({ form: PointForm.LOOSE, entity: 7 }, [0, 0, 0])]]);
    drawn.update(objects, noPose);
    expect(drawn.count).toBe(0);
    drawn.update(objects, (entity) => (entity === 7 ? [1, 2, 3, 0, 0, 0, 1] : undefined));
    expect(drawn.count).toBe(1);
    expect(scene.children[0]!.position.toArray()).toEqual([1, 2, 3]);
  });

  it('of a level sheet have normals that point up', () => {
    const normals = new Float32Array(3 * 12);
    gridNormals(plane(4, 3), 4, 3, normals);
    for (let k = 0; k < 12; k++) expect([...normals.subarray(3 * k, 3 * k + 3)].map((n) => n + 0)).toEqual([0, 1, 0]);
    expect(gridTriangles(4, 3).length).toBe(6 * 6);
  });

  it('of strands are tubes of their radius', () => {
    const [points, sides] = [3, 6];
    const positions = new Float32Array(3 * ringsOf(points) * sides);
    const normals = new Float32Array(3 * ringsOf(points) * sides);
    writeTube([0, 0, 0, 1, 0, 0, 2, 0, 0], points, 0.5, sides, positions, normals, 0);
    for (let k = 0; k < ringsOf(points) * sides; k++) {
      const ring = Math.floor(k / sides);
      expect(Math.hypot(positions[3 * k + 1]!, positions[3 * k + 2]!)).toBeCloseTo(ring === 0 || ring === 4 ? 0 : 0.5, 6);
      expect(positions[3 * k]).toBeCloseTo([0, 0, 1, 2, 2][ring]!, 6);
    }
    expect(normals[0]).toBe(-1);
    expect(normals.at(-3)).toBe(1);
    expect(tubeTriangles([3, 2], sides).length).toBe(3 * 2 * sides * 3);
  });
});
