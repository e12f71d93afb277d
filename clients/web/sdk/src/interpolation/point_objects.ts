// The point objects of a world: ropes, cloth, particles and heights (proto/WIRE.md, "Points"), with
// their positions at the rendered time. Same algorithm as jostle/client/point_objects.h of the C++
// client library.

import type { PointObject, Snapshot } from '../gen/jostle/v1/play_pb.js';
import { DecodeError } from '../snapshot/frame_state.js';
import { NO_POINT, type PointState } from '../snapshot/point_codec.js';
import { PointHistory } from '../snapshot/point_history.js';
import { componentsOf, POINT_OBJECTS_MAX, POINT_TRIANGLES_MAX, PointForm, WORLD_POINTS_MAX, type PointLayout } from '../snapshot/point_layout.js';

const EXTRAPOLATE_S = 0.05;
const LAG_MAX = 12; // ticks
const LAG_SLOPE = 0.1; // of the rendered time: how fast the lag may change
const INTERVALS = 3;
const ELAPSED_MAX = 15; // ticks
const STEP_UM_MAX = 10_000_000;

const clamp = (value: number, low: number, high: number) => Math.min(high, Math.max(low, value));

function layoutOf(object: PointObject): PointLayout {
  if (object.triangles.length > 3 * POINT_TRIANGLES_MAX) throw new DecodeError(`point object ${object.id}: too many triangles`);
  let corner = 0;
  const triangles = object.triangles.map((step) => (corner += step));
  return { form: object.form, points: object.points, columns: object.columns, strands: object.strands, triangles };
}

/** One point object and its newest states. */
export class PointObjectView {
  readonly history: PointHistory;
  /** Coordinates x y z in m of the sampled points, in the frame of `description.entity` or in the world. */
  positions = new Float32Array(0);
  /** Sampled points. */
  count = 0;
  private lag = -1; // ticks
  private lastTick = 0;

  /** Throws DecodeError if the description is invalid. `divisor`: of its channel kind. */
  constructor(
    readonly description: PointObject,
    private readonly divisor: number,
  ) {
    const { id, stepUm } = description;
    if (stepUm === 0 || stepUm > STEP_UM_MAX) throw new DecodeError(`point object ${id}: step ${stepUm} um; must be 1 to ${STEP_UM_MAX}`);
    this.history = new PointHistory(layoutOf(description));
  }

  get layout(): PointLayout {
    return this.history.layout;
  }

  /** Number of points; 0 before the first state of loose points. */
  get points(): number {
    return this.layout.points || (this.history.states.at(-1)?.points.values.length ?? 0) / 3;
  }

  /** Whether a state was received. */
  get hasPoints(): boolean {
    return this.history.states.length > 0;
  }

  /**
   * Computes `positions` at a time in ticks of the server, which increases from call to call. They are
   * interpolated between two states; an object that is sent every few ticks is shown as many ticks later.
   * Without a newer state, motion is extrapolated for at most 50 ms and then held. A new loose point
   * appears at its first state.
   */
  sample(tick: number, tickHz: number): void {
    const states = this.history.states;
    this.count = 0;
    if (states.length === 0) return;
    const target = this.lagTicks();
    const most = LAG_SLOPE * clamp(tick - this.lastTick, 0, ELAPSED_MAX);
    this.lag = this.lag < 0 ? target : this.lag + clamp(target - this.lag, -most, most);
    this.lastTick = tick;
    const at = tick - this.lag;
    let next = Math.min(1, states.length - 1);
    while (next + 1 < states.length && states[next]!.tick < at) next++;
    const b = states[next]!;
    if (next === 0) return this.blend(b.points, b.points, 1);
    const a = states[next - 1]!;
    // The object moved only in the last ticks before b if it was not sent before.
    const width = Math.max(1, Math.min(b.tick - a.tick, this.divisor * (b.points.number - a.points.number)));
    this.blend(a.points, b.points, clamp((at - (b.tick - width)) / width, 0, 1 + (EXTRAPOLATE_S * tickHz) / width));
  }

  /** An object without motion is not sent, so the shortest of the last intervals is its interval. */
  private lagTicks(): number {
    const states = this.history.states;
    let interval = states.length > 1 ? LAG_MAX : 1;
    for (let k = states.length - 1; k > 0 && k + INTERVALS > states.length - 1; k--) interval = Math.min(interval, states[k]!.tick - states[k - 1]!.tick);
    return Math.max(0, interval - 1);
  }

