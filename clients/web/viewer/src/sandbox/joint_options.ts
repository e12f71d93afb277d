// The joints that the joint tool creates.

import type { Input } from '@jostle/client';
import * as THREE from 'three';

type CreateJoint = Extract<NonNullable<Input['kind']>, { case: 'createJoint' }>['value'];

export const JOINT_KINDS = {
  ball: { label: 'Ball', hint: 'Rotates in all directions about the second point' },
  hinge: { label: 'Hinge', hint: 'Rotates about the normal of the surface at the second point' },
  slider: { label: 'Slider', hint: 'Slides along the line between the two points' },
  fixed: { label: 'Weld', hint: 'Keeps the two bodies together' },
  rod: { label: 'Rod', hint: 'Keeps the distance of the two points' },
  rope: { label: 'Rope', hint: 'Limits the distance of the two points' },
  spring: { label: 'Spring', hint: 'Pulls the two points to their distance' },
} as const;
export type JointKind = keyof typeof JOINT_KINDS;

export interface JointOptions {
  kind: JointKind;
  /** rad/s of a hinge or m/s of a slider; 0: no motor. */
  motorSpeed: number;
  /** N m of a hinge or N of a slider. */
  motorMax: number;
  /** Hz, of a spring. */
  frequency: number;
  /** N; 0: unbreakable. */
  breakForce: number;
}

export const defaultJointOptions = (): JointOptions => ({ kind: 'ball', motorSpeed: 0, motorMax: 500, frequency: 2, breakForce: 0 });

/** An end of a new joint: a point of a body in its pose, or of the world. */
export interface JointEnd {
  readonly entity: number; // 0: the world
  readonly point: THREE.Vector3; // in the world, m
  readonly normal: THREE.Vector3; // of the surface; zero: none
  /** px py pz qx qy qz qw; undefined: the world. */
  readonly pose: ArrayLike<number> | undefined;
}

const xyz = ({ x, y, z }: THREE.Vector3) => ({ x, y, z });
const xyzw = ({ x, y, z, w }: THREE.Quaternion) => ({ x, y, z, w });

function inBody({ point, pose }: JointEnd): THREE.Vector3 {
  if (!pose) return point.clone();
  const turnBack = new THREE.Quaternion(pose[3]!, pose[4]!, pose[5]!, pose[6]!).normalize().conjugate();
  return point.clone().sub(new THREE.Vector3(pose[0]!, pose[1]!, pose[2]!)).applyQuaternion(turnBack);
}

/** The rotation of a frame whose z axis points along `axis`. */
function frameAlong(axis: THREE.Vector3): THREE.Quaternion {
  const unit = axis.lengthSq() > 1e-12 ? axis.clone().normalize() : new THREE.Vector3(0, 1, 0);
  return new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), unit);
}

/**
 * The input that joins two ends. The world becomes the first body. Undefined: both ends are in the same body
 * or in the world.
 */
export function createJointInput(first: JointEnd, second: JointEnd, options: JointOptions, planar = false): CreateJoint | undefined {
  if (first.entity === second.entity) return undefined;
  const [a, b] = second.entity === 0 ? [second, first] : [first, second];
  const along = second.point.clone().sub(first.point);
  const length = along.length();
  const motor = options.motorSpeed === 0 ? undefined : options.motorSpeed;
  const frameAt = (axis: THREE.Vector3) => ({ frame: { position: xyz(second.point), rotation: xyzw(frameAlong(axis)) } });
  const ends = { frameA: { position: xyz(inBody(a)) }, frameB: { position: xyz(inBody(b)) } };
  const axisOfHinge = planar ? new THREE.Vector3(0, 0, 1) : second.normal;
  const joint = {
    ball: () => ({ ...frameAt(new THREE.Vector3(0, 0, 1)), kind: { case: 'ball', value: {} } }) as const,
    hinge: () =>
      ({
        ...frameAt(axisOfHinge),
        kind: { case: 'hinge', value: { ...(motor === undefined ? {} : { motorSpeed: motor, motorMaxTorque: options.motorMax }) } },
      }) as const,
    slider: () =>
      ({
        ...frameAt(along),
        kind: { case: 'slider', value: { ...(motor === undefined ? {} : { motorSpeed: motor, motorMaxForce: options.motorMax }) } },
      }) as const,
    fixed: () => ({ ...frameAt(new THREE.Vector3(0, 0, 1)), kind: { case: 'fixed', value: {} } }) as const,
    rod: () => ({ ...ends, kind: { case: 'distance', value: { minLength: length, maxLength: length } } }) as const,
    rope: () => ({ ...ends, kind: { case: 'distance', value: { minLength: 0, maxLength: length } } }) as const,
    spring: () =>
      ({
        ...ends,
        kind: {
          case: 'distance',
          value: { minLength: 0, maxLength: Math.max(10, 4 * length), restLength: length, spring: { hertz: options.frequency, dampingRatio: 0.2 } },
        },
      }) as const,
  }[options.kind]();
  return { entityA: a.entity, entityB: b.entity, joint: { ...joint, collideConnected: options.kind === 'rope' || options.kind === 'spring', breakForce: options.breakForce } };
}
