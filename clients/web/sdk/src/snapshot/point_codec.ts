// Decodes the points of one object (proto/WIRE.md, "Points"), as
// proto/snapshot/include/jostle/snapshot/point_serializer.h.

import { bitWidth } from './bit_reader.js';
import { crc32 } from './crc32.js';
import { parseModels } from './frame_models.js';
import { DecodeError } from './frame_state.js';
import { componentsOf, PointForm, POINT_LEVELS, POINTS_MAX, SOURCES_MAX, type PointLayout, type PointLevel } from './point_layout.js';
import { RangeDecoder, type Models } from './range_decoder.js';
import { COUNT, MAGNITUDE, readCount, readNumber, TAIL } from './range_numbers.js';
import { INITIAL_POINT_MODELS } from './start_point_models.js';

/** A loose point that the previous state does not have. */
export const NO_POINT = -1;
const COORDINATE_MAX = 2 ** 30;
const SPACING_MAX = 255; // in numbers of states
const NO_DEGREE = 3;
const RESIDUAL_CAP = 2 ** 16;
const BIRTH_EXPECTATION = 2 << 10;

/** The points of an object at one time. */
export interface PointState {
  readonly number: number;
  /** componentsOf() the form for each point, in steps of the object. */
  readonly values: Int32Array;
  /** Loose points: for each point its index in the previous state, or NO_POINT; empty for other forms. */
  readonly previous: Int32Array;
  readonly levels: number;
}

const CLASSES = 24;
let total = 0;
function take(models: number): number {
  total += models;
  return total - models;
}
const GONE = take(2);
const BORN = take(COUNT);
const BORN_GAP = take(COUNT);
const BORN_LAST = take(1);
const SIZE = take(CLASSES * MAGNITUDE);
const TAILS = take(CLASSES * TAIL);
const MODEL_COUNT = total;

const start = parseModels(INITIAL_POINT_MODELS, MODEL_COUNT);
const working: Models = { one: new Uint16Array(MODEL_COUNT), updates: new Uint8Array(MODEL_COUNT) };

function initialModels(): Models {
  working.one.set(start.one);
  working.updates.set(start.updates);
  return working;
}

const clamp = (value: number, most: number) => Math.min(most, Math.max(-most, value));

function divideRounded(a: number, b: number): number {
  return a >= 0 ? Math.floor((a + Math.floor(b / 2)) / b) : -Math.floor((-a + Math.floor(b / 2)) / b);
}
const scaled = (step: number, to: number, from: number) => (to === from ? step : divideRounded(step * to, from));

/** The largest degree for which the baselines suffice. */
function degreeLimit(number: number, [b1, b2, b3]: readonly PointState[]): number {
  const near = (a: number, b: number) => a > b && a - b <= SPACING_MAX;
  if (!b1 || !b2 || !near(number, b1.number) || !near(b1.number, b2.number)) return 0;
  return b3 && near(b2.number, b3.number) ? 2 : 1;
}

/** Class of an expected magnitude in sixteenths, two per octave. */
function classOf(expected: number): number {
  const width = bitWidth(expected);
  if (width < 2) return 0;
  return Math.min(2 * (width - 2) + 1 + (Math.floor(expected / 2 ** (width - 2)) & 1), CLASSES - 1);
}

const before = (state: PointState, point: number) => (state.previous.length === 0 ? point : state.previous[point]!);

/** Replaces the points beyond the first `levels` levels by their predictions from the other points. */
function fillCoarse(components: number, order: readonly PointLevel[], values: Int32Array, levels: number): void {
  for (let k = levels; k < order.length; k++) {
    const { points, sources, from, weights } = order[k]!;
    for (let i = 0; i < points.length; i++)
      for (let c = 0; c < components; c++) {
        let sum = 8; // halves round up
        for (let s = 0; s < sources[i]!; s++) sum += weights[i * SOURCES_MAX + s]! * values[from[i * SOURCES_MAX + s]! * components + c]!;
        values[points[i]! * components + c] = clamp(Math.floor(sum / 16), COORDINATE_MAX);
      }
  }
}

