// The joint tool: the first click chooses one end, the second one the other end and creates the joint.

import type { Input } from '@jostle/client';
import * as THREE from 'three';
import type { Pick } from '../interaction/pick';
import { createJointInput, JOINT_KINDS, type JointEnd, type JointOptions } from './joint_options';

export interface JointToolOptions {
  readonly options: JointOptions;
  poseOf(entity: number): ArrayLike<number> | undefined;
  isDynamic(entity: number): boolean;
  nameOf(entity: number): string;
  isPlanar(): boolean;
  send(kind: NonNullable<Input['kind']>): void;
  /** What the user does next; empty: the tool is not selected. */
  onHint(text: string): void;
}

/** The first end: a point in the frame of its body. */
interface FirstEnd {
  readonly entity: number; // 0: the world
  readonly local: THREE.Vector3;
  readonly normal: THREE.Vector3; // in the body
}

export class JointTool {
  private first: FirstEnd | undefined;
  private selected = false;

  constructor(private readonly tool: JointToolOptions) {}

  /** Where the first end is now; undefined: none is chosen, or its body is gone. */
  get start(): THREE.Vector3 | undefined {
    return this.first && this.endOf(this.first)?.point;
  }

  setSelected(selected: boolean): void {
    this.selected = selected;
    this.cancel();
  }

  /** Returns whether an end was chosen. */
  cancel(): boolean {
    const chosen = this.first !== undefined;
    this.first = undefined;
    this.updateHint();
    return chosen;
  }

  updateHint(): void {
    const { label, hint } = JOINT_KINDS[this.tool.options.kind];
    if (!this.selected) this.tool.onHint('');
    else if (this.first) this.tool.onHint(`${label} from ${this.name(this.first.entity)}: choose the second point`);
    else this.tool.onHint(`${label}: choose the first point. ${hint}`);
  }

  click(hit: Pick): void {
    // Static bodies do not move, so a joint to one is a joint to the world.
    const entity = this.tool.isDynamic(hit.entity) ? hit.entity : 0;
    const end: JointEnd = { entity, point: hit.point, normal: hit.normal, pose: entity === 0 ? undefined : this.tool.poseOf(entity) };
    const first = this.first && this.endOf(this.first);
    if (!first) {
      this.first = { entity, local: toBody(hit.point, end.pose), normal: hit.normal };
      return this.updateHint();
    }
    const value = createJointInput(first, end, this.tool.options, this.tool.isPlanar());
    if (!value) return this.tool.onHint(`Choose a point of a body other than ${this.name(entity)}`);
    this.tool.send({ case: 'createJoint', value });
    this.cancel();
  }

  private name(entity: number): string {
    return entity === 0 ? 'the world' : this.tool.nameOf(entity);
  }

  private endOf({ entity, local, normal }: FirstEnd): JointEnd | undefined {
    if (entity === 0) return { entity, point: local.clone(), normal, pose: undefined };
    const pose = this.tool.poseOf(entity);
    if (!pose) return undefined;
    const turn = new THREE.Quaternion(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
    const point = local.clone().applyQuaternion(turn).add(new THREE.Vector3(pose[0]!, pose[1]!, pose[2]!));
    return { entity, point, normal, pose };
  }
}

function toBody(point: THREE.Vector3, pose: ArrayLike<number> | undefined): THREE.Vector3 {
  if (!pose) return point.clone();
  const turnBack = new THREE.Quaternion(pose[3]!, pose[4]!, pose[5]!, pose[6]!).conjugate();
  return point.clone().sub(new THREE.Vector3(pose[0]!, pose[1]!, pose[2]!)).applyQuaternion(turnBack);
}