  private blend(a: PointState, b: PointState, t: number): void {
    const components = componentsOf(this.layout.form);
    const count = b.values.length / components;
    if (this.positions.length < 3 * count) this.positions = new Float32Array(3 * Math.ceil(1.5 * count));
    const step = 1e-6 * this.description.stepUm;
    if (this.layout.form === PointForm.Heights) return this.blendHeights(a, b, t, step);
    const { positions } = this;
    let to = 0;
    for (let k = 0; k < count; k++) {
      const from = a === b ? k : b.previous.length === 0 ? k : b.previous[k]!;
      if (from === NO_POINT && t < 1) continue;
      for (let c = 0; c < 3; c++) {
        const q = b.values[3 * k + c]!;
        const p = from === NO_POINT ? q : a.values[3 * from + c]!;
        positions[to++] = step * (p + t * (q - p));
      }
    }
    this.count = to / 3;
  }

  private blendHeights(a: PointState, b: PointState, t: number, step: number): void {
    const { origin, spacingX, spacingZ } = this.description;
    const [x, y, z] = [origin?.x ?? 0, origin?.y ?? 0, origin?.z ?? 0];
    const { columns } = this.layout;
    this.count = b.values.length;
    for (let k = 0; k < this.count; k++) {
      const height = a.values[k]! + t * (b.values[k]! - a.values[k]!);
      this.positions[3 * k] = x + spacingX * (k % columns);
      this.positions[3 * k + 1] = y + step * height;
      this.positions[3 * k + 2] = z + spacingZ * Math.floor(k / columns);
    }
  }
}

/** All point objects of a world. */
export class PointObjects {
  private divisors: readonly number[] = [];
  private readonly views = new Map<number, PointObjectView>();
  private readonly broken = new Set<number>();

  /** By id. */
  get objects(): ReadonlyMap<number, PointObjectView> {
    return this.views;
  }
  /** Whether an object waits for a state without a baseline. */
  get needsKeyframe(): boolean {
    return this.broken.size > 0;
  }

  /** Starts a new stream. `divisors`: of the channel kinds. */
  begin(divisors: readonly number[]): void {
    this.divisors = divisors;
    this.views.clear();
    this.broken.clear();
  }

  /**
   * Applies the point objects of a snapshot. Returns whether all of them were valid; the valid ones are
   * applied. The client should request a keyframe until needsKeyframe is false.
   */
  apply({ pointsEnded, pointObjects, points }: Pick<Snapshot, 'pointsEnded' | 'pointObjects' | 'points'>): boolean {
    for (const id of pointsEnded) {
      this.views.delete(id);
      this.broken.delete(id);
    }
    let valid = true;
    const attempt = (id: number, action: () => void) => {
      try {
        action();
        this.broken.delete(id);
      } catch (error) {
        if (!(error instanceof DecodeError)) throw error;
        this.broken.add(id);
        valid = false;
      }
    };
    for (const object of pointObjects) attempt(object.id, () => this.add(object));
    for (const update of points)
      attempt(update.object, () => {
        const view = this.views.get(update.object);
        if (!view) throw new DecodeError(`point object ${update.object}: not described`);
        view.history.add(update);
        if (this.storedPoints() <= WORLD_POINTS_MAX) return;
        this.views.delete(update.object);
        throw new DecodeError('the point objects have too many points');
      });
    return valid;
  }

  /** Computes the positions of all objects; see PointObjectView.sample(). */
  sample(tick: number, tickHz: number): void {
    for (const view of this.views.values()) view.sample(tick, tickHz);
  }

  private storedPoints(): number {
    let points = 0;
    for (const view of this.views.values()) points += view.points;
    return points;
  }

  private add(object: PointObject): void {
    this.views.delete(object.id);
    const points = this.storedPoints() + object.points;
    if (this.views.size >= POINT_OBJECTS_MAX || points > WORLD_POINTS_MAX) throw new DecodeError(`point object ${object.id}: too many objects or points`);
    this.views.set(object.id, new PointObjectView(object, Math.max(1, this.divisors[object.kind] ?? 1)));
  }
}
