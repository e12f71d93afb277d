// Smooth poses from frames that arrive unevenly. What a picture shows is RenderClock's; poses lie between the two frames around it.
// When frames stop, motion goes on for at most 50 ms and then holds: bodies that collide cannot be guessed further. When they come
// again, what was guessed wrongly is walked off at a bounded speed (pose_error.ts) instead of jumping. A body that went further than
// 100 m/s explain did not fly there: it is shown at the old place until the new frame's time. The C++ client library has the same.

import { POSE_FLOATS, type FrameBuffer, type PoseFrame } from './frame_buffer.js';
import { addError, decay, poseError, type Pose } from './pose_error.js';

const EXTRAPOLATE_US = 50_000;
const TELEPORT_SPEED = 100; // m/s
const SAMPLE_GAP_MAX_US = 250_000; // who did not draw for so long shows the world anew: nobody saw what it looked like before

function isTeleport(a: Float64Array, i: number, b: Float64Array, k: number, widthUs: number): boolean {
  const distance = Math.hypot(b[k]! - a[i]!, b[k + 1]! - a[i + 1]!, b[k + 2]! - a[i + 2]!);
  return distance * 1e6 > TELEPORT_SPEED * widthUs;
}

/** Where an id is in a rising list; -1: nowhere. */
function indexOf(count: number, idAt: (i: number) => number, id: number): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (idAt(middle) < id) low = middle + 1;
    else high = middle;
  }
  return low < count && idAt(low) === id ? low : -1;
}

const indexIn = ({ entities }: PoseFrame, id: number) => indexOf(entities.length, (i) => entities[i]!.id, id);

/** Poses at one moment, without errors; reused, so that nothing is allocated while the number of entities stays. */
class FrameSample {
  ids = new Uint32Array(0);
  poses = new Float64Array(0);
  paces = new Float64Array(0); // speed and spin of each
  count = 0;
  source: PoseFrame | undefined;

  update(frames: FrameBuffer, serverUs: number): void {
    const pair = frames.around(serverUs);
    this.count = pair?.b.entities.length ?? 0;
    this.source = pair?.b;
    if (!pair) return;
    const { a, b } = pair;
    this.makeRoom();
    const left = a.heldUntilUs ?? a.serverUs;
    const width = b.serverUs - left;
    const most = width > 0 ? 1 + EXTRAPOLATE_US / width : 1;
    const t = width > 0 ? Math.min(most, Math.max(0, (serverUs - left) / width)) : 1;
    let from = 0;
    for (let i = 0; i < this.count; i++) {
      const entity = b.entities[i]!;
      this.ids[i] = entity.id;
      this.paces[2 * i] = this.paces[2 * i + 1] = 0;
      while (from < a.entities.length && a.entities[from]!.id < entity.id) from++;
      const old = a.entities[from];
      const known = old?.id === entity.id && old !== entity;
      if (!known) this.copy(b.poses, i, i);
      else if (isTeleport(a.poses, from * POSE_FLOATS, b.poses, i * POSE_FLOATS, width))
        this.copy(t < 1 ? a.poses : b.poses, t < 1 ? from : i, i);
      else this.blend(a.poses, from, b.poses, i, t, width / 1e6);
    }
  }

  poseAt(i: number): Pose {
    return this.poses.subarray(i * POSE_FLOATS, (i + 1) * POSE_FLOATS);
  }
  speedAt(i: number) {
    return { speed: this.paces[2 * i]!, spin: this.paces[2 * i + 1]! };
  }
  indexOf(id: number): number {
    return indexOf(this.count, (i) => this.ids[i]!, id);
  }

  private makeRoom(): void {
    if (this.ids.length >= this.count) return;
    const room = Math.ceil(this.count * 1.5);
    this.ids = new Uint32Array(room);
    this.poses = new Float64Array(room * POSE_FLOATS);
    this.paces = new Float64Array(room * 2);
  }

  private copy(from: Float64Array, i: number, to: number): void {
    for (let k = 0; k < POSE_FLOATS; k++) this.poses[to * POSE_FLOATS + k] = from[i * POSE_FLOATS + k]!;
  }

