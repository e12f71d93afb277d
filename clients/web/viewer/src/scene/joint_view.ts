// Joints as instanced solids. A joint is redrawn when one of its bodies moved.

import * as THREE from 'three';
import type { ListedJoint } from '@jostle/client';
import { Instances } from './instances';
import { drawJoint, readFrame, type JointPart, type JointRole, type JointSolids } from './joint_shapes';
import type { Kind } from './shape_parts';

const COLORS: Record<JointRole, THREE.Color> = {
  metal: new THREE.Color(0xb4bdc6),
  pin: new THREE.Color(0xd9dee4),
  motor: new THREE.Color(0xff9d3b),
  spring: new THREE.Color(0x6fd08c),
  rope: new THREE.Color(0xd2b07a),
  rail: new THREE.Color(0x8f9aa5),
};
const COIL_TURNS = 8;
const COIL_TURN_POINTS = 8;
const MOVED = 1e-5; // m or quaternion component

/** Coil of unit size: radius 1, from -1 to 1 along y. */
function coilCurve(): THREE.CatmullRomCurve3 {
  const points = COIL_TURNS * COIL_TURN_POINTS;
  const at = (k: number) => new THREE.Vector3(Math.cos((2 * Math.PI * k) / COIL_TURN_POINTS), (2 * k) / points - 1, Math.sin((2 * Math.PI * k) / COIL_TURN_POINTS));
  return new THREE.CatmullRomCurve3(Array.from({ length: points + 1 }, (_, k) => at(k)));
}

const GEOMETRIES: Record<JointPart, () => THREE.BufferGeometry> = {
  ball: () => new THREE.SphereGeometry(1, 14, 10),
  rod: () => new THREE.CylinderGeometry(1, 1, 2, 10),
  ring: () => new THREE.TorusGeometry(1, 0.24, 8, 20).rotateX(Math.PI / 2),
  coil: () => new THREE.TubeGeometry(coilCurve(), 128, 0.16, 5),
  plate: () => new THREE.BoxGeometry(2, 2, 2),
};
const KIND: Kind = 'cylinder'; // of instances, which only bodies use

interface Solid {
  readonly part: JointPart;
  readonly slot: number;
}

interface DrawnJoint {
  readonly joint: ListedJoint;
  readonly frameA: NonNullable<ReturnType<typeof readFrame>>;
  readonly frameB: NonNullable<ReturnType<typeof readFrame>>;
  readonly last: Float64Array; // poses of both bodies in the last drawing
  solids: Solid[];
}

/** What the view needs of the bodies. */
export interface JointedBodies {
  poseOf(entity: number): ArrayLike<number> | undefined;
  /** Mean radius of the smallest part, m. */
  radiusOf(entity: number): number | undefined;
}

const WORLD_POSE = [0, 0, 0, 0, 0, 0, 1];
const DEFAULT_RADIUS = 0.3; // m

export class JointView implements JointSolids {
  private readonly drawn = new Map<number, DrawnJoint>();
  private readonly instances = new Map<JointPart, Instances>();
  private readonly material = new THREE.MeshStandardMaterial({ roughness: 0.35 });
  private current: Solid[] = []; // slots of the joint that is being drawn
  private reusable: Solid[] = [];
  visible = true;

  private readonly matrix = new THREE.Matrix4();
  private readonly a = new THREE.Vector3();
  private readonly b = new THREE.Vector3();
  private readonly turnA = new THREE.Quaternion();
  private readonly turnB = new THREE.Quaternion();

  constructor(private readonly scene: THREE.Scene) {}

  /** Number of joints that are drawn. */
  get count(): number {
    return [...this.drawn.values()].filter(({ solids }) => solids.length > 0).length;
  }
  /** Number of solids of all joints. */
  get solidCount(): number {
    return [...this.instances.values()].reduce((sum, { size }) => sum + size, 0);
  }

