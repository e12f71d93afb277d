// Options of the spawn tools: size, mass, material and color, within the limits of SpawnInput.

import type { Input } from '@jostle/client';

type Spawn = Extract<NonNullable<Input['kind']>, { case: 'spawn' }>['value'];
export type SpawnShape = NonNullable<Spawn['shape']>;

export interface Material {
  readonly name: string;
  readonly density: number; // kg/m^3
  readonly friction: number;
  readonly restitution: number;
  readonly color: number; // 0xRRGGBB
}

export const MATERIALS = {
  default: { name: 'Default', density: 1000, friction: 0.5, restitution: 0, color: 0x5b8def },
  wood: { name: 'Wood', density: 600, friction: 0.45, restitution: 0.3, color: 0xb98b56 },
  stone: { name: 'Stone', density: 2600, friction: 0.7, restitution: 0.1, color: 0x8d9299 },
  steel: { name: 'Steel', density: 7850, friction: 0.3, restitution: 0.25, color: 0xa9b4c2 },
  ice: { name: 'Ice', density: 917, friction: 0.03, restitution: 0.05, color: 0xbfe3f5 },
  rubber: { name: 'Rubber', density: 1100, friction: 1, restitution: 0.8, color: 0x3a3f47 },
} as const satisfies Record<string, Material>;
export type MaterialName = keyof typeof MATERIALS;

export const SIZE = { min: 0.1, max: 2, default: 0.7 } as const; // m: the longest edge or the diameter
export const MASS = { min: 0.001, max: 1e6 } as const; // kg

export interface SpawnOptions {
  size: number; // m
  /** kg; undefined: from the density of the material. */
  mass: number | undefined;
  material: MaterialName;
  /** 0xRRGGBB; undefined: chosen by the viewers, or that of the material. */
  color: number | undefined;
}

export const defaultSpawnOptions = (): SpawnOptions => ({ size: SIZE.default, mass: undefined, material: 'default', color: undefined });

export type SpawnKind = 'box' | 'sphere' | 'capsule';

export interface SpawnTemplate {
  readonly shape: SpawnShape;
  readonly color: number | undefined;
  /** Distance from the surface that was clicked to the center, m. */
  readonly reach: number;
}

export function clamp(value: number, min: number, max: number): number {
  return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : min;
}

/** The shape of a spawn; a capsule stands along y, and its length is 1.5 times the size. */
export function spawnTemplate(kind: SpawnKind, options: SpawnOptions): SpawnTemplate {
  const half = clamp(options.size, SIZE.min, SIZE.max) / 2;
  const { density, friction, restitution, color } = MATERIALS[options.material];
  const material =
    options.material === 'default' && options.mass === undefined
      ? {}
      : {
          friction,
          restitution,
          ...(options.mass === undefined ? { density } : { mass: clamp(options.mass, MASS.min, MASS.max) }),
        };
  const shape = {
    box: { case: 'box', value: { halfExtents: { x: half, y: half, z: half } } },
    sphere: { case: 'sphere', value: { radius: half } },
    capsule: { case: 'capsule', value: { radius: 0.63 * half, halfLength: 0.87 * half } },
  } as const;
  return {
    shape: { kind: shape[kind], ...material },
    color: options.color ?? (options.material === 'default' ? undefined : color),
    reach: kind === 'capsule' ? 1.5 * half : half,
  };
}
