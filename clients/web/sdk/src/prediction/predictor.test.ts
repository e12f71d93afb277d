// What the player sees of a push, and how it is put right when somebody else pushes: the stories of
// tests/clients/cpp/prediction/predictor_test.cpp, with the same numbers.

import { create } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { FrameBuffer } from '../interpolation/frame_buffer.js';
import { Vec3Schema } from '../gen/jostle/v1/common_pb.js';
import { EntitySchema } from '../gen/jostle/v1/play_pb.js';
import { BodyType, HullSchema, ShapeSchema } from '../gen/jostle/v1/scene_pb.js';
import { compile, Predictor, PredictorError } from './predictor.js';
import { box, OTHER, OWN, predictorModule, Yard } from '../testing/yard.js';

describe('predictor', () => {
  it('shows a push in its picture instead of a round trip later', async () => {
    const yard = await Yard.make();
    yard.run(3);
    const rest = yard.drawn.get(OWN)!;
    yard.push([2, 0, 0]);
    let [foreseenMs, interpolatedMs] = [0, 0];
    for (let ms = 1; ms < 500 && interpolatedMs === 0; ms++) {
      yard.run(0.001);
      if (foreseenMs === 0 && yard.drawn.get(OWN)![0] - rest[0] > 0.002) foreseenMs = ms;
      if (yard.interpolated.get(OWN)![0] - rest[0] > 0.004) interpolatedMs = ms;
    }
    expect(foreseenMs).toBeGreaterThan(0);
    expect(foreseenMs, 'its picture, or the one after where its tick begins there').toBeLessThanOrEqual(34);
    expect(interpolatedMs, 'there and back, a tick of margin and the delay of pictures').toBeGreaterThanOrEqual(150);
  });

  it('corrects nothing where the server agrees', async () => {
    const yard = await Yard.make();
    yard.run(3);
    const began = yard.us;
    yard.speed = 2;
    let worstToldMm = 0;
    for (let k = 0; k < 5; k++) {
      yard.push([0, 0, k % 2 === 0 ? 2 : -2]);
      for (let picture = 0; picture < 60; picture++) {
        yard.run(1 / 60);
        worstToldMm = Math.max(worstToldMm, 1000 * yard.predictor.stats.lastErrorM);
      }
    }
    expect(yard.predictor.stats.corrections).toBe(0);
    expect(yard.offMm(began)).toBeLessThan(2);
    expect(worstToldMm, 'half a unit in each direction, and a little').toBeLessThan(3);
    expect(yard.stepMm, 'from rest to its speed in one picture').toBeLessThan(20);
  });

  it('walks to what others do without a step', async () => {
    const yard = await Yard.make();
    yard.run(3);
    yard.speed = 3;
    yard.otherClientPushes.set(yard.serverTick + 20, [0, 0, 3]);
    yard.run(0.4);
    expect(yard.predictor.stats.corrections).toBeGreaterThan(0);
    yard.run(1.6);
    expect(yard.stepMm).toBeLessThan(20);
    expect(yard.offMm(yard.us - 600_000)).toBeLessThan(5);
    expect(yard.drawn.get(OWN)![2], 'v^2 / (2 mu g) is 0.92 m').toBeGreaterThan(0.8);
  });

  it('ends where the server has it when both push at once', async () => {
    const yard = await Yard.make();
    yard.run(3);
    yard.speed = 5;
    yard.otherClientPushes.set(yard.serverTick + 12, [0, 0, 3]);
    yard.push([-3, 0, 0]);
    yard.run(2);
    expect(yard.stepMm).toBeLessThan(20);
    expect(yard.offMm(yard.us - 600_000)).toBeLessThan(5);
  });

  it('moves what our body runs into with it', async () => {
    const yard = await Yard.make();
    yard.run(3);
    expect(yard.predictor.stats.bodies, 'ours and the one that is near').toBe(2);
    const stood = yard.drawn.get(OTHER)![0];
    yard.push([4, 0, 0]);
    yard.run(0.4); // it is a metre away
    expect(yard.drawn.get(OTHER)![0] - stood).toBeGreaterThan(0.05);
    expect(yard.interpolated.get(OTHER)![0] - stood).toBeLessThan(0.01);
    yard.run(2);
    expect(yard.offMm(yard.us - 600_000)).toBeLessThan(5);
  });

  it('follows the hand that drags', async () => {
    const yard = await Yard.make();
    yard.run(3);
    const began = yard.us;
    yard.speed = 3;
    const at = (x: number, y: number, z: number) => ({ x, y, z });
    yard.send({ kind: { case: 'grab', value: { entity: OWN, point: at(0.2, 0.45, 0.1) } } });
    for (let k = 0; k < 120; k++) {
      const turn = k / 20;
      yard.send({ kind: { case: 'drag', value: { target: at(0.2 + Math.sin(turn), 0.45 + Math.min(1, k / 60), 0.1 + 1 - Math.cos(turn)) } } });
      yard.run(1 / 60);
    }
    yard.run(0.3); // until the server has told of all of it
    expect(yard.predictor.stats.corrections).toBe(0);
    expect(yard.offMm(began)).toBeLessThan(2);
    expect(yard.stepMm).toBeLessThan(20);
    expect(yard.drawn.get(OWN)![1], 'it was lifted').toBeGreaterThan(1);
  });

  it('takes a refused push back, and moves a late one', async () => {
    const refused = await Yard.make();
    refused.run(3);
    refused.refuses = true;
    refused.speed = 2;
    refused.push([0, 0, 2]);
    refused.run(2);
    expect(refused.offMm(refused.us - 600_000)).toBeLessThan(5);
    expect(refused.stepMm).toBeLessThan(20);
    expect(Math.abs(refused.drawn.get(OWN)![2])).toBeLessThan(0.003);

    const late = await Yard.make();
    late.run(3);
    late.speed = 2;
    late.push([0, 0, 2], 4);
    late.run(2);
    expect(late.offMm(late.us - 600_000)).toBeLessThan(5);
    expect(late.stepMm).toBeLessThan(20);
  });

  it('goes on where it was after half a second in which nothing was drawn', async () => {
    const yard = await Yard.make();
    yard.run(3);
    yard.push([0, 0, 4]);
    yard.run(0.1);
    yard.run(0.5, false);
    const { corrections } = yard.predictor.stats;
    yard.run(2);
    expect(yard.predictor.stats.corrections, 'it was foreseen meanwhile').toBe(corrections);
    expect(yard.offMm(yard.us - 600_000)).toBeLessThan(2);
  });

  it('knows from its first frame how fast a body is, where that is told', async () => {
    const predictor = await Predictor.create(await predictorModule());
    predictor.begin(60, { x: 0, y: 0, z: 0 });
    predictor.addBody(box(7, BodyType.DYNAMIC, { x: 0.5, y: 0.5, z: 0.5 }, 10));
    predictor.follow(7);
    const entity = { id: 7, position: [0, 0, 0] as [number, number, number], largest: 3, rotation: [0, 0, 0] as [number, number, number], atRest: false };
    const told = [{ kind: 4, entity: 7, values: new Int32Array([256, -128, 0, 0, 0, 0]) }]; // 2 and -1 m/s
    predictor.onFrame(new FrameBuffer().add({ frame: 1, entities: [entity] }, 0, { unitsPerMeter: 512, rotationComponent: 511 }, told), 4);
    const poses = new Float64Array([0, 0, 0, 0, 0, 0, 1]);
    const picture = { poses, indexOf: () => 0 };
    predictor.draw(picture, 1, 0);
    for (let k = 1; k <= 120; k++) predictor.draw(picture, 61, k * 16_667);
    expect(poses[0], 'a second later').toBeCloseTo(2, 2);
    expect(poses[1]).toBeCloseTo(-1, 2);
  });

  it('says what is wrong with a module that is none', async () => {
    await expect(compile(new Uint8Array([1, 2, 3]))).rejects.toThrow(/^predictor\.wasm cannot be loaded: /);
    await expect(compile(Promise.resolve(new Response('', { status: 404 })))).rejects.toThrow('predictor.wasm cannot be loaded: the server answers 404');
    const nothing = await WebAssembly.compile(new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]));
    await expect(Predictor.create(nothing)).rejects.toThrow(PredictorError);
  });

  it('leaves out whose shapes the solver cannot have, and says how many', async () => {
    const predictor = await Predictor.create(await predictorModule());
    predictor.begin(60, { x: 0, y: -9.81, z: 0 });
    predictor.addBody(box(1, BodyType.DYNAMIC, { x: 0.5, y: 0.5, z: 0.5 }, 10));
    const points = [create(Vec3Schema), create(Vec3Schema, { x: 1 }), create(Vec3Schema, { z: 1 })];
    const flat = create(ShapeSchema, { kind: { case: 'hull', value: create(HullSchema, { points }) } });
    predictor.addBody(create(EntitySchema, { id: 2, type: BodyType.DYNAMIC, mass: 1, shapes: [flat] }));
    predictor.follow(1);
    const frames = new FrameBuffer();
    const entities = [1, 2].map((id) => ({ id, position: [id * 512, 0, 0] as [number, number, number], largest: 3, rotation: [0, 0, 0] as [number, number, number], atRest: false }));
    predictor.onFrame(frames.add({ frame: 1, entities }, 0, { unitsPerMeter: 512, rotationComponent: 511 }));
    expect(predictor.stats).toMatchObject({ bodies: 1, unusable: 1 });
  });
});
