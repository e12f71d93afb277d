import { create } from '@bufbuild/protobuf';
import * as THREE from 'three';
import { expect, it } from 'vitest';
import { EntitySchema } from '@jostle/client/gen/play_pb';
import { Solids } from '../scene/solids';
import { drawArrows, offerText } from './driver';

const car = (id: number, name: string) => create(EntitySchema, { id, name, controllable: true });

it('lists controllable entities', () => {
  expect(offerText([])).toBe('');
  expect(offerText([car(3, 'digger')])).toBe('Press 8 to drive digger');
  expect(offerText([car(3, 'car'), car(4, 'car2')])).toBe('Press 8 to drive one of 2 entities');
});

it('draws an arrow over each visible controllable entity', () => {
  const solids = new Solids(new THREE.Scene());
  solids.begin();
  drawArrows(solids, [car(3, 'car'), car(4, 'car2')], (id) => (id === 3 ? [10, 1, 0, 0, 0, 0, 1] : undefined), 0);
  solids.end();
  expect(solids.count).toBe(1);
  const at = new THREE.Vector3().setFromMatrixPosition(solids.matrixOf('cone', 0));
  expect([at.x, at.z]).toEqual([10, 0]);
  expect(at.y).toBeGreaterThan(3);
});