function crcOf(values: Int32Array): number {
  const view = new DataView(new ArrayBuffer(4 * values.length));
  for (let k = 0; k < values.length; k++) view.setInt32(4 * k, values[k]!, true);
  return crc32(new Uint8Array(view.buffer));
}

class PointReader {
  private readonly in: RangeDecoder;
  private readonly components: number;
  private values = new Int32Array(0);
  private predictions = new Float64Array(0);
  private depths = new Uint8Array(0); // earlier states that have the point, at most 2
  private readonly residuals: Int32Array; // magnitudes, of connected points
  private readonly expected: number[][]; // mean magnitude of residuals in sixteenths, by depth and component

  constructor(
    bytes: Uint8Array,
    private readonly layout: PointLayout,
    private readonly order: readonly PointLevel[],
  ) {
    this.in = new RangeDecoder(bytes, initialModels());
    this.components = componentsOf(layout.form);
    this.residuals = new Int32Array(layout.points * this.components);
    this.expected = [0, 1, 2].map(() => [0, 0, 0]);
  }

  read(number: number, available: readonly PointState[]): PointState {
    const levels = this.in.raw(2) + 1;
    const used = this.in.raw(2);
    if (used > available.length) this.fail(`${used} baselines are used; ${available.length} are known`);
    const baselines = available.slice(0, used);
    const isLoose = this.layout.form === PointForm.Loose;
    const previous = isLoose ? this.readLifetimes(baselines[0]) : new Int32Array(0);
    const count = isLoose ? previous.length : this.layout.points;
    let degree = NO_DEGREE;
    if (used > 0) {
      degree = this.in.raw(2);
      if (degree !== NO_DEGREE && degree > degreeLimit(number, baselines)) this.fail(`prediction of degree ${degree} needs more or nearer baselines`);
    }
    const scale = this.in.raw(4);
    for (const list of this.expected) list.fill(scale === 0 ? 0 : 2 << scale);
    this.values = new Int32Array(count * this.components);
    this.predict(number, count, previous, baselines, degree);
    if (isLoose) {
      this.expected[0]!.fill(BIRTH_EXPECTATION);
      this.readLoose(baselines[0]);
    } else for (let k = 0; k < levels; k++) this.readLevel(this.order[k]!);
    this.checkEnd();
    if (!this.in.atCleanEnd) this.fail('unexpected bytes at the end');
    fillCoarse(this.components, this.order, this.values, levels);
    return { number, values: this.values, previous, levels };
  }

  private fail(what: string): never {
    throw new DecodeError(`points: ${what} (at byte ${this.in.position})`);
  }
  private checkEnd(): void {
    if (this.in.pastEnd) this.fail('truncated data');
  }

  // ---- loose points ----

  private readLifetimes(baseline: PointState | undefined): Int32Array {
    const size = baseline ? baseline.values.length / this.components : 0;
    const survivors: number[] = [];
    let gone = false;
    for (let point = 0; point < size; point++) {
      gone = this.in.bit(GONE + (gone ? 1 : 0));
      if (!gone) survivors.push(point);
      this.checkEnd();
    }
    const born = readCount(this.in, BORN);
    if (born > POINTS_MAX - survivors.length) this.fail('more points than the limit');
    const count = survivors.length + born;
    const previous = new Int32Array(count);
    const last = born === 0 || this.in.bit(BORN_LAST);
    let at = last ? survivors.length : 0;
    for (let i = 0; i < born; i++, at++) {
      if (!last) at += readCount(this.in, BORN_GAP);
      if (at >= count) this.fail('new point past the end');
      previous[at] = NO_POINT;
    }
    let next = 0;
    for (let k = 0; k < count; k++) if (previous[k] !== NO_POINT) previous[k] = survivors[next++]!;
    this.checkEnd();
    return previous;
  }

