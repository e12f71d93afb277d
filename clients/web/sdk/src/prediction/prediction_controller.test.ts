// Which body is predicted: the grabbed or pushed one until it rests, but not one with repeated
// corrections.

import { create } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { FrameBuffer } from '../interpolation/frame_buffer.js';
import { WelcomeSchema } from '../gen/jostle/v1/play_pb.js';
import { BodyType } from '../gen/jostle/v1/scene_pb.js';
import { box, predictorModule } from '../testing/yard.js';
import { PredictionController } from './prediction_controller.js';
import { Predictor } from './predictor.js';

const FLOOR = 1;
const CRATE = 2;
const SPEC = { unitsPerMeter: 512, rotationComponent: 511 };

async function room() {
  const predictor = await Predictor.create(await predictorModule());
  const frames = new FrameBuffer();
  const errors: unknown[] = [];
  const prediction = new PredictionController(predictor, frames, (error) => errors.push(error));
  prediction.begin(create(WelcomeSchema, { tickHz: 60, gravity: { y: -9.81 } }));
  prediction.entityAdded(box(FLOOR, BodyType.STATIC, { x: 50, y: 0.5, z: 50 }, 0));
  prediction.entityAdded(box(CRATE, BodyType.DYNAMIC, { x: 0.25, y: 0.25, z: 0.25 }, 50));
  let number = 0;
  const frame = (x: number, atRest = false) => {
    const entity = (id: number, at: readonly number[]) =>
      ({ id, position: at.map((m) => Math.round(m * 512)) as [number, number, number], largest: 3, rotation: [0, 0, 0] as [number, number, number], atRest });
    prediction.frame(frames.add({ frame: ++number, entities: [entity(FLOOR, [0, -0.5, 0]), entity(CRATE, [x, 0.25, 0])] }, number * 16_667, SPEC));
  };
  return { prediction, predictor, errors, frame, tick: () => number };
}

const grab = { kind: { case: 'grab', value: { entity: CRATE, point: { x: 0, y: 0.25, z: 0 } } } } as const;
const release = { kind: { case: 'release', value: {} } } as const;

describe('prediction controller', () => {
  it('follows a grabbed body immediately and stops when it rests', async () => {
    const { prediction, frame, tick } = await room();
    for (let k = 0; k < 5; k++) frame(0, true);
    expect(prediction.stats.bodies).toBe(0);
    prediction.input(1, tick() + 3, grab);
    expect([prediction.followed, prediction.stats.bodies]).toEqual([CRATE, 1]);
    prediction.input(2, tick() + 4, release);
    for (let k = 0; k < 60; k++) frame(0, true);
    expect(prediction.followed).toBe(CRATE);
    frame(0, true);
    expect([prediction.followed, prediction.stats.bodies]).toEqual([0, 0]);
  });

  it('stops predicting a body with repeated corrections', async () => {
    const { prediction, frame, tick } = await room();
    frame(0);
    prediction.input(1, tick() + 3, { kind: { case: 'impulse', value: { entity: CRATE, impulse: { x: 1 } } } });
    let frames = 0;
    for (; prediction.followed === CRATE && frames < 200; frames++) frame(frames % 2); // moved by an unknown cause
    expect(frames, 'more than a sixth of a second').toBeGreaterThan(15);
    expect(frames).toBeLessThan(60);
    prediction.input(2, tick() + 3, grab);
    expect(prediction.followed, 'not again').toBe(0);
  });

  it('follows the controlled entity until it is released', async () => {
    const { prediction, frame, tick } = await room();
    prediction.entityAdded({ ...box(CRATE, BodyType.DYNAMIC, { x: 0.25, y: 0.25, z: 0.25 }, 50), controllable: true });
    frame(0, true);
    prediction.input(1, tick() + 3, { kind: { case: 'possess', value: { entity: CRATE } } });
    expect(prediction.followed).toBe(CRATE);
    prediction.input(2, tick() + 3, { kind: { case: 'impulse', value: { entity: FLOOR, impulse: { x: 1 } } } });
    prediction.input(3, tick() + 3, { kind: { case: 'control', value: { axes: [0, 1000], buttons: 1 } } });
    for (let k = 0; k < 100; k++) frame(0, true);
    expect(prediction.followed, 'at rest, but controlled').toBe(CRATE);
    expect(prediction.stats.bodies, 'its module state is unknown').toBe(0);
    prediction.input(4, tick() + 3, { kind: { case: 'possess', value: { entity: 0 } } });
    expect(prediction.followed).toBe(0);
  });

  it('reports a predictor failure once and stops predicting', async () => {
    const { prediction, predictor, errors, frame, tick } = await room();
    frame(0);
    prediction.input(1, tick() + 3, grab);
    predictor.onFrame = () => {
      throw new WebAssembly.RuntimeError('unreachable');
    };
    for (let k = 0; k < 3; k++) frame(0);
    expect(errors).toHaveLength(1);
    expect(prediction.followed).toBe(0);
  });
});
