// Prediction of impulses and its corrections: the cases and numbers of
// tests/clients/cpp/prediction/predictor_test.cpp.

import { create } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { FrameBuffer } from '../interpolation/frame_buffer.js';
import { Vec3Schema } from '../gen/jostle/v1/common_pb.js';
import { EntitySchema } from '../gen/jostle/v1/play_pb.js';
import { BodyType, HullSchema, ShapeSchema } from '../gen/jostle/v1/scene_pb.js';
import { compile, Predictor, PredictorError } from './predictor.js';
import { box, OTHER, OWN, predictorModule, Yard } from '../testing/yard.js';

describe('predictor', () => {
  it('shows an impulse in the next frame instead of after a round trip', async () => {
    const yard = await Yard.make();
    yard.run(3);
    const rest = yard.rendered.get(OWN)!;
    yard.push([2, 0, 0]);
    let [predictedMs, interpolatedMs] = [0, 0];
    for (let ms = 1; ms < 500 && interpolatedMs === 0; ms++) {
      yard.run(0.001);
      if (predictedMs === 0 && yard.rendered.get(OWN)![0] - rest[0] > 0.002) predictedMs = ms;
      if (yard.interpolated.get(OWN)![0] - rest[0] > 0.004) interpolatedMs = ms;
    }
    expect(predictedMs).toBeGreaterThan(0);
    expect(predictedMs, 'this rendered frame or the next').toBeLessThanOrEqual(34);
    expect(interpolatedMs, 'a round trip, one tick of margin and the render delay').toBeGreaterThanOrEqual(150);
  });

  it('makes no corrections when the server agrees', async () => {
    const yard = await Yard.make();
    yard.run(3);
    const startUs = yard.us;
    yard.speed = 2;
    let worstErrorMm = 0;
    for (let k = 0; k < 5; k++) {
      yard.push([0, 0, k % 2 === 0 ? 2 : -2]);
      for (let frame = 0; frame < 60; frame++) {
        yard.run(1 / 60);
        worstErrorMm = Math.max(worstErrorMm, 1000 * yard.predictor.stats.lastErrorM);
      }
    }
    expect(yard.predictor.stats.corrections).toBe(0);
    expect(yard.errorMm(startUs)).toBeLessThan(2);
    expect(worstErrorMm, 'half a quantization unit per axis, and rounding').toBeLessThan(3);
    expect(yard.stepMm, 'from rest to full speed in one rendered frame').toBeLessThan(20);
  });

  it('smooths corrections caused by other clients', async () => {
    const yard = await Yard.make();
    yard.run(3);
    yard.speed = 3;
    yard.otherClientPushes.set(yard.serverTick + 20, [0, 0, 3]);
    yard.run(0.4);
    expect(yard.predictor.stats.corrections).toBeGreaterThan(0);
    yard.run(1.6);
    expect(yard.stepMm).toBeLessThan(20);
    expect(yard.errorMm(yard.us - 600_000)).toBeLessThan(5);
    expect(yard.rendered.get(OWN)![2], 'v^2 / (2 mu g) is 0.92 m').toBeGreaterThan(0.8);
  });

  it('converges to the server when both clients push', async () => {
    const yard = await Yard.make();
    yard.run(3);
    yard.speed = 5;
    yard.otherClientPushes.set(yard.serverTick + 12, [0, 0, 3]);
    yard.push([-3, 0, 0]);
    yard.run(2);
    expect(yard.stepMm).toBeLessThan(20);
    expect(yard.errorMm(yard.us - 600_000)).toBeLessThan(5);
  });

  it('predicts bodies hit by the predicted body', async () => {
    const yard = await Yard.make();
    yard.run(3);
    expect(yard.predictor.stats.bodies, 'the own body and its neighbor').toBe(2);
    const start = yard.rendered.get(OTHER)![0];
    yard.push([4, 0, 0]);
    yard.run(0.4); // the neighbor is 1 m away
    expect(yard.rendered.get(OTHER)![0] - start).toBeGreaterThan(0.05);
    expect(yard.interpolated.get(OTHER)![0] - start).toBeLessThan(0.01);
    yard.run(2);
    expect(yard.errorMm(yard.us - 600_000)).toBeLessThan(5);
  });

  it('predicts dragging', async () => {
    const yard = await Yard.make();
    yard.run(3);
    const startUs = yard.us;
    yard.speed = 3;
    const at = (x: number, y: number, z: number) => ({ x, y, z });
    yard.send({ kind: { case: 'grab', value: { entity: OWN, point: at(0.2, 0.45, 0.1) } } });
    for (let k = 0; k < 120; k++) {
      const angle = k / 20;
      yard.send({ kind: { case: 'drag', value: { target: at(0.2 + Math.sin(angle), 0.45 + Math.min(1, k / 60), 0.1 + 1 - Math.cos(angle)) } } });
      yard.run(1 / 60);
    }
    yard.run(0.3); // until the server has sent all of it
    expect(yard.predictor.stats.corrections).toBe(0);
    expect(yard.errorMm(startUs)).toBeLessThan(2);
    expect(yard.stepMm).toBeLessThan(20);
    expect(yard.rendered.get(OWN)![1], 'it was lifted').toBeGreaterThan(1);
  });

  it('rolls back a rejected impulse and moves a late one', async () => {
    const rejected = await Yard.make();
    rejected.run(3);
    rejected.rejects = true;
    rejected.speed = 2;
    rejected.push([0, 0, 2]);
    rejected.run(2);
    expect(rejected.errorMm(rejected.us - 600_000)).toBeLessThan(5);
    expect(rejected.stepMm).toBeLessThan(20);
    expect(Math.abs(rejected.rendered.get(OWN)![2])).toBeLessThan(0.003);

    const late = await Yard.make();
    late.run(3);
    late.speed = 2;
    late.push([0, 0, 2], 4);
    late.run(2);
    expect(late.errorMm(late.us - 600_000)).toBeLessThan(5);
    expect(late.stepMm).toBeLessThan(20);
  });

  it('continues at the current pose after half a second without rendering', async () => {
    const yard = await Yard.make();
    yard.run(3);
    yard.push([0, 0, 4]);
    yard.run(0.1);
    yard.run(0.5, false);
    const { corrections } = yard.predictor.stats;
    yard.run(2);
    expect(yard.predictor.stats.corrections, 'predicted meanwhile').toBe(corrections);
    expect(yard.errorMm(yard.us - 600_000)).toBeLessThan(2);
  });

  it('uses velocities of the first frame when they are sent', async () => {
    const predictor = await Predictor.create(await predictorModule());
    predictor.begin(60, { x: 0, y: 0, z: 0 });
    predictor.addBody(box(7, BodyType.DYNAMIC, { x: 0.5, y: 0.5, z: 0.5 }, 10));
    predictor.follow(7);
    const entity = { id: 7, position: [0, 0, 0] as [number, number, number], largest: 3, rotation: [0, 0, 0] as [number, number, number], atRest: false };
    const velocities = [{ kind: 4, entity: 7, values: new Int32Array([256, -128, 0, 0, 0, 0]) }]; // 2 and -1 m/s
    predictor.onFrame(new FrameBuffer().add({ frame: 1, entities: [entity] }, 0, { unitsPerMeter: 512, rotationComponent: 511 }, velocities), 4);
    const poses = new Float64Array([0, 0, 0, 0, 0, 0, 1]);
    const scene = { poses, indexOf: () => 0 };
    predictor.applyTo(scene, 1, 0);
    for (let k = 1; k <= 120; k++) predictor.applyTo(scene, 61, k * 16_667);
    expect(poses[0], 'one second later').toBeCloseTo(2, 2);
    expect(poses[1]).toBeCloseTo(-1, 2);
  });

  it('reports an invalid WebAssembly module', async () => {
    await expect(compile(new Uint8Array([1, 2, 3]))).rejects.toThrow(/^predictor\.wasm cannot be loaded: /);
    await expect(compile(Promise.resolve(new Response('', { status: 404 })))).rejects.toThrow('predictor.wasm cannot be loaded: HTTP status 404');
    const nothing = await WebAssembly.compile(new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]));
    await expect(Predictor.create(nothing)).rejects.toThrow(PredictorError);
  });

  it('skips and counts bodies with unsupported shapes', async () => {
    const predictor = await Predictor.create(await predictorModule());
    predictor.begin(60, { x: 0, y: -9.81, z: 0 });
    predictor.addBody(box(1, BodyType.DYNAMIC, { x: 0.5, y: 0.5, z: 0.5 }, 10));
    const points = [create(Vec3Schema), create(Vec3Schema, { x: 1 }), create(Vec3Schema, { z: 1 })];
    const degenerate = create(ShapeSchema, { kind: { case: 'hull', value: create(HullSchema, { points }) } });
    predictor.addBody(create(EntitySchema, { id: 2, type: BodyType.DYNAMIC, mass: 1, shapes: [degenerate] }));
    predictor.follow(1);
    const frames = new FrameBuffer();
    const entities = [1, 2].map((id) => ({ id, position: [id * 512, 0, 0] as [number, number, number], largest: 3, rotation: [0, 0, 0] as [number, number, number], atRest: false }));
    predictor.onFrame(frames.add({ frame: 1, entities }, 0, { unitsPerMeter: 512, rotationComponent: 511 }));
    expect(predictor.stats).toMatchObject({ bodies: 1, unusable: 1 });
  });
});
