import { expect, it } from 'vitest';
import { defaultSpawnOptions, spawnTemplate } from './spawn_options';

it('the default box has an edge of 0.7 m and no material of its own', () => {
  const { shape, color, reach } = spawnTemplate('box', defaultSpawnOptions());
  expect(shape).toEqual({ kind: { case: 'box', value: { halfExtents: { x: 0.35, y: 0.35, z: 0.35 } } } });
  expect([color, reach]).toEqual([undefined, 0.35]);
});

it('a material sets density, friction, restitution and color', () => {
  const { shape, color } = spawnTemplate('sphere', { ...defaultSpawnOptions(), material: 'steel', size: 1 });
  expect(shape).toEqual({ kind: { case: 'sphere', value: { radius: 0.5 } }, friction: 0.3, restitution: 0.25, density: 7850 });
  expect(color).toBe(0xa9b4c2);
});

it('a mass replaces the density, and sizes stay between 0.1 and 2 m', () => {
  const { shape } = spawnTemplate('box', { size: 50, mass: 12, material: 'ice', color: 0xff0000 });
  expect(shape).toMatchObject({ mass: 12, friction: 0.03, kind: { value: { halfExtents: { x: 1 } } } });
  expect(shape.density).toBeUndefined();
  expect(spawnTemplate('sphere', { ...defaultSpawnOptions(), size: NaN }).shape.kind).toEqual({ case: 'sphere', value: { radius: 0.05 } });
});
