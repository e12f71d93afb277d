// Decoded frames: the newest 32 as bases for the next ones, and as poses ready to be drawn. Each keeps what modules told with it.

import { dequantize, type EntityState, type QuantSpec, type QuantizedFrame } from './decode_frame';
import { NO_CHANNELS, type Channels } from './channels';

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

const RING = 32;

export class FrameBuffer {
  private frames: { quantized: QuantizedFrame; drawn: PoseFrame }[] = [];

  find(frame: number): QuantizedFrame | undefined {
    return frame === 0 ? undefined : this.frames.find((f) => f.quantized.frame === frame)?.quantized;
  }

  /** Of a frame that is still here; none of any other. */
  channelsOf(frame: number): Channels {
    return this.frames.find((f) => f.quantized.frame === frame)?.drawn.channels ?? NO_CHANNELS;
  }

  add(quantized: QuantizedFrame, serverUs: number, spec: QuantSpec, channels: Channels = NO_CHANNELS): PoseFrame {
    const before = this.newest;
    const poses = new Float64Array(quantized.entities.length * POSE_FLOATS);
    let from = 0;
    quantized.entities.forEach((entity, i) => {
      // The decoder hands on the very object of an entity that did not change: its floats need no square root.
      while (before && from < before.entities.length && before.entities[from]!.id < entity.id) from++;
      if (before?.entities[from] === entity) {
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
    if (this.frames.length > RING) this.frames.shift();
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