  private readLoose(baseline: PointState | undefined): void {
    const newest = [0, 0, 0];
    const size = baseline?.values.length ?? 0;
    if (baseline && size >= 3) for (let c = 0; c < 3; c++) newest[c] = baseline.values[size - 3 + c]!;
    const offsets = [0, 1, 2].map(() => [0, 0, 0]);
    for (let point = 0; point < this.depths.length; point++) {
      const depth = this.depths[point]!;
      for (let c = 0; c < 3; c++) {
        const at = 3 * point + c;
        const offset = offsets[depth]![c]!;
        const predicted = depth === 0 ? newest[c]! : this.predictions[at]! + Math.trunc(offset / 16);
        this.readValue(at, predicted, depth, c, this.expected[depth]![c]!, offset < 0, false);
        if (depth === 0) newest[c] = this.values[at]!;
        else offsets[depth]![c] = offset + Math.trunc((16 * clamp(this.values[at]! - this.predictions[at]!, RESIDUAL_CAP) - offset) / 8);
      }
      this.checkEnd();
    }
  }

  // ---- connected points ----

  private readLevel({ points, sources, from, weights }: PointLevel): void {
    const { components, values, predictions, residuals } = this;
    for (let i = 0; i < points.length; i++) {
      const point = points[i]!;
      const depth = this.depths[point]!;
      for (let c = 0; c < components; c++) {
        let offset = 0;
        let off = 0;
        for (let s = i * SOURCES_MAX; s < i * SOURCES_MAX + sources[i]!; s++) {
          const source = from[s]! * components + c;
          offset += weights[s]! * (values[source]! - predictions[source]!);
          off += residuals[source]!;
        }
        const at = point * components + c;
        let expected = this.expected[depth]![c]!;
        if (sources[i]! > 0) expected = Math.floor((expected + Math.floor((16 * off) / sources[i]!)) / 2);
        this.readValue(at, predictions[at]! + Math.trunc(offset / 16), depth, c, expected, offset < 0, true);
      }
      this.checkEnd();
    }
  }

  // ---- coordinates ----

  private predict(number: number, count: number, previous: Int32Array, [b1, b2, b3]: readonly PointState[], degree: number): void {
    const { components } = this;
    this.predictions = new Float64Array(count * components);
    this.depths = new Uint8Array(count);
    if (!b1 || degree === NO_DEGREE) return;
    for (let point = 0; point < count; point++) {
      const one = previous.length === 0 ? point : previous[point]!;
      if (one === NO_POINT) continue;
      const two = b2 ? before(b1, one) : NO_POINT;
      const three = b2 && b3 && degree === 2 && two !== NO_POINT ? before(b2, two) : NO_POINT;
      this.depths[point] = two === NO_POINT ? 1 : 2;
      for (let c = 0; c < components; c++) {
        const p1 = b1.values[one * components + c]!;
        let predicted = p1;
        if (degree >= 1 && b2 && two !== NO_POINT) {
          const p2 = b2.values[two * components + c]!;
          const dt2 = b1.number - b2.number;
          predicted += scaled(p1 - p2, number - b1.number, dt2);
          if (b3 && three !== NO_POINT) predicted += p1 - p2 - scaled(p2 - b3.values[three * components + c]!, dt2, b2.number - b3.number);
        }
        this.predictions[point * components + c] = predicted;
      }
    }
  }

  private readValue(at: number, predicted: number, depth: number, component: number, expected: number, back: boolean, connected: boolean): void {
    const model = classOf(expected);
    const coded = readNumber(this.in, SIZE + model * MAGNITUDE, TAILS + model * TAIL);
    const value = predicted + (back ? -coded : coded);
    if (value < -COORDINATE_MAX || value > COORDINATE_MAX) this.fail('coordinate out of range');
    this.values[at] = value;
    const size = Math.min(Math.abs(coded), RESIDUAL_CAP);
    const means = this.expected[depth]!;
    means[component]! += Math.trunc((16 * size - means[component]!) / 8);
    if (connected) this.residuals[at] = size;
  }
}

/**
 * Decodes a state. `available`: the states before it, the newest first, each the previous state of the
 * one before it. Throws DecodeError for malformed bytes.
 */
export function decodePoints(layout: PointLayout, order: readonly PointLevel[], number: number, bytes: Uint8Array, crc: number, available: readonly PointState[]): PointState {
  const state = new PointReader(bytes, layout, layout.form === PointForm.Loose ? [] : order).read(number, available);
  if (crcOf(state.values) !== crc) throw new DecodeError(`points: CRC mismatch in state ${number}`);
  return state;
}

export { POINT_LEVELS };
