// A yard with a server on one side of a link and a predictor on the other, in virtual time: the same as in the tests of the C++ client
// library (tests/clients/cpp/prediction/predictor_test.cpp). The server's world is the same solver, in a second predictor that is told of
// nothing but itself.

import { readFileSync } from 'node:fs';
import { create } from '@bufbuild/protobuf';
import type { Input } from '../connection/connection.js';
import { FrameBuffer, POSE_FLOATS } from '../interpolation/frame_buffer.js';
import type { EntityState } from '../snapshot/frame_state.js';
import { EntitySchema, type Entity } from '../gen/jostle/v1/play_pb.js';
import { BodyType, ShapeSchema } from '../gen/jostle/v1/scene_pb.js';
import { InputClock } from '../clock/input_clock.js';
import { RenderedPoses } from '../interpolation/rendered_poses.js';
import { NetworkSimulator, IDEAL_NETWORK, type NetworkConditions } from '../network_simulator/network_simulator.js';
import { compile, Predictor, type RenderedScene } from '../prediction/predictor.js';
import { RenderClock } from '../clock/render_clock.js';

export const FLOOR = 1;
export const OWN = 2;
export const OTHER = 3;
export const FAR = 4;
const SPEC = { unitsPerMeter: 512, rotationComponent: 511 };
const TICK_US = 1e6 / 60;
const PICTURE_US = 1e6 / 60;
export const MASS = 125;

export type Point = readonly [number, number, number];

/** The module as it is committed. */
export const predictorModule = () => compile(readFileSync(new URL('../prediction/predictor.wasm', import.meta.url)));

export function box(id: number, type: BodyType, halfExtents: { x: number; y: number; z: number }, mass: number): Entity {
  const shapes = [create(ShapeSchema, { kind: { case: 'box', value: { halfExtents } } })];
  return create(EntitySchema, { id, type, mass, shapes });
}

const half = { x: 0.25, y: 0.25, z: 0.25 };
const BODIES: readonly { entity: Entity; at: Point }[] = [
  { entity: box(FLOOR, BodyType.STATIC, { x: 50, y: 0.5, z: 50 }, 0), at: [0, -0.5, 0] },
  { entity: box(OWN, BodyType.DYNAMIC, half, MASS), at: [0, 0.25, 0] },
  { entity: box(OTHER, BodyType.DYNAMIC, half, MASS), at: [1.5, 0.25, 0] },
  { entity: box(FAR, BodyType.DYNAMIC, half, MASS), at: [20, 0.25, 1] },
];

/** A picture of all bodies, at first as they stand. */
class AllPoses implements RenderedScene {
  readonly poses = new Float64Array(BODIES.length * POSE_FLOATS);
  constructor() {
    BODIES.forEach(({ at }, i) => this.poses.set([...at, 0, 0, 0, 1], i * POSE_FLOATS));
  }
  indexOf(id: number): number {
    return BODIES.findIndex(({ entity }) => entity.id === id);
  }
  poseOf(id: number): Float64Array {
    const i = this.indexOf(id);
    return this.poses.subarray(i * POSE_FLOATS, (i + 1) * POSE_FLOATS);
  }
  at(id: number): Point {
    const [x, y, z] = this.poseOf(id);
    return [x!, y!, z!];
  }
}

/** As proto/snapshot/include/jostle/snapshot/quantize.h. */
function quantize(id: number, pose: Float64Array, atRest: boolean): EntityState {
  const q = [...pose.subarray(3)];
  let largest = 0;
  for (let k = 1; k < 4; k++) if (Math.abs(q[k]!) > Math.abs(q[largest]!)) largest = k;
  const sign = q[largest]! < 0 ? -1 : 1;
  const rotation = q.filter((_, k) => k !== largest).map((c) => Math.round(c * sign * SPEC.rotationComponent * Math.SQRT2));
  const position = [...pose.subarray(0, 3)].map((m) => Math.round(m * SPEC.unitsPerMeter));
  return { id, position: position as [number, number, number], largest, rotation: rotation as [number, number, number], atRest };
}

