import { create } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { countFacets, fieldGeometry, hullGeometry, meshGeometry } from './facets';
import { HeightFieldSchema, HullSchema, MeshSchema } from '@jostle/client/gen/scene_pb';

const cube = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => ({ x, y, z }))));

describe('hulls', () => {
  it('a cube has 6 faces, and a point inside it changes nothing', () => {
    const hull = hullGeometry(create(HullSchema, { points: [...cube, { x: 0.2, y: 0, z: 0 }] }))!;
    expect(countFacets(hull)).toBe(6);
    expect(hull.getAttribute('position').count).toBe(6 * 2 * 3);
  });

  it('a tetrahedron has 4 outward faces', () => {
    const points = [
      { x: 1, y: 1, z: 1 },
      { x: 1, y: -1, z: -1 },
      { x: -1, y: 1, z: -1 },
      { x: -1, y: -1, z: 1 },
    ];
    const hull = hullGeometry(create(HullSchema, { points }))!;
    expect(countFacets(hull)).toBe(4);
    const corners = hull.getAttribute('position').array;
    const normals = hull.getAttribute('normal').array;
    for (let i = 0; i < corners.length; i += 3)
      expect(corners[i]! * normals[i]! + corners[i + 1]! * normals[i + 1]! + corners[i + 2]! * normals[i + 2]!).toBeCloseTo(
        1 / Math.sqrt(3),
      );
  });

  it('too few or non-finite points give no geometry', () => {
    expect(hullGeometry(create(HullSchema, { points: cube.slice(0, 3) }))).toBeUndefined();
    expect(hullGeometry(create(HullSchema, { points: [...cube, { x: NaN, y: 0, z: 0 }] }))).toBeUndefined();
  });
});

describe('meshes', () => {
  // Two squares that meet along x = 0 like the pages of a book.
  const book = (height: number) => {
    const vertices = [
      { x: -1, y: height, z: 0 },
      { x: -1, y: height, z: 1 },
      { x: 0, y: 0, z: 0 },
      { x: 0, y: 0, z: 1 },
      { x: 1, y: height, z: 0 },
      { x: 1, y: height, z: 1 },
    ];
    return create(MeshSchema, { vertices, indices: [0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4] });
  };

  it('shows creases but no seams in flat surfaces', () => {
    expect(countFacets(meshGeometry(book(1))!)).toBe(2);
    expect(countFacets(meshGeometry(book(0))!)).toBe(1);
  });

  it('stores the true distance to the nearest crease', () => {
    const edge = meshGeometry(create(MeshSchema, { vertices: book(1).vertices, indices: [2, 3, 4] }))!.getAttribute('edge');
    // Side 2 runs from corner 0 to corner 1, along z; corner 2 is sqrt(2) m from it.
    expect([edge.getZ(0), edge.getZ(1)]).toEqual([0, 0]);
    expect(edge.getZ(2)).toBeCloseTo(Math.SQRT2);
  });

  it('skips only triangles with invalid indices', () => {
    const broken = create(MeshSchema, { vertices: book(1).vertices, indices: [0, 1, 99, 1, 3, 2, 5] });
    expect(meshGeometry(broken)!.getAttribute('position').count).toBe(3);
  });
});

describe('height fields', () => {
  const field = (holes: number[], heights = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]) =>
    create(HeightFieldSchema, { columns: 4, rows: 3, spacingX: 2, spacingZ: 1, heights, holes });

  it('has two triangles per cell and none in holes', () => {
    expect(fieldGeometry(field([]))!.getIndex()!.count / 3).toBe(12);
    expect(fieldGeometry(field([4]))!.getIndex()!.count / 3).toBe(10);
    const corners = [...fieldGeometry(field([4]))!.getIndex()!.array];
    // Cell 4 is (column 1, row 1): its diagonal from sample 5 to sample 10 is in no triangle, that of
    // cell 0 is in two.
    const diagonals = (from: number, to: number) =>
      corners.filter((_, i) => i % 3 === 0 && [from, to].every((c) => corners.slice(i, i + 3).includes(c))).length;
    expect([diagonals(5, 10), diagonals(0, 5)]).toEqual([0, 2]);
  });

  it('is centered at the origin and faces up', () => {
    const geometry = fieldGeometry(field([]))!;
    const at = geometry.getAttribute('position');
    expect([at.getX(0), at.getY(0), at.getZ(0)]).toEqual([-3, 0, -1]);
    expect([at.getX(11), at.getY(11), at.getZ(11)]).toEqual([3, 11, 1]);
    for (let i = 0; i < 12; i++) expect(geometry.getAttribute('normal').getY(i)).toBeGreaterThan(0);
  });

  it('leaves holes around non-finite heights', () => {
    const heights = [0, 0, 0, 0, 0, NaN, 0, 0, 0, 0, 0, 0];
    expect(fieldGeometry(field([], heights))!.getIndex()!.count / 3).toBe(12 - 8);
  });

  it('too few heights give no geometry', () => {
    expect(fieldGeometry(field([], [1, 2, 3]))).toBeUndefined();
  });
});
