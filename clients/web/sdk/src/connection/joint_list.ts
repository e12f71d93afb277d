// The joints of a world as received by one client (proto JointUpdate). The C++ implementation is
// clients/cpp/core/src/joint_list.cpp.

import type { JointUpdate } from '../gen/jostle/v1/play_pb.js';
import type { Joint } from '../gen/jostle/v1/scene_pb.js';

/** Maximum number of joints of a world. */
export const JOINTS_MAX = 1 << 20;

/** A joint between two entities. */
export interface ListedJoint {
  readonly id: number;
  /** 0: the world. */
  readonly entityA: number;
  readonly entityB: number;
  /** Frames and kind; parameters as of the creation of the joint. Shared by equal joints. Its numbers are untrusted. */
  readonly form: Joint;
}

export class JointList {
  readonly joints = new Map<number, ListedJoint>();

  /** Starts a stream whose first update is complete. */
  clear(): void {
    this.joints.clear();
  }

  /** Applies an update. Returns the reason and changes nothing if the update is malformed. */
  apply({ complete, removed, added, forms }: JointUpdate): string | undefined {
    const before = complete ? 0 : this.joints.size;
    if (before + added.length > JOINTS_MAX) return `${before + added.length} joints; at most ${JOINTS_MAX} are allowed`;
    for (const { id, entityA, entityB, form } of added) {
      if (id === 0) return 'joint 0: the id must not be 0';
      if (entityB === 0) return `joint ${id}: entity_b must not be 0`;
      if (entityA === entityB) return `joint ${id}: entity_a and entity_b are both ${entityB}`;
      if (form >= forms.length) return `joint ${id}: form ${form} does not exist; there are ${forms.length}`;
    }
    if (complete) this.joints.clear();
    for (const id of removed) this.joints.delete(id);
    for (const { id, entityA, entityB, form } of added) this.joints.set(id, { id, entityA, entityB, form: forms[form]! });
    return undefined;
  }
}