  private blend(a: Float64Array, i: number, b: Float64Array, k: number, t: number, seconds: number): void {
    const from = i * POSE_FLOATS;
    const to = k * POSE_FLOATS;
    let square = 0;
    for (let c = 0; c < 3; c++) {
      const way = b[to + c]! - a[from + c]!;
      this.poses[to + c] = a[from + c]! + t * way;
      square += way * way;
    }
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
    this.paces[2 * k] = Math.sqrt(square) / seconds;
    this.paces[2 * k + 1] = (2 * Math.acos(Math.min(1, Math.abs(dot)))) / seconds;
  }
}

function teleportedSince(frames: FrameBuffer, id: number, serverUs: number): boolean {
  const list = frames.since(serverUs);
  for (let k = 1; k < list.length; k++) {
    const [a, b] = [list[k - 1]!, list[k]!];
    const i = indexIn(a, id);
    const j = indexIn(b, id);
    if (i >= 0 && j >= 0 && isTeleport(a.poses, i * POSE_FLOATS, b.poses, j * POSE_FLOATS, b.serverUs - (a.heldUntilUs ?? a.serverUs))) return true;
  }
  return false;
}

export class RenderedPoses {
  /** s past the frame that it is drawn from; mostly a little before it. */
  seconds = 0;
  private readonly now = new FrameSample();
  private readonly before = new FrameSample();
  private readonly errors = new Map<number, Pose>(); // by entity
  // The last picture: its time on our clock and on the server's, and what was the newest frame.
  private lastSampleUs = 0;
  private lastRenderTimeUs = 0;
  private lastNewestFrameUs = 0;

  get ids(): Uint32Array {
    return this.now.ids;
  }
  get poses(): Float64Array {
    return this.now.poses;
  }
  get count(): number {
    return this.now.count;
  }
  get source(): PoseFrame | undefined {
    return this.now.source;
  }
  /** -1: it is not in the picture. */
  indexOf(id: number): number {
    return this.now.indexOf(id);
  }

  /** What is to be drawn at nowUs on our clock, which shows serverUs of the server's (RenderClock.advance). */
  update(frames: FrameBuffer, serverUs: number, nowUs: number): void {
    const newestUs = frames.newest?.serverUs ?? 0;
    const passedUs = Math.max(0, nowUs - this.lastSampleUs);
    if (passedUs > SAMPLE_GAP_MAX_US || newestUs < this.lastNewestFrameUs) this.errors.clear();
    else if (this.lastRenderTimeUs > this.lastNewestFrameUs && newestUs > this.lastNewestFrameUs) this.updateErrors(frames);
    this.now.update(frames, serverUs);
    this.seconds = this.source ? Math.min(EXTRAPOLATE_US, serverUs - this.source.serverUs) / 1e6 : 0;
    for (const [id, error] of this.errors) {
      const i = this.now.indexOf(id);
      if (i >= 0 && decay(error, this.now.speedAt(i), passedUs / 1e6)) addError(this.now.poseAt(i), error);
      else this.errors.delete(id);
    }
    this.lastSampleUs = nowUs;
    this.lastRenderTimeUs = serverUs;
    this.lastNewestFrameUs = newestUs;
  }

  /** The last picture was a guess, and now there are the frames that it lacked: what would it have shown? */
  private updateErrors(frames: FrameBuffer): void {
    const right = this.before;
    right.update(frames, this.lastRenderTimeUs);
    for (let i = 0; i < this.count; i++) {
      const id = this.ids[i]!;
      const k = right.indexOf(id);
      if (k < 0) continue;
      const shown = this.now.poseAt(i);
      const pose = right.poseAt(k);
      if (shown.every((value, c) => value === pose[c])) this.errors.delete(id);
      else {
        const error = teleportedSince(frames, id, this.lastNewestFrameUs) ? undefined : poseError(shown, pose, right.speedAt(k));
        if (error) this.errors.set(id, error);
        else this.errors.delete(id);
      }
    }
  }
}
