// What draws a chunk: given its bytes, which are foreign, and where to draw. Called once a picture; draws nothing of bytes that it
// cannot read, and never throws.

import type { VertexBuffer } from '../vertex_buffer';

export interface Drawing {
  readonly lines: VertexBuffer;
  /** Where an entity is in this picture: px py pz qx qy qz qw. */
  poseOf(entity: number): ArrayLike<number> | undefined;
}

export type Drawer = (bytes: Uint8Array, drawing: Drawing) => void;
