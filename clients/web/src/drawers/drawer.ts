// What draws a chunk: given its bytes, which are foreign, and where to draw. Called once a picture; draws nothing of bytes that it
// cannot read, and never throws.

import type { BlastMarks } from '../blast_marks';
import type { Entity } from '../gen/jostle/v1/play_pb';
import type { Solids } from '../solids';
import type { VertexBuffer } from '../vertex_buffer';
import type { Water } from '../water';

export interface Drawing {
  readonly lines: VertexBuffer;
  readonly solids: Solids;
  readonly water: Water;
  readonly blasts: Pick<BlastMarks, 'add'>;
  /** How far the picture is past the tick that the bytes are of; mostly a little before it. */
  readonly seconds: number;
  readonly nowMs: number; // for what fades by itself
  /** What the camera looks at. */
  readonly around: { readonly x: number; readonly y: number; readonly z: number };
  /** Whether to show what is not to be seen, like wind. */
  readonly debug: boolean;
  /** Where an entity is in this picture: px py pz qx qy qz qw. */
  poseOf(entity: number): ArrayLike<number> | undefined;
  entityOf(entity: number): Entity | undefined;
}

/** How what a module has is driven. */
export interface Steering {
  /** Whom somebody may drive. */
  entities(bytes: Uint8Array): number[];
  readonly keys: string;
  /** `behind`: the camera turns after it. `free`: it goes where the camera looks. */
  readonly camera: 'behind' | 'free';
  readonly distance: number; // m of the camera
  /** What the driver wants to know, like how fast. */
  words?(bytes: Uint8Array, entity: number): string;
}

export interface Drawer {
  draw?(bytes: Uint8Array, drawing: Drawing): void;
  readonly steering?: Steering;
  /** Colours for bodies that have none of their own. */
  dress?(bytes: Uint8Array, entities: ReadonlyMap<number, Entity>): Map<number, number>;
  /** What everybody wants to know, in one line. */
  words?(bytes: Uint8Array): string;
}

/** A body that a module made: no scene named it, no player spawned it. */
export function isOfModule({ name, owner }: Entity): boolean {
  return name === '' && owner === 0;
}
