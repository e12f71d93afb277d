import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { frameFlat, framePoints, freeArea, narrowDistance, NO_INSETS, type Insets } from './framing';

const FROM = new THREE.Vector3(13, 9, 18).normalize();
const FOV = 55;
const [WIDTH, HEIGHT] = [1440, 900];

const cornersOf = ({ min, max }: THREE.Box3) =>
  [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new THREE.Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z));

/** The corners of the box in pixels of a view whose axis is at the center of the free area. */
function corners(box: THREE.Box3, insets: Insets, width = WIDTH, height = HEIGHT): THREE.Vector3[] {
  const area = freeArea(width, height, FOV, insets);
  const camera = new THREE.PerspectiveCamera(FOV, width / height, 0.1, 2000);
  camera.setViewOffset(width, height, -area.offsetX, -area.offsetY, width, height);
  const { position, target } = framePoints(cornersOf(box), FROM, area, 1, 2000);
  camera.position.copy(position);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return cornersOf(box).map((corner) => {
    const p = corner.project(camera);
    return new THREE.Vector3(((p.x + 1) / 2) * width, ((1 - p.y) / 2) * height, 0);
  });
}

const yard = new THREE.Box3(new THREE.Vector3(-12, 0, -12), new THREE.Vector3(12, 3, 12));
const wall = new THREE.Box3(new THREE.Vector3(-15, 0, -0.5), new THREE.Vector3(15, 30, 0.5));

describe('framing', () => {
  for (const [name, insets] of [
    ['without panels', NO_INSETS],
    ['beside panels at both sides', { top: 60, right: 280, bottom: 80, left: 280 }],
    ['above a sheet', { top: 50, right: 0, bottom: 400, left: 0 }],
  ] as const)
    for (const [what, box] of [['a flat yard', yard], ['a tall wall', wall]] as const)
      it(`fits ${what} ${name}`, () => {
        const points = corners(box, insets);
        const xs = points.map(({ x }) => x);
        const ys = points.map(({ y }) => y);
        expect(Math.min(...xs)).toBeGreaterThanOrEqual(insets.left);
        expect(Math.max(...xs)).toBeLessThanOrEqual(WIDTH - insets.right);
        expect(Math.min(...ys)).toBeGreaterThanOrEqual(insets.top);
        expect(Math.max(...ys)).toBeLessThanOrEqual(HEIGHT - insets.bottom);
        // It fills the free area in one direction.
        const fill = Math.max(
          (Math.max(...xs) - Math.min(...xs)) / (WIDTH - insets.left - insets.right),
          (Math.max(...ys) - Math.min(...ys)) / (HEIGHT - insets.top - insets.bottom),
        );
        expect(fill).toBeGreaterThan(0.85);
      });

  it('keeps the minimum distance to a single body', () => {
    const { position, target } = framePoints([new THREE.Vector3(0, 0, 0), new THREE.Vector3(1, 1, 1)], FROM, freeArea(WIDTH, HEIGHT, FOV, NO_INSETS), 9, 80);
    expect(position.distanceTo(target)).toBeCloseTo(9, 6);
  });

  it('fits a planar scene: 20 m wide at 16:10 needs 13.3 m of height with the margin', () => {
    const box = new THREE.Box3(new THREE.Vector3(-10, 0, -1), new THREE.Vector3(10, 4, 1));
    expect(2 * frameFlat(box, freeArea(WIDTH, HEIGHT, FOV, NO_INSETS), FOV)).toBeCloseTo(20 / 1.6 / 0.94, 6);
  });

  it('treats at least a third of the view as free', () => {
    const area = freeArea(390, 844, FOV, { top: 60, right: 0, bottom: 844, left: 0 });
    expect(area.tanY).toBeCloseTo(Math.tan((FOV * Math.PI) / 360) * 0.35, 6);
    expect(Math.abs(area.offsetY)).toBeLessThan(844 * 0.66);
  });
});

it('shows the view of a scene from farther away on a narrow screen', () => {
  expect([1440 / 900, 1.2, 0.6, 390 / 844, 0.1].map(narrowDistance)).toEqual([1, 1, 2, 2.4, 2.4]);
});
