// A simulated session in virtual time: a server and a predictor with a network in between, as in
// tests/clients/cpp/prediction/predictor_test.cpp. The world of the server is the same solver, in a
// second predictor that receives only its own state.

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
const RENDER_PERIOD_US = 1e6 / 60;
export const MASS = 125;

export type Point = readonly [number, number, number];

/** The committed module. */
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

/** Poses of all bodies, initially at their starting positions. */
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

/** An impulse that changes the velocity of the own body, in m/s. */
const pushOf = ([x, y, z]: Point): Input => ({ kind: { case: 'impulse', value: { entity: OWN, impulse: { x: MASS * x, y: MASS * y, z: MASS * z } } } });
const distance = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

export class Yard {
  // --- server ---
  serverTick = 0;
  private readonly truth: AllPoses[] = [new AllPoses()]; // by tick
  private serverSequence = 0;
  private applied = 0;
  private marginUs = 0;
  readonly otherClientPushes = new Map<number, Point>(); // by tick; m/s, of the own body
  rejects = false;

  // --- network ---
  private readonly up: NetworkSimulator;
  private readonly down: NetworkSimulator;
  private readonly upstream: { atUs: number; sequence: number; tick: number; input: Input }[] = [];
  private readonly downstream: {
    atUs: number;
    frame: number;
    entities: EntityState[];
    dueUs: number;
    applied: number;
    marginUs: number;
    results: { sequence: number; tick: number; applied: boolean }[];
  }[] = [];

  // --- client ---
  us = 0;
  readonly clock = new InputClock();
  private readonly renderClock = new RenderClock();
  private readonly frames = new FrameBuffer();
  private readonly poses = new RenderedPoses();
  private sequence = 0;
  private nextTickUs = 0;
  private nextRenderUs = 500_000;
  readonly rendered = new Map<number, Point>();
  readonly interpolated = new Map<number, Point>();
  private readonly renderedFrames: { us: number; position: number; own: Point }[] = [];
  private readonly pushed = new Set<number>(); // ticks
  /** mm: largest displacement of the own body in a rendered frame, beyond what `speed` explains. */
  stepMm = 0;
  /** m/s: top speed of the own body. */
  speed = 0;

  private constructor(
    private readonly server: Predictor,
    readonly predictor: Predictor,
    conditions: NetworkConditions,
  ) {
    this.up = new NetworkSimulator(conditions);
    this.down = new NetworkSimulator({ ...conditions, seed: conditions.seed + 1 });
    for (const one of [server, predictor]) {
      one.begin(60, { x: 0, y: -9.81, z: 0 });
      for (const { entity } of BODIES) one.addBody(entity);
      one.follow(OWN);
    }
    this.clock.begin(60);
    server.onFrame({ frame: 1, serverUs: 0, entities: this.statesOf(this.truth[0]!), poses: this.truth[0]!.poses, channels: [] as never });
  }

  static async make(conditions: Partial<NetworkConditions> = { latencyMs: 50, jitterMs: 10 }): Promise<Yard> {
    const module = await predictorModule();
    return new Yard(await Predictor.create(module), await Predictor.create(module), { ...IDEAL_NETWORK, ...conditions });
  }

  private statesOf(all: AllPoses): EntityState[] {
    return BODIES.map(({ entity }) => quantize(entity.id, all.poseOf(entity.id), false));
  }


  private tickServer(): void {
    const tick = ++this.serverTick;
    const dueUs = this.nextTickUs;
    const results = [];
    while (this.upstream.length > 0 && this.upstream[0]!.atUs <= dueUs && this.upstream[0]!.tick <= tick) {
      const message = this.upstream.shift()!;
      this.applied = message.sequence;
      results.push({ sequence: message.sequence, tick, applied: !this.rejects });
      this.marginUs = Math.round((message.tick - tick) * TICK_US + dueUs - message.atUs);
      if (!this.rejects) this.server.addInput(++this.serverSequence, tick, message.input);
    }
    const otherPush = this.otherClientPushes.get(tick);
    if (otherPush) this.server.addInput(++this.serverSequence, tick, pushOf(otherPush));
    const now = new AllPoses();
    for (const id of [OWN, OTHER]) now.poseOf(id)[0] = 1e6; // too far away to smooth: shows the poses of the solver
    this.server.applyTo(now, tick, tick * 1e6);
    this.truth[tick] = now;
    // Its own poses, so that nothing is corrected.
    this.server.onFrame({ frame: tick, serverUs: 0, entities: this.statesOf(now), poses: now.poses, channels: [] as never });
    this.nextTickUs = Math.round(tick * TICK_US);
    this.downstream.push({ atUs: this.down.send(dueUs).arrivalUs, frame: tick, entities: this.statesOf(now), dueUs, applied: this.applied, marginUs: this.marginUs, results });
  }

