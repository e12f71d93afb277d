// Marks of the selection: the bounding box of the body, the anchor of the joint, and the contact forces and
// the joint force as arrows.

import type { ListedJoint } from '@jostle/client';
import type { InspectResponse } from '@jostle/client/gen/query_pb';
import * as THREE from 'three';
import { VertexBuffer } from '../scene/vertex_buffer';
import { anchorOf } from './pick_joint';
import type { Selected } from './selection';

const OUTLINE = new THREE.Color(0xffd166);
const FORCE = new THREE.Color(0xff6b5e);
const JOINT = new THREE.Color(0x6fd08c);
const START = new THREE.Color(0xffd166);
const MARGIN = 0.02; // m, around the box
const ARROW = { min: 0.15, max: 2.5, scale: 0.035 }; // m, m, m / sqrt(N)
const HEAD = 0.22; // share of the length

export interface SelectedBodies {
  poseOf(entity: number): ArrayLike<number> | undefined;
  boxOf(entity: number): THREE.Box3;
}

const along = new THREE.Vector3();
const side = new THREE.Vector3();
const tip = new THREE.Vector3();

/** Length in m of the arrow of a force in N. */
export function arrowLength(force: number): number {
  return Math.min(ARROW.max, ARROW.min + ARROW.scale * Math.sqrt(Math.max(0, force)));
}

export class SelectionView {
  readonly lines = VertexBuffer.lines(1);
  readonly points = VertexBuffer.points(11);
  private inspected: InspectResponse | undefined;

  constructor(scene: THREE.Scene) {
    scene.add(this.lines.object, this.points.object);
  }

  setInspected(response: InspectResponse | undefined): void {
    this.inspected = response;
  }

  /** Call once per rendered frame. `start`: the first end of a joint that is being created. */
  update(
    selected: Selected | undefined,
    bodies: SelectedBodies,
    joints: ReadonlyMap<number, ListedJoint>,
    hz: number,
    start: THREE.Vector3 | undefined,
  ): void {
    this.lines.begin();
    this.points.begin();
    if (selected?.kind === 'body') this.drawBody(selected.id, bodies, hz);
    else if (selected) this.drawJoint(joints.get(selected.id), bodies);
    if (start) this.points.vertex(start.x, start.y, start.z, START);
    this.lines.end();
    this.points.end();
  }

  private drawBody(id: number, bodies: SelectedBodies, hz: number): void {
    const box = bodies.boxOf(id);
    if (!box.isEmpty()) this.drawBox(box.expandByScalar(MARGIN));
    const body = this.inspected?.body;
    if (body?.entity !== id) return;
    for (const { normal, points } of body.contacts)
      for (const { point, impulse } of points) {
        if (!point || !normal || impulse <= 0) continue;
        // The force on this body points away from the other one.
        this.drawArrow(point, -normal.x, -normal.y, -normal.z, impulse * hz);
      }
  }

  private drawJoint(joint: ListedJoint | undefined, bodies: SelectedBodies): void {
    const at = joint && anchorOf(joint, (entity) => bodies.poseOf(entity));
    if (!joint || !at) return;
    this.points.vertex(at.x, at.y, at.z, JOINT);
    for (const entity of [joint.entityA, joint.entityB]) {
      const pose = bodies.poseOf(entity);
      if (!pose) continue;
      this.lines.vertex(at.x, at.y, at.z, JOINT);
      this.lines.vertex(pose[0]!, pose[1]!, pose[2]!, JOINT);
    }
  }

  private drawArrow(from: { x: number; y: number; z: number }, x: number, y: number, z: number, force: number): void {
    const length = arrowLength(force);
    along.set(x, y, z);
    tip.set(from.x, from.y, from.z).addScaledVector(along, length);
    this.points.vertex(from.x, from.y, from.z, FORCE);
    this.lines.vertex(from.x, from.y, from.z, FORCE);
    this.lines.vertex(tip.x, tip.y, tip.z, FORCE);
    for (const axis of [Math.abs(x) < 0.8 ? side.set(1, 0, 0) : side.set(0, 1, 0)]) {
      axis.cross(along).normalize();
      for (const sign of [-1, 1]) {
        this.lines.vertex(tip.x, tip.y, tip.z, FORCE);
        this.lines.vertex(
          tip.x - HEAD * length * (along.x - sign * 0.5 * axis.x),
          tip.y - HEAD * length * (along.y - sign * 0.5 * axis.y),
          tip.z - HEAD * length * (along.z - sign * 0.5 * axis.z),
          FORCE,
        );
      }
    }
  }

  private drawBox({ min, max }: THREE.Box3): void {
    const corner = (k: number) => this.lines.vertex(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z, OUTLINE);
    for (const axis of [1, 2, 4])
      for (let k = 0; k < 8; k++) {
        if (k & axis) continue;
        corner(k);
        corner(k | axis);
      }
  }
}
