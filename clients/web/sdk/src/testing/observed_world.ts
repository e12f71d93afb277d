// A world with motion in closed form, observed over a simulated network. Same as
// tests/clients/cpp/core/observed_world.h.

import type { EntityState } from '../snapshot/decode_frame.js';
import { FrameBuffer, POSE_FLOATS } from '../interpolation/frame_buffer.js';
import { RenderedPoses } from '../interpolation/rendered_poses.js';
import { NetworkSimulator, type NetworkConditions } from '../network_simulator/network_simulator.js';
import { RenderClock } from '../clock/render_clock.js';

type Point = readonly [number, number, number];

/**
 * Bodies: 1 moves straight at 2 m/s, 2 on a circle of 2 m radius at 3 m/s, 3 bounces 0.4 m high without
 * loss and drifts at 0.5 m/s, 4 teleports by 5 m every 7 s, 5 exists for 3 s of every 6 s.
 */
export function positionAt(body: number, s: number): Point {
  if (body === 1) return [2 * s, 0, 0];
  if (body === 2) return [2 * Math.cos(1.5 * s), 0, 2 * Math.sin(1.5 * s)];
  if (body === 3) {
    const g = 9.81;
    const up = Math.sqrt(2 * g * 0.4);
    const t = s % ((2 * up) / g);
    return [0.5 * s, up * t - (g * t * t) / 2, 0];
  }
  return body === 4 ? [5 * Math.floor(s / 7), 0, 0] : [0, 1, 0];
}

const TOP_SPEED = [0, 2, 3, 2.85, 0, 0];
const isThere = (body: number, s: number) => body !== 5 || s % 6 < 3;
const SPEC = { unitsPerMeter: 512, rotationComponent: 511 };

function entitiesAt(s: number): EntityState[] {
  const present = [1, 2, 3, 4, 5].filter((body) => isThere(body, s));
  return present.map((id) => {
    const position = positionAt(id, s).map((m) => Math.round(m * SPEC.unitsPerMeter)) as [number, number, number];
    return { id, position, largest: 3, rotation: [0, 0, 0], atRest: false };
  });
}

/** Measurements of the rendered motion. */
export interface Observation {
  renderedFrames: number;
  backwardSteps: number;
  interpolatedTeleports: number;
  ghosts: number;
  leastSpeed: number; // of the clock
  greatestSpeed: number;
  /** How much farther a body moved in one rendered frame than 1.1 times its top speed allows. */
  stepMm: number;
  /** Distance of a body from its true position at the rendered time: 95th percentile and maximum. */
  errorP95Mm: number;
  errorMm: number;
  delayMs: number; // mean render delay
}

class Observer {
  readonly observation: Observation = {
    renderedFrames: 0,
    backwardSteps: 0,
    interpolatedTeleports: 0,
    ghosts: 0,
    leastSpeed: 1,
    greatestSpeed: 1,
    stepMm: 0,
    errorP95Mm: 0,
    errorMm: 0,
    delayMs: 0,
  };
  readonly errors: number[] = [];
  private last = new Map<number, Point>();
  private lastRenderedS = 0;

  addFrame(poses: RenderedPoses, renderedS: number, s: number, seconds: number): void {
    if (renderedS < 0) return; // before the first frame
    const { observation } = this;
    const positions = new Map<number, Point>();
    let error = 0;
    for (let i = 0; i < poses.count; i++) {
      const at = i * POSE_FLOATS;
      const position = [poses.poses[at]!, poses.poses[at + 1]!, poses.poses[at + 2]!] as const;
      positions.set(poses.ids[i]!, position);
      error = Math.max(error, this.positionError(poses.ids[i]!, position, renderedS, seconds));
    }
    this.errors.push(error);
    if (this.last.size > 0) {
      const speed = (renderedS - this.lastRenderedS) / seconds;
      if (speed < 0) observation.backwardSteps++;
      observation.leastSpeed = Math.min(observation.leastSpeed, speed);
      observation.greatestSpeed = Math.max(observation.greatestSpeed, speed);
    }
    observation.renderedFrames++;
    observation.delayMs += 1000 * (s - renderedS);
    this.last = positions;
    this.lastRenderedS = renderedS;
  }

  private positionError(body: number, position: Point, renderedS: number, seconds: number): number {
    const { observation } = this;
    if (body === 4) {
      if ((position[0] + 0.1) % 5 > 0.2) observation.interpolatedTeleports++;
      return 0;
    }
    // A body that appears or disappears may be off by the adjacent frames.
    if (!isThere(body, renderedS) && !isThere(body, renderedS + 0.02) && !isThere(body, renderedS - 0.1)) observation.ghosts++;
    const distance = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    const previous = this.last.get(body);
    if (previous) {
      const explained = 1.1 * TOP_SPEED[body]! * seconds;
      observation.stepMm = Math.max(observation.stepMm, 1000 * (distance(position, previous) - explained));
    }
    return distance(position, positionAt(body, renderedS));
  }
}

/** `seconds` of frames at 60 Hz over a network, rendered at `renderHz`. */
export function observe(conditions: NetworkConditions, renderHz: number, seconds = 60): Observation {
  const epochUs = 7e9; // on the server's clock
  const localUs = 1e6; // on the local clock, at the same time
  const simulator = new NetworkSimulator(conditions);
  const clock = new RenderClock();
  const frames = new FrameBuffer();
  const poses = new RenderedPoses();
  const observer = new Observer();
  let next = 1;
  let arrivalUs = simulator.send(0).arrivalUs;
  for (let index = 0; index < seconds * renderHz; index++) {
    const us = Math.round((index * 1e6) / renderHz);
    for (; arrivalUs <= us; next++) {
      const dueUs = Math.round(((next - 1) * 1e6) / 60);
      frames.add({ frame: next, entities: entitiesAt(dueUs / 1e6) }, epochUs + dueUs, SPEC);
      clock.onFrame(epochUs + dueUs, localUs + arrivalUs);
      arrivalUs = simulator.send(Math.round((next * 1e6) / 60)).arrivalUs;
    }
    poses.update(frames, clock.advance(localUs + us), localUs + us);
    if (poses.count > 0) observer.addFrame(poses, (clock.renderTimeUs - epochUs) / 1e6, us / 1e6, 1 / renderHz);
  }
  const { observation, errors } = observer;
  errors.sort((a, b) => a - b);
  observation.errorMm = 1000 * errors[errors.length - 1]!;
  observation.errorP95Mm = 1000 * errors[Math.floor(errors.length * 0.95)]!;
  observation.delayMs /= observation.renderedFrames;
  return observation;
}
