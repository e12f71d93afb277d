import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { PointForm } from '@jostle/client/gen/play_pb';
import { pickPoints } from './pick_points';
import { pointObject } from '../testing/point_object';

const down = (x: number, z: number) => new THREE.Ray(new THREE.Vector3(x, 10, z), new THREE.Vector3(0, -1, 0));
const rope = pointObject({ form: PointForm.STRANDS, points: 3, strands: [3], radius: 0.02 }, [0, 0, 0, 1, 0, 0, 2, 0, 0]);
const sheet = pointObject({ form: PointForm.GRID, points: 6, columns: 3 }, [0, 1, 0, 1, 1, 0, 2, 1, 0, 0, 1, 1, 1, 1, 1, 2, 1, 1]);

describe('picking point objects', () => {
  it('hits a rope within ten pixels', () => {
    const hit = pickPoints(new Map([[4, rope]]), down(1.5, 0.1))!;
    expect([hit.object, hit.point.x, hit.point.y, hit.point.z]).toEqual([4, 1.5, 0, 0]);
    expect(pickPoints(new Map([[4, rope]]), down(1.5, 0.2))).toBeUndefined();
  });

  it('hits a sheet from both sides and returns the nearest object', () => {
    const both = new Map([
      [4, rope],
      [5, sheet],
    ]);
    const hit = pickPoints(both, down(1.5, 0.05))!;
    expect([hit.object, hit.point.y, hit.distance]).toEqual([5, 1, 9]);
    const up = new THREE.Ray(new THREE.Vector3(1.5, -10, 0.05), new THREE.Vector3(0, 1, 0));
    expect(pickPoints(both, up)!.object).toBe(4);
    expect(pickPoints(new Map([[5, sheet]]), up)!.distance).toBe(11);
    expect(pickPoints(new Map([[5, sheet]]), down(2.5, 0.5))).toBeUndefined();
  });

  it('ignores loose points and objects in the frame of an entity', () => {
    const loose = pointObject({ form: PointForm.LOOSE }, [0, 0, 0]);
    const attached = pointObject({ form: PointForm.STRANDS, points: 2, strands: [2], entity: 7 }, [0, 0, 0, 1, 0, 0]);
    expect(
      pickPoints(
        new Map([
          [1, loose],
          [2, attached],
        ]),
        down(0, 0),
      ),
    ).toBeUndefined();
  });
});