/** Gives our body so many m/s. */
const pushOf = ([x, y, z]: Point): Input => ({ kind: { case: 'impulse', value: { entity: OWN, impulse: { x: MASS * x, y: MASS * y, z: MASS * z } } } });
const distance = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

export class Yard {
  // --- the server ---
  serverTick = 0;
  private readonly truth: AllPoses[] = [new AllPoses()]; // by tick
  private serverSequence = 0;
  private applied = 0;
  private marginUs = 0;
  readonly otherClientPushes = new Map<number, Point>(); // by tick, m/s, of our body
  refuses = false;

  // --- on the way ---
  private readonly up: NetworkSimulator;
  private readonly down: NetworkSimulator;
  private readonly rising: { atUs: number; sequence: number; tick: number; input: Input }[] = [];
  private readonly falling: {
    atUs: number;
    frame: number;
    entities: EntityState[];
    dueUs: number;
    applied: number;
    marginUs: number;
    results: { sequence: number; tick: number; applied: boolean }[];
  }[] = [];

  // --- the client ---
  us = 0;
  readonly clock = new InputClock();
  private readonly renderClock = new RenderClock();
  private readonly frames = new FrameBuffer();
  private readonly picture = new RenderedPoses();
  private sequence = 0;
  private nextTickUs = 0;
  private nextPictureUs = 500_000;
  readonly drawn = new Map<number, Point>();
  readonly interpolated = new Map<number, Point>();
  private readonly pictures: { us: number; position: number; own: Point }[] = [];
  private readonly pushed = new Set<number>(); // ticks
  /** mm, furthest that our body moved in a picture, beyond what `speed` explains. */
  stepMm = 0;
  /** m/s, of our body at most. */
  speed = 0;

  private constructor(
    private readonly server: Predictor,
    readonly predictor: Predictor,
    link: NetworkConditions,
  ) {
    this.up = new NetworkSimulator(link);
    this.down = new NetworkSimulator({ ...link, seed: link.seed + 1 });
    for (const one of [server, predictor]) {
      one.begin(60, { x: 0, y: -9.81, z: 0 });
      for (const { entity } of BODIES) one.addBody(entity);
      one.follow(OWN);
    }
    this.clock.begin(60);
    server.onFrame({ frame: 1, serverUs: 0, entities: this.statesOf(this.truth[0]!), poses: this.truth[0]!.poses, channels: [] as never });
  }

  static async make(link: Partial<NetworkConditions> = { delay: 50, jitter: 10 }): Promise<Yard> {
    const module = await predictorModule();
    return new Yard(await Predictor.create(module), await Predictor.create(module), { ...IDEAL_NETWORK, ...link });
  }

  private statesOf(all: AllPoses): EntityState[] {
    return BODIES.map(({ entity }) => quantize(entity.id, all.poseOf(entity.id), false));
  }


  private tickServer(): void {
    const tick = ++this.serverTick;
    const dueUs = this.nextTickUs;
    const results = [];
    while (this.rising.length > 0 && this.rising[0]!.atUs <= dueUs && this.rising[0]!.tick <= tick) {
      const sent = this.rising.shift()!;
      this.applied = sent.sequence;
      results.push({ sequence: sent.sequence, tick, applied: !this.refuses });
      this.marginUs = Math.round((sent.tick - tick) * TICK_US + dueUs - sent.atUs);
      if (!this.refuses) this.server.addInput(++this.serverSequence, tick, sent.input);
    }
    const other = this.otherClientPushes.get(tick);
    if (other) this.server.addInput(++this.serverSequence, tick, pushOf(other));
    const now = new AllPoses();
    for (const id of [OWN, OTHER]) now.poseOf(id)[0] = 1e6; // so far away that nothing is walked: it shows the solver's poses
    this.server.draw(now, tick, tick * 1e6);
    this.truth[tick] = now;
    // Its own poses: nothing that it would correct.
    this.server.onFrame({ frame: tick, serverUs: 0, entities: this.statesOf(now), poses: now.poses, channels: [] as never });
    this.nextTickUs = Math.round(tick * TICK_US);
    this.falling.push({ atUs: this.down.arrivalUs(dueUs), frame: tick, entities: this.statesOf(now), dueUs, applied: this.applied, marginUs: this.marginUs, results });
  }

