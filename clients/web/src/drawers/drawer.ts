// What draws a channel: given its numbers, which are foreign, and where to draw. Called once a picture; draws nothing of numbers that
// it cannot read, and never throws.

import type { VertexBuffer } from '../vertex_buffer';

export interface Drawing {
  readonly lines: VertexBuffer;
  /** Where an entity is in this picture: px py pz qx qy qz qw. */
  poseOf(entity: number): ArrayLike<number> | undefined;
}

/** One channel of a kind. */
export interface Told {
  readonly entity: number; // 0: the module itself
  readonly values: Int32Array;
  readonly seconds: number; // since the tick in which the server told it, at the moment that is shown
}

export type Drawer = (told: Told, drawing: Drawing) => void;

/** A float that came as the four bytes of a whole number. */
export function floatOf(value: number): number {
  bits.setInt32(0, value);
  return bits.getFloat32(0);
}
const bits = new DataView(new ArrayBuffer(4));
