// Where a body should be, from up to three earlier frames: the twin of proto/snapshot/include/jostle/snapshot/predict.h. Integers, every product below 2^53.

import { INT32_MAX, INT32_MIN, sameRotation, type EntityState, type Four, type Spacing, type Survivor, type Three } from './frame_state.js';

/** a / b to the nearest integer, halves away from zero; b > 0. */
function div(a: number, b: number): number {
  const half = Math.trunc(b / 2);
  return a >= 0 ? Math.trunc((a + half) / b) : -Math.trunc((-a + half) / b);
}

function scale(v: number, n: number, d: number): number {
  return n === d ? v : div(v * n, d);
}

function unpack(state: EntityState, n: number, q: Four): Four {
  let sum = 0;
  let from = 0;
  for (let k = 0; k < 4; k++) {
    if (k === state.largest) continue;
    q[k] = state.rotation[from++]!;
    sum += q[k]! * q[k]!;
  }
  // Below 2^53 the square root of a double is off by less than one.
  let root = Math.floor(Math.sqrt(Math.max(0, n - sum)));
  while (root * root > n - sum && root > 0) root--;
  while ((root + 1) * (root + 1) <= n - sum) root++;
  q[state.largest] = root;
  return q;
}

function face(q: Four, towards: Four): void {
  const dot = q[0] * towards[0] + q[1] * towards[1] + q[2] * towards[2] + q[3] * towards[3];
  if (dot < 0) for (let k = 0; k < 4; k++) q[k] = -q[k]!;
}

export interface Prediction {
  position: Three;
  /** The last step, and how much it differed from the one before. */
  positionStep: Three;
  positionAcceleration: Three;
  rotation: Four;
  rotationStep: Four;
  rotationAcceleration: Four;
  largest: number;
  /** The other three of `rotation`, as a state has them. */
  components: Three;
  positionChange: number;
  rotationChange: number;
}

// What predict works in: thousands of bodies sixty times a second should leave nothing to collect.
const q1: Four = [0, 0, 0, 0];
const q2: Four = [0, 0, 0, 0];
const q3: Four = [0, 0, 0, 0];
const q: Four = [0, 0, 0, 0];
const step: Four = [0, 0, 0, 0];
const change: Four = [0, 0, 0, 0];
const prediction: Prediction = {
  position: [0, 0, 0],
  positionStep: [0, 0, 0],
  positionAcceleration: [0, 0, 0],
  rotation: q,
  rotationStep: step,
  rotationAcceleration: change,
  largest: 0,
  components: [0, 0, 0],
  positionChange: 0,
  rotationChange: 0,
};

/** The result is good until the next call. */
export function predict(s: Survivor, t: Spacing, m: number): Prediction {
  const { b1 } = s;
  const b2 = b1.atRest ? undefined : s.b2;
  const b3 = b2 ? s.b3 : undefined;
  const { position, positionStep, positionAcceleration, components } = prediction;
  let positionChange = 0;
  for (let k = 0; k < 3; k++) {
    const d = b2 ? b1.position[k]! - b2.position[k]! : 0;
    const before = b2 && b3 ? scale(b2.position[k]! - b3.position[k]!, t.dt2, t.dt3) : d;
    position[k] = Math.min(INT32_MAX, Math.max(INT32_MIN, b1.position[k]! + scale(d, t.dt1, t.dt2)));
    positionStep[k] = d;
    positionAcceleration[k] = d - before;
    positionChange += Math.abs(d - before);
  }

  const n = 2 * m * m;
  unpack(b1, n, q1);
  for (let k = 0; k < 4; k++) {
    q[k] = q1[k]!;
    step[k] = 0;
    change[k] = 0;
  }
  if (b2 && !(sameRotation(b1, b2) && (!b3 || sameRotation(b2, b3)))) {
    face(unpack(b2, n, q2), q1);
    let step2 = 0;
    for (let k = 0; k < 4; k++) {
      step[k] = q1[k]! - q2[k]!;
      step2 += step[k]! * step[k]!;
    }
    if (b3) {
      face(unpack(b3, n, q3), q2);
      for (let k = 0; k < 4; k++) change[k] = step[k]! - scale(q2[k]! - q3[k]!, t.dt2, t.dt3);
    }
    if (step2 <= Math.trunc(n / 2)) {
      const acceleration =
        t.dt1 === t.dt2 ? step2 : div(step2 * t.dt1 * (t.dt1 + t.dt2), 2 * t.dt2 * t.dt2);
      const bends = acceleration * m >= Math.trunc(n / 4);
      for (let k = 0; k < 4; k++)
        q[k] = q1[k]! + scale(step[k]!, t.dt1, t.dt2) - (bends ? div(q1[k]! * acceleration, n) : 0);
    } else {
      step.fill(0); // too large to predict from: as if it had not turned
    }
  }
  let largest = 0;
  for (let k = 1; k < 4; k++) if (Math.abs(q[k]!) > Math.abs(q[largest]!)) largest = k;
  const sign = q[largest]! < 0 ? -1 : 1;
  let rotationChange = 0;
  let to = 0;
  for (let k = 0; k < 4; k++) {
    if (k === largest) continue;
    components[to++] = sign * q[k]!;
    rotationChange += Math.abs(change[k]!);
  }
  prediction.largest = largest;
  prediction.positionChange = positionChange;
  prediction.rotationChange = rotationChange;
  return prediction;
}
