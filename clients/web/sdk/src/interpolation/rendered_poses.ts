// Smooth poses from frames that arrive irregularly. RenderClock gives the rendered time; poses are
// interpolated between the two frames around it. When frames stop, motion is extrapolated for at most
// 50 ms and then holds, because collisions cannot be extrapolated. When frames resume, the error decays
// at a bounded speed (pose_error.ts) instead of jumping. A displacement of more than 100 m/s is a
// teleport: the body stays at the old position until the time of the new frame. Same algorithm as
// jostle/client/interpolation.h of the C++ client library.

import { POSE_FLOATS, type FrameBuffer, type PoseFrame } from './frame_buffer.js';
import { addError, decay, poseError, type Pose } from './pose_error.js';

const EXTRAPOLATE_US = 50_000;
const TELEPORT_SPEED = 100; // m/s
const SAMPLE_GAP_MAX_US = 250_000; // after a longer pause of rendering, errors are discarded

function isTeleport(a: Float64Array, i: number, b: Float64Array, k: number, widthUs: number): boolean {
  const distance = Math.hypot(b[k]! - a[i]!, b[k + 1]! - a[i + 1]!, b[k + 2]! - a[i + 2]!);
  return distance * 1e6 > TELEPORT_SPEED * widthUs;
}

/** Index of an id in an ascending list; -1: not found. */
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

/**
 * Poses at one time, without errors. Reused: nothing is allocated unless the number of entities grows.
 */
class FrameSample {
  ids = new Uint32Array(0);
  poses = new Float64Array(0);
  speeds = new Float64Array(0); // speed and spin of each
  count = 0;
  source: PoseFrame | undefined;

  update(frames: FrameBuffer, serverUs: number): void {
    const pair = frames.around(serverUs);
    this.count = pair?.b.entities.length ?? 0;
    this.source = pair?.b;
    if (!pair) return;
    const { a, b } = pair;
    this.reserve();
    const startUs = a.heldUntilUs ?? a.serverUs;
    const widthUs = b.serverUs - startUs;
    const tMax = widthUs > 0 ? 1 + EXTRAPOLATE_US / widthUs : 1;
    const t = widthUs > 0 ? Math.min(tMax, Math.max(0, (serverUs - startUs) / widthUs)) : 1;
    let from = 0;
    for (let i = 0; i < this.count; i++) {
      const entity = b.entities[i]!;
      this.ids[i] = entity.id;
      this.speeds[2 * i] = this.speeds[2 * i + 1] = 0;
      while (from < a.entities.length && a.entities[from]!.id < entity.id) from++;
      const old = a.entities[from];
      const changed = old?.id === entity.id && old !== entity;
      if (!changed) this.copy(b.poses, i, i);
      else if (isTeleport(a.poses, from * POSE_FLOATS, b.poses, i * POSE_FLOATS, widthUs))
        this.copy(t < 1 ? a.poses : b.poses, t < 1 ? from : i, i);
      else this.blend(a.poses, from, b.poses, i, t, widthUs / 1e6);
    }
  }

  poseAt(i: number): Pose {
    return this.poses.subarray(i * POSE_FLOATS, (i + 1) * POSE_FLOATS);
  }
  speedAt(i: number) {
    return { speed: this.speeds[2 * i]!, spin: this.speeds[2 * i + 1]! };
  }
  indexOf(id: number): number {
    return indexOf(this.count, (i) => this.ids[i]!, id);
  }

  private reserve(): void {
    if (this.ids.length >= this.count) return;
    const capacity = Math.ceil(this.count * 1.5);
    this.ids = new Uint32Array(capacity);
    this.poses = new Float64Array(capacity * POSE_FLOATS);
    this.speeds = new Float64Array(capacity * 2);
  }

  private copy(from: Float64Array, i: number, to: number): void {
    for (let k = 0; k < POSE_FLOATS; k++) this.poses[to * POSE_FLOATS + k] = from[i * POSE_FLOATS + k]!;
  }

