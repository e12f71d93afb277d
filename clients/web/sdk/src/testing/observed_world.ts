// A world whose motion is known by formula, seen through a bad link: what pictures do to it. The same as in the tests of the C++
// client library (tests/clients/cpp/core/observed_world.h).

import type { EntityState } from '../snapshot/decode_frame.js';
import { FrameBuffer, POSE_FLOATS } from '../interpolation/frame_buffer.js';
import { RenderedPoses } from '../interpolation/rendered_poses.js';
import { NetworkSimulator, type NetworkConditions } from '../network_simulator/network_simulator.js';
import { RenderClock } from '../clock/render_clock.js';

type Point = readonly [number, number, number];

/**
 * Bodies: 1 goes straight at 2 m/s, 2 runs a circle of 2 m at 3 m/s, 3 bounces 0.4 m high without loss and drifts at 0.5 m/s,
 * 4 leaps by 5 m every 7 s, 5 is there for 3 s of every 6.
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
  const there = [1, 2, 3, 4, 5].filter((body) => isThere(body, s));
  return there.map((id) => {
    const position = positionAt(id, s).map((m) => Math.round(m * SPEC.unitsPerMeter)) as [number, number, number];
    return { id, position, largest: 3, rotation: [0, 0, 0], atRest: false };
  });
}

/** What is watched of a viewer. */
export interface Observation {
  pictures: number;
  backwardSteps: number;
  halfwayLeaps: number;
  ghosts: number;
  leastSpeed: number; // of the clock
  greatestSpeed: number;
  /** How much further a body came in one picture than 1.1 times its top speed explains. */
  stepMm: number;
  /** How far a body was from where it was at the time shown: in 95 % of pictures, and ever. */
  usualErrorMm: number;
  errorMm: number;
  behindMs: number; // mean: shown behind the server
}

class Observer {
  readonly seen: Observation = {
    pictures: 0,
    backwardSteps: 0,
    halfwayLeaps: 0,
    ghosts: 0,
    leastSpeed: 1,
    greatestSpeed: 1,
    stepMm: 0,
    usualErrorMm: 0,
    errorMm: 0,
    behindMs: 0,
  };
  readonly errors: number[] = [];
  private last = new Map<number, Point>();
  private lastShown = 0;

  look(drawn: RenderedPoses, shown: number, s: number, seconds: number): void {
    if (shown < 0) return; // nobody told of what was before the first frame
    const { seen } = this;
    const places = new Map<number, Point>();
    let error = 0;
    for (let i = 0; i < drawn.count; i++) {
      const at = i * POSE_FLOATS;
      const place = [drawn.poses[at]!, drawn.poses[at + 1]!, drawn.poses[at + 2]!] as const;
      places.set(drawn.ids[i]!, place);
      error = Math.max(error, this.setInterestFocus(drawn.ids[i]!, place, shown, seconds));
    }
    this.errors.push(error);
    if (this.last.size > 0) {
      const speed = (shown - this.lastShown) / seconds;
      if (speed < 0) seen.backwardSteps++;
      seen.leastSpeed = Math.min(seen.leastSpeed, speed);
      seen.greatestSpeed = Math.max(seen.greatestSpeed, speed);
    }
    seen.pictures++;
    seen.behindMs += 1000 * (s - shown);
    this.last = places;
    this.lastShown = shown;
  }

  private setInterestFocus(body: number, place: Point, shown: number, seconds: number): number {
    const { seen } = this;
    if (body === 4) {
      if ((place[0] + 0.1) % 5 > 0.2) seen.halfwayLeaps++;
      return 0;
    }
    // One that went or is to come may be off by the frames on either side.
    if (!isThere(body, shown) && !isThere(body, shown + 0.02) && !isThere(body, shown - 0.1)) seen.ghosts++;
    const between = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    const before = this.last.get(body);
    if (before) {
      const explained = 1.1 * TOP_SPEED[body]! * seconds;
      seen.stepMm = Math.max(seen.stepMm, 1000 * (between(place, before) - explained));
    }
    return between(place, positionAt(body, shown));
  }
}

/** So many seconds of frames, 60 a second, over a link, drawn so many times a second. */
export function observe(settings: NetworkConditions, picturesHz: number, seconds = 60): Observation {
  const epochUs = 7e9; // of the server's clock
  const oursUs = 1e6; // of ours, at the same time
  const link = new NetworkSimulator(settings);
  const clock = new RenderClock();
  const frames = new FrameBuffer();
  const drawn = new RenderedPoses();
  const watcher = new Observer();
  let next = 1;
  let arrivalUs = link.arrivalUs(0);
  for (let picture = 0; picture < seconds * picturesHz; picture++) {
    const us = Math.round((picture * 1e6) / picturesHz);
    for (; arrivalUs <= us; next++) {
      const dueUs = Math.round(((next - 1) * 1e6) / 60);
      frames.add({ frame: next, entities: entitiesAt(dueUs / 1e6) }, epochUs + dueUs, SPEC);
      clock.onFrame(epochUs + dueUs, oursUs + arrivalUs);
      arrivalUs = link.arrivalUs(Math.round((next * 1e6) / 60));
    }
    drawn.update(frames, clock.advance(oursUs + us), oursUs + us);
    if (drawn.count > 0) watcher.look(drawn, (clock.renderTimeUs - epochUs) / 1e6, us / 1e6, 1 / picturesHz);
  }
  const { seen, errors } = watcher;
  errors.sort((a, b) => a - b);
  seen.errorMm = 1000 * errors[errors.length - 1]!;
  seen.usualErrorMm = 1000 * errors[Math.floor(errors.length * 0.95)]!;
  seen.behindMs /= seen.pictures;
  return seen;
}