  /** The list of joints changed. */
  setJoints(joints: ReadonlyMap<number, ListedJoint>): void {
    for (const [id, drawn] of this.drawn) {
      if (joints.get(id) === drawn.joint) continue;
      this.release(drawn.solids);
      this.drawn.delete(id);
    }
    for (const joint of joints.values()) {
      if (this.drawn.has(joint.id)) continue;
      const frameA = readFrame(joint.form.frameA);
      const frameB = readFrame(joint.form.frameB);
      if (frameA && frameB) this.drawn.set(joint.id, { joint, frameA, frameB, last: new Float64Array(14).fill(NaN), solids: [] });
    }
  }

  /** Call once per rendered frame, after the bodies were updated. */
  update(bodies: JointedBodies): void {
    for (const drawn of this.drawn.values()) {
      const { entityA, entityB } = drawn.joint;
      const poseA = entityA === 0 ? WORLD_POSE : bodies.poseOf(entityA);
      const poseB = bodies.poseOf(entityB);
      if (!this.visible || !poseA || !poseB) {
        this.release(drawn.solids);
        drawn.solids = [];
        drawn.last.fill(NaN);
      } else if (hasMoved(drawn.last, poseA, poseB)) this.draw(drawn, poseA, poseB, bodies);
    }
    for (const instances of this.instances.values()) instances.upload();
  }

  private draw(drawn: DrawnJoint, poseA: ArrayLike<number>, poseB: ArrayLike<number>, bodies: JointedBodies): void {
    const { joint, frameA, frameB } = drawn;
    place(this.a, this.turnA, frameA, poseA);
    place(this.b, this.turnB, frameB, poseB);
    const radii = [joint.entityA, joint.entityB].map((entity) => bodies.radiusOf(entity) ?? Infinity);
    const smallest = Math.min(...radii);
    const radius = smallest < Infinity ? smallest : DEFAULT_RADIUS;
    this.reusable = drawn.solids;
    this.current = [];
    const ends = { a: this.a, turnA: this.turnA, b: this.b, turnB: this.turnB, radius, ofWorld: joint.entityA === 0 };
    drawJoint(joint, ends, this);
    this.release(this.reusable);
    drawn.solids = this.current;
  }

  add(part: JointPart, at: THREE.Vector3, turn: THREE.Quaternion, size: THREE.Vector3, role: JointRole): void {
    const instances = this.instancesOf(part);
    const known = this.reusable.findIndex((solid) => solid.part === part);
    const solid = known >= 0 ? this.reusable.splice(known, 1)[0]! : { part, slot: instances.acquire(0) };
    instances.setMatrix(solid.slot, this.matrix.compose(at, turn, size));
    if (known < 0) instances.setColor(solid.slot, COLORS[role]);
    this.current.push(solid);
  }

  private release(solids: readonly Solid[]): void {
    for (const { part, slot } of solids) this.instancesOf(part).release(slot);
  }

  private instancesOf(part: JointPart): Instances {
    let instances = this.instances.get(part);
    if (!instances) this.instances.set(part, (instances = new Instances(this.scene, KIND, GEOMETRIES[part](), this.material, part !== 'plate')));
    return instances;
  }
}

function place(at: THREE.Vector3, turn: THREE.Quaternion, frame: DrawnJoint['frameA'], pose: ArrayLike<number>): void {
  turn.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
  at.copy(frame.position).applyQuaternion(turn);
  at.set(at.x + pose[0]!, at.y + pose[1]!, at.z + pose[2]!);
  turn.multiply(frame.turn);
}

function hasMoved(last: Float64Array, a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  let moved = false;
  for (let k = 0; k < 7; k++) {
    if (!(Math.abs(last[k]! - a[k]!) < MOVED)) moved = true;
    if (!(Math.abs(last[7 + k]! - b[k]!) < MOVED)) moved = true;
  }
  if (!moved) return false;
  for (let k = 0; k < 7; k++) {
    last[k] = a[k]!;
    last[7 + k] = b[k]!;
  }
  return true;
}
