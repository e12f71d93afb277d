import { describe, expect, it } from 'vitest';
import { subdivideGrid, subdivideMesh, subdivideStrand } from './subdivision.js';

const circle = (turns: number, z = 0) => [Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns), z];

describe('subdivision', () => {
  it('of a strand passes through its points and follows a circle', () => {
    const points = Array.from({ length: 17 }, (_, k) => circle(k / 32)).flat();
    const smooth = subdivideStrand(points, 4);
    expect(smooth.length).toBe(3 * 65);
    for (let k = 0; k < 17; k++) expect(Math.hypot(smooth[12 * k]! - points[3 * k]!, smooth[12 * k + 1]! - points[3 * k + 1]!)).toBeLessThan(1e-6);
    for (let k = 4; k < 61; k++) expect(Math.abs(Math.hypot(smooth[3 * k]!, smooth[3 * k + 1]!) - 1)).toBeLessThan(1e-4);
  });

  it('of a grid follows a cylinder', () => {
    const points = Array.from({ length: 45 }, (_, k) => circle((k % 9) / 16, 0.3 * Math.floor(k / 9))).flat();
    const smooth = subdivideGrid(points, 9, 5, 3);
    expect(smooth.length).toBe(3 * 25 * 13);
    for (let k = 0; k < 25 * 13; k++) {
      const column = k % 25;
      if (column >= 3 && column <= 21) expect(Math.abs(Math.hypot(smooth[3 * k]!, smooth[3 * k + 1]!) - 1)).toBeLessThan(1.5e-3);
      expect(smooth[3 * k + 2]).toBeCloseTo(0.1 * Math.floor(k / 25), 5);
    }
  });

  it('of a mesh makes four triangles of each and keeps a plane', () => {
    const positions = Array.from({ length: 9 }, (_, k) => [k % 3, 1, Math.floor(k / 3)]).flat();
    const triangles = [0, 1, 3, 4].flatMap((a) => [a, a + 3, a + 1, a + 1, a + 3, a + 4]);
    const fine = subdivideMesh({ positions, triangles: [...triangles, 0, 1, 99] });
    expect(fine.triangles.length).toBe(4 * 24);
    expect(fine.positions.length).toBe(3 * (9 + 16));
    for (let k = 0; k < 25; k++) expect(fine.positions[3 * k + 1]).toBe(1);
  });

  it('of a single point or of nothing is harmless', () => {
    expect([...subdivideStrand([1, 2, 3], 4)]).toEqual([1, 2, 3]);
    expect(subdivideStrand([], 4).length).toBe(0);
    expect(subdivideGrid([], 0, 0, 2).length).toBe(0);
  });
});