  private listen(): void {
    while (this.falling.length > 0 && this.falling[0]!.atUs <= this.us) {
      const told = this.falling.shift()!;
      const frame = this.frames.add({ frame: told.frame, entities: told.entities }, told.dueUs, SPEC);
      this.renderClock.onFrame(told.dueUs, this.us);
      this.clock.onFrame(told.frame, this.us - told.dueUs, 55_000, this.us);
      this.clock.onMargin(told.applied, told.marginUs);
      for (const { sequence, tick, applied } of told.results) this.predictor.onResult(sequence, tick, applied);
      this.predictor.onFrame(frame);
    }
  }

  private draw(): void {
    this.picture.update(this.frames, this.renderClock.advance(this.us), this.us);
    this.note(this.interpolated);
    const before = this.drawn.get(OWN);
    this.predictor.draw(this.picture, this.clock.position(this.us), this.us);
    this.note(this.drawn);
    const own = this.drawn.get(OWN);
    if (!own) return;
    this.pictures.push({ us: this.us, position: this.clock.position(this.us), own });
    if (before) this.stepMm = Math.max(this.stepMm, 1000 * (distance(own, before) - 1.1 * this.speed * (PICTURE_US / 1e6)));
  }

  private note(where: Map<number, Point>): void {
    for (const { entity } of BODIES) {
      const i = this.picture.indexOf(entity.id);
      if (i < 0) continue;
      const [x, y, z] = this.picture.poses.subarray(i * POSE_FLOATS, i * POSE_FLOATS + 3);
      where.set(entity.id, [x!, y!, z!]);
    }
  }

  push(velocity: Point, ticksLate = 0): void {
    this.pushed.add(this.send(pushOf(velocity), ticksLate));
  }

  /** Which tick it is meant for. */
  send(input: Input, ticksLate = 0): number {
    const tick = this.clock.tick(this.us) - ticksLate;
    this.predictor.addInput(++this.sequence, tick, input);
    this.clock.sent(this.sequence);
    this.rising.push({ atUs: this.up.arrivalUs(this.us), sequence: this.sequence, tick, input });
    return tick;
  }

  /** `watching`: pictures are drawn. */
  run(seconds: number, watching = true): void {
    const end = this.us + Math.round(seconds * 1e6);
    for (; this.us < end; this.us += 500) {
      if (this.us >= this.nextTickUs) this.tickServer();
      this.listen();
      if (this.us < this.nextPictureUs) continue;
      this.nextPictureUs += Math.round(PICTURE_US);
      if (watching) this.draw();
    }
  }

  /** Of our body, from then on until 0.3 s ago: how far pictures were from where the server came to have it at that place of the input clock. */
  offMm(sinceUs: number): number {
    let worst = 0;
    for (const { us, position, own } of this.pictures) {
      const tick = Math.floor(position);
      if (us < sinceUs || us > this.us - 300_000 || this.pushed.has(tick + 1)) continue; // half of that was seen before the push
      const [a, b] = [this.truth[tick]!.at(OWN), this.truth[tick + 1]!.at(OWN)];
      const t = position - tick;
      worst = Math.max(worst, 1000 * distance(own, [0, 1, 2].map((k) => a[k]! * (1 - t) + b[k]! * t) as unknown as Point));
    }
    return worst;
  }
}
