// Smooths errors of rendered poses. The difference between the rendered and the correct pose is applied
// at first, so that nothing jumps, and then decays: half-life 0.1 s, at most 1.1 m/s (18 mm per frame
// at 60 Hz) and 1.5 rad/s, or 0.35 of the body's speed if that is more. An error that would take more
// than 3 s is not smoothed: the body jumps. Same algorithm as jostle/client/pose_error.h of the C++
// client library.

/** px py pz qx qy qz qw, as in FrameBuffer. */
export type Pose = Float64Array;

/** Of a body: m/s, rad/s. */
export interface BodySpeed {
  readonly speed: number;
  readonly spin: number;
}

const HALF_LIFE_S = 0.1;
const CORRECTION_TIME_MAX_S = 3;
const CORRECTION_SPEED_MIN = 1.1;
const CORRECTION_SPIN_MIN = 1.5;
const CORRECTION_SPEED_RATIO = 0.35;
const NEGLIGIBLE = 1e-5; // m, rad

const correctionSpeed = (bodySpeed: BodySpeed) => Math.max(CORRECTION_SPEED_MIN, CORRECTION_SPEED_RATIO * bodySpeed.speed);
const correctionSpin = (bodySpeed: BodySpeed) => Math.max(CORRECTION_SPIN_MIN, CORRECTION_SPEED_RATIO * bodySpeed.spin);
const remainingError = (error: number, most: number, seconds: number) =>
  Math.max(error * 2 ** (-seconds / HALF_LIFE_S), error - most * seconds);

/** out = a * b, for the quaternions from index 3 of the poses. */
function multiply(a: Pose, b: Pose, out: Pose): void {
  const [ax, ay, az, aw] = [a[3]!, a[4]!, a[5]!, a[6]!];
  const [bx, by, bz, bw] = [b[3]!, b[4]!, b[5]!, b[6]!];
  out[3] = aw * bx + ax * bw + ay * bz - az * by;
  out[4] = aw * by + ay * bw + az * bx - ax * bz;
  out[5] = aw * bz + az * bw + ax * by - ay * bx;
  out[6] = aw * bw - ax * bx - ay * by - az * bz;
}

/**
 * Rendered minus target: a translation, and the rotation from target to rendered; undefined if too
 * large to smooth.
 */
export function poseError(rendered: Pose, target: Pose, bodySpeed: BodySpeed): Pose | undefined {
  const error = new Float64Array(7);
  for (let k = 0; k < 3; k++) error[k] = rendered[k]! - target[k]!;
  if (Math.hypot(error[0]!, error[1]!, error[2]!) > CORRECTION_TIME_MAX_S * correctionSpeed(bodySpeed)) return undefined;
  const inverseTarget = Float64Array.of(0, 0, 0, -target[3]!, -target[4]!, -target[5]!, target[6]!);
  multiply(rendered, inverseTarget, error);
  if (error[6]! < 0) for (let k = 3; k < 7; k++) error[k] = -error[k]!; // the shorter rotation
  return error;
}

/** Adds the error to a pose. */
export function addError(pose: Pose, error: Pose): void {
  for (let k = 0; k < 3; k++) pose[k] = pose[k]! + error[k]!;
  multiply(error, pose, pose);
  const scale = 1 / Math.hypot(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
  for (let k = 3; k < 7; k++) pose[k] = pose[k]! * scale;
}

/** Decays the error by `seconds`; returns false when it has vanished. */
export function decay(error: Pose, bodySpeed: BodySpeed, seconds: number): boolean {
  const distance = Math.hypot(error[0]!, error[1]!, error[2]!);
  const remaining = remainingError(distance, correctionSpeed(bodySpeed), seconds);
  const fraction = remaining > NEGLIGIBLE ? remaining / distance : 0;
  for (let k = 0; k < 3; k++) error[k] = error[k]! * fraction;
  const sine = Math.hypot(error[3]!, error[4]!, error[5]!);
  const angle = remainingError(2 * Math.atan2(sine, error[6]!), correctionSpin(bodySpeed), seconds);
  const factor = angle > NEGLIGIBLE && sine > 0 ? Math.sin(angle / 2) / sine : 0;
  for (let k = 3; k < 6; k++) error[k] = error[k]! * factor;
  error[6] = factor > 0 ? Math.cos(angle / 2) : 1;
  return fraction > 0 || factor > 0;
}
