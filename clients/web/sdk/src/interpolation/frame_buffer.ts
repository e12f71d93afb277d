// The newest 32 decoded frames: as baselines of later snapshots, and as poses for rendering, with their
// channels.

import { dequantize, type EntityState, type QuantSpec, type QuantizedFrame } from '../snapshot/decode_frame.js';
import { NO_CHANNELS, type Channels } from '../snapshot/channels.js';
import type { Blend } from '../snapshot/interest_cells.js';

export const POSE_FLOATS = 7; // px py pz qx qy qz qw

export interface PoseFrame {
  readonly frame: number;
  readonly serverUs: number;
  /** Nothing moved from serverUs until this time. */
  readonly heldUntilUs?: number;
  readonly entities: readonly EntityState[];
  /** POSE_FLOATS per entity. */
  readonly poses: Float64Array;
  readonly channels: Channels;
}

const FRAME_HISTORY_MAX = 32;
const TELEPORT_SPEED = 100; // m/s: a larger displacement between two frames is a teleport

interface PoseLike {
  readonly position: ArrayLike<number>;
  readonly rotation: ArrayLike<number>;
}

/** A pose as POSE_FLOATS numbers; `widthUs`: time between a and b. */
function poseBetween(a: PoseLike, b: PoseLike, t: number, widthUs: number): number[] {
  const [p, q, r, s] = [a.position, b.position, a.rotation, b.rotation];
  if (Math.hypot(q[0]! - p[0]!, q[1]! - p[1]!, q[2]! - p[2]!) * 1e6 > TELEPORT_SPEED * widthUs) return [...Array.from(p), ...Array.from(r)];
  const components = [0, 1, 2, 3];
  const sign = components.reduce((dot, k) => dot + r[k]! * s[k]!, 0) < 0 ? -1 : 1; // the shorter rotation
  const blended = components.map((k) => r[k]! + t * (sign * s[k]! - r[k]!));
  const norm = Math.hypot(...blended);
  return [...[0, 1, 2].map((k) => p[k]! + t * (q[k]! - p[k]!)), ...blended.map((c) => c / norm)];
}

export class FrameBuffer {
  private blendsOfNewest: ReadonlyMap<number, Blend> | undefined; // entities of the newest frame that are blended
  private frames: { quantized: QuantizedFrame; poseFrame: PoseFrame }[] = [];

  find(frame: number): QuantizedFrame | undefined {
    return frame === 0 ? undefined : this.frames.find((f) => f.quantized.frame === frame)?.quantized;
  }

  /** Channels of a stored frame; NO_CHANNELS if the frame is not stored. */
  channelsOf(frame: number): Channels {
    return this.frames.find((f) => f.quantized.frame === frame)?.poseFrame.channels ?? NO_CHANNELS;
  }

  /**
   * `blends`: entities that are rendered between two of their states (InterestCells); `tickUs`:
   * duration of a tick.
   */
  add(quantized: QuantizedFrame, serverUs: number, spec: QuantSpec, channels: Channels = NO_CHANNELS, blends?: ReadonlyMap<number, Blend>, tickUs = 0): PoseFrame {
    const previousBlends = this.blendsOfNewest;
    this.blendsOfNewest = blends;
    const previous = this.newest;
    const poses = new Float64Array(quantized.entities.length * POSE_FLOATS);
    let from = 0;
    quantized.entities.forEach((entity, i) => {
      // The decoder returns the same object for an unchanged entity, which saves a square root.
      while (previous && from < previous.entities.length && previous.entities[from]!.id < entity.id) from++;
      const blend = blends?.get(entity.id);
      if (blend) return poses.set(poseBetween(dequantize(blend.from, spec), dequantize(entity, spec), blend.t, blend.ticks * tickUs), i * POSE_FLOATS);
      if (previous?.entities[from] === entity && !previousBlends?.has(entity.id)) {
        const start = from * POSE_FLOATS;
        poses.set(previous.poses.subarray(start, start + POSE_FLOATS), i * POSE_FLOATS);
        return;
      }
      const pose = dequantize(entity, spec);
      poses.set(pose.position, i * POSE_FLOATS);
      poses.set(pose.rotation, i * POSE_FLOATS + 3);
    });
    const poseFrame: PoseFrame = { frame: quantized.frame, serverUs, entities: quantized.entities, poses, channels };
    this.frames.push({ quantized, poseFrame });
    if (this.frames.length > FRAME_HISTORY_MAX) this.frames.shift();
    return poseFrame;
  }

  /** The state of the newest frame lasted until that time. */
  hold(serverUs: number): void {
    const newest = this.frames[this.frames.length - 1];
    if (newest && newest.poseFrame.serverUs < serverUs) newest.poseFrame = { ...newest.poseFrame, heldUntilUs: serverUs };
  }

  get newest(): PoseFrame | undefined {
    return this.frames[this.frames.length - 1]?.poseFrame;
  }

  /** The newest frame and the one before it; fewer at the start. */
  get newestTwo(): PoseFrame[] {
    return this.frames.slice(-2).map((f) => f.poseFrame);
  }

  /**
   * The two frames around a time on the server's clock; at the ends, the first frame twice or the last
   * two frames.
   */
  around(serverUs: number): { a: PoseFrame; b: PoseFrame } | undefined {
    const count = this.frames.length;
    if (count === 0) return undefined;
    let next = count - 1;
    while (next > 0 && this.frames[next - 1]!.poseFrame.serverUs >= serverUs) next--;
    return { a: this.frames[Math.max(0, next - 1)]!.poseFrame, b: this.frames[next]!.poseFrame };
  }

  /** The last frame at or before that time and all later frames; empty if no frame is later. */
  since(serverUs: number): PoseFrame[] {
    const first = this.frames.findIndex((f) => f.poseFrame.serverUs > serverUs);
    return first < 0 ? [] : this.frames.slice(Math.max(0, first - 1)).map((f) => f.poseFrame);
  }

  clear(): void {
    this.frames = [];
  }
}
