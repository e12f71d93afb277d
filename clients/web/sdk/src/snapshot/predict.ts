// Predicts the pose of a body from up to three earlier frames, as
// proto/snapshot/include/jostle/snapshot/predict.h. Integer arithmetic; every product is below 2^53.

import { INT32_MAX, INT32_MIN, sameRotation, type EntityState, type Four, type Spacing, type Survivor, type Three } from './frame_state.js';

/** a / b rounded to the nearest integer, halves away from zero; b > 0. */
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
  // Below 2^53 the square root of a double is off by less than 1.
  let root = Math.floor(Math.sqrt(Math.max(0, n - sum)));
  while (root * root > n - sum && root > 0) root--;
  while ((root + 1) * (root + 1) <= n - sum) root++;
  q[state.largest] = root;
  return q;
}

function alignSign(q: Four, reference: Four): void {
  const dot = q[0] * reference[0] + q[1] * reference[1] + q[2] * reference[2] + q[3] * reference[3];
  if (dot < 0) for (let k = 0; k < 4; k++) q[k] = -q[k]!;
}

export interface Prediction {
  position: Three;
  /** The last step, and its change since the step before. */
  positionStep: Three;
  positionAcceleration: Three;
  rotation: Four;
  rotationStep: Four;
  rotationAcceleration: Four;
  largest: number;
  /** The other three components of `rotation`, as stored in a state. */
  components: Three;
  positionChange: number;
  rotationChange: number;
}

// Reused between calls to avoid garbage for thousands of bodies at 60 Hz.
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

/** Predicts the pose of the next frame. The result is valid until the next call. */
export function predict(s: Survivor, t: Spacing, m: number): Prediction {
  const { b1 } = s;
  const b2 = b1.atRest ? undefined : s.b2;
  const b3 = b2 ? s.b3 : undefined;
  const { position, positionStep, positionAcceleration, components } = prediction;
  let positionChange = 0;
  for (let k = 0; k < 3; k++) {
    const d = b2 ? b1.position[k]! - b2.position[k]! : 0;
    const previousStep = b2 && b3 ? scale(b2.position[k]! - b3.position[k]!, t.dt2, t.dt3) : d;
    position[k] = Math.min(INT32_MAX, Math.max(INT32_MIN, b1.position[k]! + scale(d, t.dt1, t.dt2)));
    positionStep[k] = d;
    positionAcceleration[k] = d - previousStep;
    positionChange += Math.abs(d - previousStep);
  }

  const n = 2 * m * m;
  unpack(b1, n, q1);
  for (let k = 0; k < 4; k++) {
    q[k] = q1[k]!;
    step[k] = 0;
    change[k] = 0;
  }
  if (b2 && !(sameRotation(b1, b2) && (!b3 || sameRotation(b2, b3)))) {
    alignSign(unpack(b2, n, q2), q1);
    let step2 = 0;
    for (let k = 0; k < 4; k++) {
      step[k] = q1[k]! - q2[k]!;
      step2 += step[k]! * step[k]!;
    }
    if (b3) {
      alignSign(unpack(b3, n, q3), q2);
      for (let k = 0; k < 4; k++) change[k] = step[k]! - scale(q2[k]! - q3[k]!, t.dt2, t.dt3);
    }
    if (step2 <= Math.trunc(n / 2)) {
      const acceleration =
        t.dt1 === t.dt2 ? step2 : div(step2 * t.dt1 * (t.dt1 + t.dt2), 2 * t.dt2 * t.dt2);
      const curved = acceleration * m >= Math.trunc(n / 4);
      for (let k = 0; k < 4; k++)
        q[k] = q1[k]! + scale(step[k]!, t.dt1, t.dt2) - (curved ? div(q1[k]! * acceleration, n) : 0);
    } else {
      step.fill(0); // too large to extrapolate: treated as no rotation
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