  private blend(a: Float64Array, i: number, b: Float64Array, k: number, t: number, seconds: number): void {
    const from = i * POSE_FLOATS;
    const to = k * POSE_FLOATS;
    let square = 0;
    for (let c = 0; c < 3; c++) {
      const displacement = b[to + c]! - a[from + c]!;
      this.poses[to + c] = a[from + c]! + t * displacement;
      square += displacement * displacement;
    }
    let dot = 0;
    for (let c = 3; c < 7; c++) dot += a[from + c]! * b[to + c]!;
    const sign = dot < 0 ? -1 : 1; // the shorter rotation
    let norm = 0;
    for (let c = 3; c < 7; c++) {
      const q = a[from + c]! + t * (sign * b[to + c]! - a[from + c]!);
      this.poses[to + c] = q;
      norm += q * q;
    }
    const scale = 1 / Math.sqrt(norm);
    for (let c = 3; c < 7; c++) this.poses[to + c]! *= scale;
    this.speeds[2 * k] = Math.sqrt(square) / seconds;
    this.speeds[2 * k + 1] = (2 * Math.acos(Math.min(1, Math.abs(dot)))) / seconds;
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
  /** s from the source frame to the rendered time; mostly slightly negative. */
  secondsFromSource = 0;
  private readonly current = new FrameSample();
  private readonly reference = new FrameSample();
  private readonly errors = new Map<number, Pose>(); // by entity
  // The last rendered frame: its time on the local clock and on the server's, and the newest frame at
  // that time.
  private lastSampleUs = 0;
  private lastRenderTimeUs = 0;
  private lastNewestFrameUs = 0;

  get ids(): Uint32Array {
    return this.current.ids;
  }
  get poses(): Float64Array {
    return this.current.poses;
  }
  get count(): number {
    return this.current.count;
  }
  get source(): PoseFrame | undefined {
    return this.current.source;
  }
  /** -1: not in the rendered frame. */
  indexOf(id: number): number {
    return this.current.indexOf(id);
  }
  /** Valid until the next update; undefined: not in the rendered frame. */
  poseOf(id: number): Pose | undefined {
    const i = this.current.indexOf(id);
    return i < 0 ? undefined : this.current.poseAt(i);
  }

  /**
   * Computes the poses at `serverUs` on the server's clock (RenderClock.advance); `nowUs`: local clock.
   */
  update(frames: FrameBuffer, serverUs: number, nowUs: number): void {
    const newestUs = frames.newest?.serverUs ?? 0;
    const elapsedUs = Math.max(0, nowUs - this.lastSampleUs);
    if (elapsedUs > SAMPLE_GAP_MAX_US || newestUs < this.lastNewestFrameUs) this.errors.clear();
    else if (this.lastRenderTimeUs > this.lastNewestFrameUs && newestUs > this.lastNewestFrameUs) this.updateErrors(frames);
    this.current.update(frames, serverUs);
    this.secondsFromSource = this.source ? Math.min(EXTRAPOLATE_US, serverUs - this.source.serverUs) / 1e6 : 0;
    for (const [id, error] of this.errors) {
      const i = this.current.indexOf(id);
      if (i >= 0 && decay(error, this.current.speedAt(i), elapsedUs / 1e6)) addError(this.current.poseAt(i), error);
      else this.errors.delete(id);
    }
    this.lastSampleUs = nowUs;
    this.lastRenderTimeUs = serverUs;
    this.lastNewestFrameUs = newestUs;
  }

  /**
   * The last rendered frame was extrapolated, and the missing frames have arrived: compare it with the
   * correct poses.
   */
  private updateErrors(frames: FrameBuffer): void {
    const correct = this.reference;
    correct.update(frames, this.lastRenderTimeUs);
    for (let i = 0; i < this.count; i++) {
      const id = this.ids[i]!;
      const k = correct.indexOf(id);
      if (k < 0) continue;
      const rendered = this.current.poseAt(i);
      const pose = correct.poseAt(k);
      if (rendered.every((value, c) => value === pose[c])) this.errors.delete(id);
      else {
        const error = teleportedSince(frames, id, this.lastNewestFrameUs) ? undefined : poseError(rendered, pose, correct.speedAt(k));
        if (error) this.errors.set(id, error);
        else this.errors.delete(id);
      }
    }
  }
}
