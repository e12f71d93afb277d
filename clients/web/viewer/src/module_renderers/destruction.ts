// Renders the module "destruction": a stone color per piece, and the share of intact bonds. Layout:
// destruction.h.

import * as THREE from 'three';
import { isOfModule, type ModuleRenderer } from './module_renderer';
import { ValueReader } from './value_reader';

export interface DestructibleState {
  pieces: number;
  bonds: number; // intact
  initialBonds: number;
}

/** undefined if the values are malformed. */
export function readDestructibles(values: Int32Array): DestructibleState[] | undefined {
  const reader = new ValueReader(values);
  const states: DestructibleState[] = [];
  while (reader.left > 0) states.push({ pieces: reader.value(), bonds: reader.value(), initialBonds: reader.value() });
  return reader.failed ? undefined : states;
}

const GOLDEN = 0.618034; // golden ratio: consecutive ids get distant shades
const shade = new THREE.Color();

function stone(id: number): number {
  const turn = (id * GOLDEN) % 1;
  return shade.setHSL(0.045 + 0.035 * turn, 0.3 + 0.16 * ((id * GOLDEN * 7) % 1), 0.48 + 0.16 * turn).getHex();
}

export const destructibles: ModuleRenderer = {
  bodyColors(_data, entities) {
    const colors = new Map<number, number>();
    for (const entity of entities.values())
      if (isOfModule(entity) && entity.shapes.length > 0 && entity.shapes.every(({ kind }) => kind.case === 'hull'))
        colors.set(entity.id, stone(entity.id));
    return colors;
  },
  statusText(data) {
    const states = data.flatMap(({ values }) => readDestructibles(values) ?? []);
    if (states.length === 0) return '';
    const sum = (of: keyof DestructibleState) => states.reduce((total, state) => total + state[of], 0);
    const intact = sum('initialBonds') > 0 ? (100 * sum('bonds')) / sum('initialBonds') : 100;
    return `${states.length} ${states.length === 1 ? 'wall' : 'walls'} in ${sum('pieces')} ${sum('pieces') === 1 ? 'piece' : 'pieces'} · ${Math.floor(intact)} % of the bonds intact`;
  },
};
