// Smooth poses: the world is drawn a little in the past, where there is a frame on either side. How far adapts slowly to the
// jitter seen. When frames stop, motion goes on for 50 ms and then holds.

import { POSE_FLOATS, type FrameBuffer, type PoseFrame } from './frame_buffer';

const EXTRAPOLATE_US = 50_000;
const INTERVALS_BEHIND = 1.7;
const ADAPT_SHARE = 0.05;
const LATENESS_KEPT = 120;

export class Delay {
  private lateness: number[] = [];
  private interval = 0;
  private last = 0;
  us = 0;

  /** A frame of that server time arrived; both on the server's clock. After a rest none were sent: their distance says nothing. */
  add(serverUs: number, arrivedUs: number, afterRest = false): void {
    if (!afterRest && this.last > 0 && serverUs > this.last) {
      const interval = serverUs - this.last;
      this.interval = this.interval === 0 ? interval : 0.95 * this.interval + 0.05 * interval;
    }
    this.last = serverUs;
    this.lateness.push(arrivedUs - serverUs);
    if (this.lateness.length > LATENESS_KEPT) this.lateness.shift();
    const sorted = [...this.lateness].sort((a, b) => a - b);
    const earliest = sorted[0]!;
    const jitter = sorted[Math.floor(sorted.length * 0.95)]! - earliest;
    const wanted = earliest + Math.max(INTERVALS_BEHIND * this.interval, this.interval + jitter);
    const most = Math.max(1000, ADAPT_SHARE * this.us);
    this.us = this.us === 0 ? wanted : this.us + Math.min(most, Math.max(-most, wanted - this.us));
  }

  reset(): void {
    this.lateness = [];
    this.interval = this.last = this.us = 0;
  }
}

/** Poses at one moment, reused from frame to frame: no allocation while the number of entities stays. */
export class DrawnPoses {
  ids = new Uint32Array(0);
  poses = new Float64Array(0);
  count = 0;
  source: PoseFrame | undefined;
  /** s past the frame that it is drawn from; mostly a little before it. */
  seconds = 0;

  update(frames: FrameBuffer, serverUs: number): void {
    const pair = frames.around(serverUs);
    if (!pair) {
      this.count = 0;
      this.source = undefined;
      return;
    }
    const { a, b } = pair;
    this.resize(b.entities.length);
    this.source = b;
    this.seconds = Math.min(EXTRAPOLATE_US, serverUs - b.serverUs) / 1e6;
    const left = a.heldUntilUs ?? a.serverUs;
    const width = b.serverUs - left;
    const most = width > 0 ? 1 + EXTRAPOLATE_US / width : 1;
    const t = width > 0 ? Math.min(most, Math.max(0, (serverUs - left) / width)) : 1;
    let from = 0;
    for (let i = 0; i < b.entities.length; i++) {
      const entity = b.entities[i]!;
      this.ids[i] = entity.id;
      while (from < a.entities.length && a.entities[from]!.id < entity.id) from++;
      const old = a.entities[from];
      if (old?.id === entity.id && old !== entity) this.blend(a.poses, from, b.poses, i, t);
      else for (let k = 0; k < POSE_FLOATS; k++) this.poses[i * POSE_FLOATS + k] = b.poses[i * POSE_FLOATS + k]!;
    }
  }

  private resize(count: number): void {
    this.count = count;
    if (this.ids.length >= count) return;
    const room = Math.ceil(count * 1.5);
    this.ids = new Uint32Array(room);
    this.poses = new Float64Array(room * POSE_FLOATS);
  }

  private blend(a: Float64Array, i: number, b: Float64Array, k: number, t: number): void {
    const from = i * POSE_FLOATS;
    const to = k * POSE_FLOATS;
    for (let c = 0; c < 3; c++) this.poses[to + c] = a[from + c]! + t * (b[to + c]! - a[from + c]!);
    let dot = 0;
    for (let c = 3; c < 7; c++) dot += a[from + c]! * b[to + c]!;
    const sign = dot < 0 ? -1 : 1; // the shorter way round
    let norm = 0;
    for (let c = 3; c < 7; c++) {
      const q = a[from + c]! + t * (sign * b[to + c]! - a[from + c]!);
      this.poses[to + c] = q;
      norm += q * q;
    }
    const scale = 1 / Math.sqrt(norm);
    for (let c = 3; c < 7; c++) this.poses[to + c]! *= scale;
  }
}
