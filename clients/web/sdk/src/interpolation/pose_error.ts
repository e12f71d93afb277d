// What was shown wrongly, and how it is made good: the difference between a pose that was shown and the one that is right stays at
// first, so that nothing jumps, and is then walked off. Its half-life is 0.1 s, and it moves at most at 1.1 m/s (18 mm a picture at
// 60 a second) and 1.5 rad/s, or at 0.35 of the speed of its body where that is more. What would take more than 3 s at that speed
// is not walked: the body jumps. The C++ client library has the same (jostle/client/pose_error.h).

/** Where something is and how it is turned: px py pz qx qy qz qw, as in FrameBuffer. */
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

const correctionSpeed = (pace: BodySpeed) => Math.max(CORRECTION_SPEED_MIN, CORRECTION_SPEED_RATIO * pace.speed);
const correctionSpin = (pace: BodySpeed) => Math.max(CORRECTION_SPIN_MIN, CORRECTION_SPEED_RATIO * pace.spin);
const remainingError = (error: number, most: number, seconds: number) =>
  Math.max(error * 2 ** (-seconds / HALF_LIFE_S), error - most * seconds);

/** out = a * b, of quaternions that begin at the third number of a pose. */
function multiply(a: Pose, b: Pose, out: Pose): void {
  const [ax, ay, az, aw] = [a[3]!, a[4]!, a[5]!, a[6]!];
  const [bx, by, bz, bw] = [b[3]!, b[4]!, b[5]!, b[6]!];
  out[3] = aw * bx + ax * bw + ay * bz - az * by;
  out[4] = aw * by + ay * bw + az * bx - ax * bz;
  out[5] = aw * bz + az * bw + ax * by - ay * bx;
  out[6] = aw * bw - ax * bx - ay * by - az * bz;
}

/** Shown less right: a translation and the rotation from right to shown; undefined where there is none or too much to walk. */
export function poseError(shown: Pose, right: Pose, pace: BodySpeed): Pose | undefined {
  const error = new Float64Array(7);
  for (let k = 0; k < 3; k++) error[k] = shown[k]! - right[k]!;
  if (Math.hypot(error[0]!, error[1]!, error[2]!) > CORRECTION_TIME_MAX_S * correctionSpeed(pace)) return undefined;
  const back = Float64Array.of(0, 0, 0, -right[3]!, -right[4]!, -right[5]!, right[6]!);
  multiply(shown, back, error);
  if (error[6]! < 0) for (let k = 3; k < 7; k++) error[k] = -error[k]!; // the shorter way
  return error;
}

/** Puts it onto what is right. */
export function addError(pose: Pose, error: Pose): void {
  for (let k = 0; k < 3; k++) pose[k] = pose[k]! + error[k]!;
  multiply(error, pose, pose);
  const scale = 1 / Math.hypot(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
  for (let k = 3; k < 7; k++) pose[k] = pose[k]! * scale;
}

/** What is left of it after so many seconds; false: nothing. */
export function decay(error: Pose, pace: BodySpeed, seconds: number): boolean {
  const distance = Math.hypot(error[0]!, error[1]!, error[2]!);
  const still = remainingError(distance, correctionSpeed(pace), seconds);
  const share = still > NEGLIGIBLE ? still / distance : 0;
  for (let k = 0; k < 3; k++) error[k] = error[k]! * share;
  const sine = Math.hypot(error[3]!, error[4]!, error[5]!);
  const angle = remainingError(2 * Math.atan2(sine, error[6]!), correctionSpin(pace), seconds);
  const turn = angle > NEGLIGIBLE && sine > 0 ? Math.sin(angle / 2) / sine : 0;
  for (let k = 3; k < 6; k++) error[k] = error[k]! * turn;
  error[6] = turn > 0 ? Math.cos(angle / 2) : 1;
  return share > 0 || turn > 0;
}
