import { create } from '@bufbuild/protobuf';
import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { EntitySchema } from '@jostle/client/gen/play_pb';
import { FrameBuffer, Queries, RenderedPoses } from '@jostle/client';
import { pickFromServer, pickRendered, choosePick, type Pick } from './pick';
import { SceneView } from '../scene/scene_view';

const pick = (entity: number): Pick => ({
  entity,
  shape: 0,
  point: new THREE.Vector3(),
  normal: new THREE.Vector3(0, 1, 0),
  distance: 3,
});

/** A flat height field of 2 m by 2 m with a hole at x > 0, z < 0, and a cone of 1 m radius at x = 5. */
function fieldAndCone(): SceneView {
  const view = new SceneView();
  const heights = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  const field = { columns: 3, rows: 3, spacingX: 1, spacingZ: 1, heights, holes: [1] };
  const cone = { radius: 1, halfLength: 1 };
  const box = { halfExtents: { x: 0.1, y: 0.1, z: 0.1 } };
  view.setEntities(
    new Map([
      [1, create(EntitySchema, { id: 1, shapes: [{ kind: { case: 'heightField', value: field } }] })],
      [
        2,
        create(EntitySchema, {
          id: 2,
          shapes: [
            { kind: { case: 'box', value: box }, position: { x: 0, y: -3, z: 0 } },
            { kind: { case: 'cone', value: cone } },
          ],
        }),
      ],
    ]),
    0,
  );
  const frames = new FrameBuffer();
  const still = { largest: 3, rotation: [0, 0, 0] as [number, number, number], atRest: true };
  frames.add(
    {
      frame: 1,
      entities: [
        { id: 1, position: [0, 0, 0], ...still },
        { id: 2, position: [5 * 512, 0, 0], ...still },
      ],
    },
    0,
    { unitsPerMeter: 512, rotationComponent: 511 },
  );
  const poses = new RenderedPoses();
  poses.update(frames, 0, 0);
  view.update(poses);
  view.scene.updateMatrixWorld();
  return view;
}

const down = (x: number, z: number) =>
  new THREE.Raycaster(new THREE.Vector3(x, 10, z), new THREE.Vector3(0, -1, 0), 0, 100);

describe('picking the rendered scene', () => {
  it('hits a height field but not its hole', () => {
    const view = fieldAndCone();
    const hit = pickRendered(view, down(-0.5, -0.5))!;
    expect([hit.entity, hit.distance, hit.normal.y]).toEqual([1, 10, 1]);
    expect(pickRendered(view, down(0.5, -0.5))).toBeUndefined();
  });

  it('hits the side of a cone and returns the index of the second shape', () => {
    const hit = pickRendered(fieldAndCone(), down(5.5, 0))!;
    expect([hit.entity, hit.shape]).toEqual([2, 1]);
    expect(hit.distance).toBeCloseTo(10, 1); // at half of its radius the cone has half of its height
    expect(hit.normal.y).toBeCloseTo(1 / Math.sqrt(5), 1); // slope 2
  });
});

describe('picking by the server', () => {
  const ray = new THREE.Ray(new THREE.Vector3(0, 10, 0), new THREE.Vector3(0, -1, 0));
  const queries = (json: string) => new Queries(() => 'w', async () => ({ status: 200, text: async () => json }));

  it('returns the first hit with its distance', async () => {
    const json = '{"rays":[{"hits":[{"entity":9,"shape":2,"fraction":0.02,"point":{"x":1},"normal":{"y":1}}]}]}';
    const { hit } = (await pickFromServer(queries(json), ray))!;
    expect([hit!.entity, hit!.shape, hit!.distance, hit!.point.x, hit!.normal.y]).toEqual([9, 2, 10, 1, 1]);
  });

  it('distinguishes no hit from no response', async () => {
    expect(await pickFromServer(queries('{"rays":[{}]}'), ray)).toEqual({ hit: undefined });
    expect(await pickFromServer(queries('no'), ray)).toBeUndefined();
  });
});

describe('choosing between both picks', () => {
  const resting = () => false;
  const moving = () => true;

  it('prefers the server when it responds', () => {
    expect(choosePick(pick(1), { hit: pick(2) }, resting)?.entity).toBe(2);
    expect(choosePick(undefined, { hit: pick(2) }, resting)?.entity).toBe(2);
    expect(choosePick(pick(1), { hit: undefined }, resting)).toBeUndefined();
  });

  it('uses the rendered scene without a response or for a moving body', () => {
    expect(choosePick(pick(1), undefined, resting)?.entity).toBe(1);
    expect(choosePick(pick(1), { hit: undefined }, moving)?.entity).toBe(1);
    expect(choosePick(pick(1), { hit: pick(2) }, moving)?.entity).toBe(1);
  });

  it("uses the server's point when both picks agree on the body", () => {
    const exact = { ...pick(1), distance: 3.001 };
    expect(choosePick(pick(1), { hit: exact }, moving)).toBe(exact);
  });
});