  private receive(): void {
    while (this.downstream.length > 0 && this.downstream[0]!.atUs <= this.us) {
      const message = this.downstream.shift()!;
      const frame = this.frames.add({ frame: message.frame, entities: message.entities }, message.dueUs, SPEC);
      this.renderClock.onFrame(message.dueUs, this.us);
      this.clock.onFrame(message.frame, this.us - message.dueUs, 55_000, this.us);
      this.clock.onMargin(message.applied, message.marginUs);
      for (const { sequence, tick, applied } of message.results) this.predictor.onResult(sequence, tick, applied);
      this.predictor.onFrame(frame);
    }
  }

  private render(): void {
    this.poses.update(this.frames, this.renderClock.advance(this.us), this.us);
    this.storePositions(this.interpolated);
    const before = this.rendered.get(OWN);
    this.predictor.applyTo(this.poses, this.clock.position(this.us), this.us);
    this.storePositions(this.rendered);
    const own = this.rendered.get(OWN);
    if (!own) return;
    this.renderedFrames.push({ us: this.us, position: this.clock.position(this.us), own });
    if (before) this.stepMm = Math.max(this.stepMm, 1000 * (distance(own, before) - 1.1 * this.speed * (RENDER_PERIOD_US / 1e6)));
  }

  private storePositions(positions: Map<number, Point>): void {
    for (const { entity } of BODIES) {
      const i = this.poses.indexOf(entity.id);
      if (i < 0) continue;
      const [x, y, z] = this.poses.poses.subarray(i * POSE_FLOATS, i * POSE_FLOATS + 3);
      positions.set(entity.id, [x!, y!, z!]);
    }
  }

  push(velocity: Point, ticksLate = 0): void {
    this.pushed.add(this.send(pushOf(velocity), ticksLate));
  }

  /** Returns the tick of the input. */
  send(input: Input, ticksLate = 0): number {
    const tick = this.clock.tick(this.us) - ticksLate;
    this.predictor.addInput(++this.sequence, tick, input);
    this.clock.sent(this.sequence);
    this.upstream.push({ atUs: this.up.send(this.us).arrivalUs, sequence: this.sequence, tick, input });
    return tick;
  }

  /** `rendering`: frames are rendered. */
  run(seconds: number, rendering = true): void {
    const end = this.us + Math.round(seconds * 1e6);
    for (; this.us < end; this.us += 500) {
      if (this.us >= this.nextTickUs) this.tickServer();
      this.receive();
      if (this.us < this.nextRenderUs) continue;
      this.nextRenderUs += Math.round(RENDER_PERIOD_US);
      if (rendering) this.render();
    }
  }

  /**
   * mm: largest distance of the own body from the server's at the same position of the input clock,
   * from `sinceUs` until 0.3 s ago.
   */
  errorMm(sinceUs: number): number {
    let worst = 0;
    for (const { us, position, own } of this.renderedFrames) {
      const tick = Math.floor(position);
      if (us < sinceUs || us > this.us - 300_000 || this.pushed.has(tick + 1)) continue; // half of that step was rendered before the push
      const [a, b] = [this.truth[tick]!.at(OWN), this.truth[tick + 1]!.at(OWN)];
      const t = position - tick;
      worst = Math.max(worst, 1000 * distance(own, [0, 1, 2].map((k) => a[k]! * (1 - t) + b[k]! * t) as unknown as Point));
    }
    return worst;
  }
}
