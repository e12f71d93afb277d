// What a joint looks like: for each kind a list of solids between its two frames. The frames are
// untrusted numbers; a joint with a number that is not finite has no shape.

import * as THREE from 'three';
import type { ListedJoint } from '@jostle/client';
import type { Joint, JointFrame } from '@jostle/client/gen/scene_pb';

/** Solids of unit size: radius 1, half length 1 along y. A ring has the radius 1 about y. A coil has 8 turns. */
export type JointPart = 'ball' | 'rod' | 'ring' | 'coil' | 'plate';

/** Colors by function. */
export type JointRole = 'metal' | 'pin' | 'motor' | 'spring' | 'rope' | 'rail';

/** Receives the solids of a joint. */
export interface JointSolids {
  add(part: JointPart, at: THREE.Vector3, turn: THREE.Quaternion, size: THREE.Vector3, role: JointRole): void;
}

/** The two frames of a joint in the world in this rendered frame. */
export interface JointEnds {
  readonly a: THREE.Vector3;
  readonly turnA: THREE.Quaternion;
  readonly b: THREE.Vector3;
  readonly turnB: THREE.Quaternion;
  readonly radius: number; // m, of the smaller body
  readonly ofWorld: boolean; // a is a frame of the world
}

/** A frame in a body; undefined: a number is not finite. */
export function readFrame(frame: JointFrame | undefined): { position: THREE.Vector3; turn: THREE.Quaternion } | undefined {
  const { x = 0, y = 0, z = 0 } = frame?.position ?? {};
  const rotation = frame?.rotation;
  const turn = rotation ? new THREE.Quaternion(rotation.x, rotation.y, rotation.z, rotation.w) : new THREE.Quaternion();
  if (![x, y, z, turn.x, turn.y, turn.z, turn.w].every(Number.isFinite) || turn.lengthSq() < 1e-6) return undefined;
  return { position: new THREE.Vector3(x, y, z), turn: turn.normalize() };
}

const UP = new THREE.Vector3(0, 1, 0);
const AXIS_Z = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(1, 0, 0), Math.PI / 2); // turns y to z
const PATH_POINTS_MAX = 1024;
const PATH_PARTS = 8; // of a smooth segment
const SAG = 0.55; // depth of a slack rope relative to its slack

const size = new THREE.Vector3();
const turn = new THREE.Quaternion();
const middle = new THREE.Vector3();
const along = new THREE.Vector3();

/** Adds a rod or a coil from one point to another. */
function between(out: JointSolids, part: 'rod' | 'coil', from: THREE.Vector3, to: THREE.Vector3, radius: number, role: JointRole): void {
  along.copy(to).sub(from);
  const length = along.length();
  if (!(length > 1e-4) || !(length < 1e5)) return;
  turn.setFromUnitVectors(UP, along.divideScalar(length));
  out.add(part, middle.copy(from).lerp(to, 0.5), turn, size.set(radius, length / 2, radius), role);
}

function ball(out: JointSolids, at: THREE.Vector3, radius: number, role: JointRole): void {
  out.add('ball', at, turn.identity(), size.setScalar(radius), role);
}

/** A pin along the z axis of a frame, which sticks out of the bodies. */
function axle(out: JointSolids, at: THREE.Vector3, frame: THREE.Quaternion, radius: number, halfLength: number, role: JointRole): void {
  out.add('rod', at, turn.copy(frame).multiply(AXIS_Z), size.set(radius, halfLength, radius), role);
}

function ring(out: JointSolids, at: THREE.Vector3, frame: THREE.Quaternion, radius: number, role: JointRole): void {
  out.add('ring', at, turn.copy(frame).multiply(AXIS_Z), size.setScalar(radius), role);
}

/** A rope of `length` m, which sags while it is slack. */
function rope(out: JointSolids, from: THREE.Vector3, to: THREE.Vector3, length: number, radius: number): void {
  const slack = Math.max(0, length - from.distanceTo(to));
  if (slack < 0.02 * length) return between(out, 'rod', from, to, radius, 'rope');
  const parts = 8;
  const depth = Math.min(length / 2, Math.sqrt(slack * length) * SAG);
  const at = (t: number) => from.clone().lerp(to, t).addScaledVector(UP, -4 * depth * t * (1 - t));
  for (let k = 0; k < parts; k++) between(out, 'rod', at(k / parts), at((k + 1) / parts), radius, 'rope');
}

/** Points of a path joint in the frame of a. */
function pathPoints({ points, smooth = true, closed }: Extract<Joint['kind'], { case: 'path' }>['value']): THREE.Vector3[] {
  const given = points.slice(0, PATH_POINTS_MAX).map(({ x, y, z }) => new THREE.Vector3(x, y, z));
  if (given.length < 2 || !given.every((p) => Number.isFinite(p.lengthSq()))) return [];
  if (!smooth) return closed ? [...given, given[0]!] : given;
  return new THREE.CatmullRomCurve3(given, closed, 'catmullrom').getPoints(PATH_PARTS * given.length);
}

