// Decoded frames: the newest 32 as bases for the next ones, and as poses ready to be drawn. Each keeps what modules told with it.

import { dequantize, type EntityState, type QuantSpec, type QuantizedFrame } from '../snapshot/decode_frame.js';
import { NO_CHANNELS, type Channels } from '../snapshot/channels.js';
import type { Blend } from '../snapshot/interest_cells.js';

export const POSE_FLOATS = 7; // px py pz qx qy qz qw

export interface PoseFrame {
  readonly frame: number;
  readonly serverUs: number;
  /** Nothing moved from serverUs until then. */
  readonly heldUntilUs?: number;
  readonly entities: readonly EntityState[];
  /** POSE_FLOATS for each entity. */
  readonly poses: Float64Array;
  readonly channels: Channels;
}

const FRAME_HISTORY_MAX = 32;
const TELEPORT_SPEED = 100; // m/s: what went further did not fly there

interface PoseLike {
  readonly position: ArrayLike<number>;
  readonly rotation: ArrayLike<number>;
}

/** POSE_FLOATS. */
function poseBetween(a: PoseLike, b: PoseLike, t: number, widthUs: number): number[] {
  const [p, q, r, s] = [a.position, b.position, a.rotation, b.rotation];
  if (Math.hypot(q[0]! - p[0]!, q[1]! - p[1]!, q[2]! - p[2]!) * 1e6 > TELEPORT_SPEED * widthUs) return [...Array.from(p), ...Array.from(r)];
  const turn = [0, 1, 2, 3];
  const sign = turn.reduce((dot, k) => dot + r[k]! * s[k]!, 0) < 0 ? -1 : 1; // the shorter way round
  const mixed = turn.map((k) => r[k]! + t * (sign * s[k]! - r[k]!));
  const size = Math.hypot(...mixed);
  return [...[0, 1, 2].map((k) => p[k]! + t * (q[k]! - p[k]!)), ...mixed.map((c) => c / size)];
}

export class FrameBuffer {
  private blendsOfNewest: ReadonlyMap<number, Blend> | undefined; // of the newest frame
  private frames: { quantized: QuantizedFrame; drawn: PoseFrame }[] = [];

  find(frame: number): QuantizedFrame | undefined {
    return frame === 0 ? undefined : this.frames.find((f) => f.quantized.frame === frame)?.quantized;
  }

  /** Of a frame that is still here; none of any other. */
  channelsOf(frame: number): Channels {
    return this.frames.find((f) => f.quantized.frame === frame)?.drawn.channels ?? NO_CHANNELS;
  }

  /** `blends`: who is drawn on its way to where the frame has it (InterestCells), and how long a tick is. */
  add(quantized: QuantizedFrame, serverUs: number, spec: QuantSpec, channels: Channels = NO_CHANNELS, blends?: ReadonlyMap<number, Blend>, tickUs = 0): PoseFrame {
    const wereOnTheirWay = this.blendsOfNewest;
    this.blendsOfNewest = blends;
    const before = this.newest;
    const poses = new Float64Array(quantized.entities.length * POSE_FLOATS);
    let from = 0;
    quantized.entities.forEach((entity, i) => {
      // The decoder hands on the very object of an entity that did not change: its floats need no square root.
      while (before && from < before.entities.length && before.entities[from]!.id < entity.id) from++;
      const blend = blends?.get(entity.id);
      if (blend) return poses.set(poseBetween(dequantize(blend.from, spec), dequantize(entity, spec), blend.t, blend.ticks * tickUs), i * POSE_FLOATS);
      if (before?.entities[from] === entity && !wereOnTheirWay?.has(entity.id)) {
        const start = from * POSE_FLOATS;
        poses.set(before.poses.subarray(start, start + POSE_FLOATS), i * POSE_FLOATS);
        return;
      }
      const pose = dequantize(entity, spec);
      poses.set(pose.position, i * POSE_FLOATS);
      poses.set(pose.rotation, i * POSE_FLOATS + 3);
    });
    const drawn: PoseFrame = { frame: quantized.frame, serverUs, entities: quantized.entities, poses, channels };
    this.frames.push({ quantized, drawn });
    if (this.frames.length > FRAME_HISTORY_MAX) this.frames.shift();
    return drawn;
  }

  /** What the newest frame shows was so until that time. */
  hold(serverUs: number): void {
    const newest = this.frames[this.frames.length - 1];
    if (newest && newest.drawn.serverUs < serverUs) newest.drawn = { ...newest.drawn, heldUntilUs: serverUs };
  }

  get newest(): PoseFrame | undefined {
    return this.frames[this.frames.length - 1]?.drawn;
  }

  /** The newest, and before it the one before; fewer at the beginning. */
  get newestTwo(): PoseFrame[] {
    return this.frames.slice(-2).map((f) => f.drawn);
  }

  /** The two frames around a time on the server's clock; twice the same at the ends. */
  around(serverUs: number): { a: PoseFrame; b: PoseFrame } | undefined {
    const count = this.frames.length;
    if (count === 0) return undefined;
    let next = count - 1;
    while (next > 0 && this.frames[next - 1]!.drawn.serverUs >= serverUs) next--;
    return { a: this.frames[Math.max(0, next - 1)]!.drawn, b: this.frames[next]!.drawn };
  }

  /** The last frame not after that time, and all that are. */
  since(serverUs: number): PoseFrame[] {
    const first = this.frames.findIndex((f) => f.drawn.serverUs > serverUs);
    return first < 0 ? [] : this.frames.slice(Math.max(0, first - 1)).map((f) => f.drawn);
  }

  clear(): void {
    this.frames = [];
  }
}