/** Adds the solids of a joint between its ends. */
export function drawJoint({ form }: ListedJoint, ends: JointEnds, out: JointSolids): void {
  const { a, turnA, b, turnB, radius, ofWorld } = ends;
  const pin = Math.min(0.12, Math.max(0.012, 0.26 * radius));
  const long = 1.25 * radius + pin;
  if (ofWorld && form.kind.case !== 'path' && form.kind.case !== 'slider') out.add('plate', a, turn.copy(turnA), size.setScalar(1.7 * pin), 'metal');
  switch (form.kind.case) {
    case 'ball':
    case 'coneTwist':
      ball(out, b, 1.25 * pin, form.kind.value.drive ? 'motor' : 'pin');
      break;
    case 'hinge': {
      const { motorSpeed, spring } = form.kind.value;
      axle(out, b, turnA, 0.7 * pin, long, 'pin');
      if (motorSpeed !== undefined) ring(out, b, turnA, 2.2 * pin, 'motor');
      else if (spring && spring.hertz > 0) ring(out, b, turnA, 2 * pin, 'spring');
      break;
    }
    case 'wheel': {
      const { motorSpeed } = form.kind.value;
      axle(out, b, turnB, 0.8 * pin, long, 'pin');
      between(out, 'coil', a, b, 1.3 * pin, 'spring');
      if (motorSpeed !== undefined) ring(out, b, turnB, 2 * pin, 'motor');
      break;
    }
    case 'fixed':
      out.add('plate', b, turn.copy(turnB), size.setScalar(1.1 * pin), form.kind.value.linear || form.kind.value.angular ? 'spring' : 'metal');
      break;
    case 'distance': {
      const { minLength, maxLength, spring } = form.kind.value;
      ball(out, a, 0.8 * pin, 'metal');
      ball(out, b, 0.8 * pin, 'metal');
      if (spring && spring.hertz > 0) between(out, 'coil', a, b, 1.6 * pin, 'spring');
      else if (minLength < maxLength) rope(out, a, b, maxLength, 0.35 * pin);
      else between(out, 'rod', a, b, 0.5 * pin, 'metal');
      break;
    }
    case 'slider': {
      const { limit, motorSpeed, spring } = form.kind.value;
      const axis = new THREE.Vector3(0, 0, 1).applyQuaternion(turnA);
      const [low, high] = limit ? [limit.lower, limit.upper] : [-3 * radius, 3 * radius];
      const from = a.clone().addScaledVector(axis, Math.max(-1e3, Math.min(low, b.clone().sub(a).dot(axis))));
      const to = a.clone().addScaledVector(axis, Math.min(1e3, Math.max(high, b.clone().sub(a).dot(axis))));
      between(out, 'rod', from, to, 0.5 * pin, 'rail');
      out.add('plate', b, turn.copy(turnA), size.setScalar(1.1 * pin), motorSpeed !== undefined ? 'motor' : 'metal');
      if (spring && spring.hertz > 0) between(out, 'coil', from, b, 1.3 * pin, 'spring');
      break;
    }
    case 'sixDof':
      ball(out, b, 1.1 * pin, 'pin');
      between(out, 'rod', a, b, 0.5 * pin, 'metal');
      break;
    case 'gear':
      between(out, 'rod', a, b, 0.3 * pin, 'motor');
      ring(out, a, turnA, 1.6 * pin, 'motor');
      ring(out, b, turnB, 1.6 * pin, 'motor');
      break;
    case 'rack':
      ring(out, a, turnA, 1.6 * pin, 'motor');
      axle(out, b, turnB, 0.6 * pin, long, 'rail');
      break;
    case 'pulley': {
      const { pointA, pointB } = form.kind.value;
      const overA = new THREE.Vector3(pointA?.x ?? 0, pointA?.y ?? 0, pointA?.z ?? 0);
      const overB = new THREE.Vector3(pointB?.x ?? 0, pointB?.y ?? 0, pointB?.z ?? 0);
      if (!Number.isFinite(overA.lengthSq() + overB.lengthSq())) break;
      ball(out, overA, 1.8 * pin, 'metal');
      ball(out, overB, 1.8 * pin, 'metal');
      between(out, 'rod', a, overA, 0.35 * pin, 'rope');
      between(out, 'rod', overA, overB, 0.35 * pin, 'rope');
      between(out, 'rod', overB, b, 0.35 * pin, 'rope');
      break;
    }
    case 'path': {
      const points = pathPoints(form.kind.value).map((point) => point.applyQuaternion(turnA).add(a));
      for (let k = 0; k + 1 < points.length; k++) between(out, 'rod', points[k]!, points[k + 1]!, 0.35 * pin, 'rail');
      ball(out, b, 1.1 * pin, form.kind.value.motorSpeed !== undefined ? 'motor' : 'pin');
      break;
    }
    default:
      break;
  }
}
