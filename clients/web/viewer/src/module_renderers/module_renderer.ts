// What draws channels of one kind: given their numbers, which are foreign, and where to draw. Called once a picture; draws nothing of
// numbers that it cannot read, and never throws.

import type { BlastMarks } from '../scene/blast_marks';
import type { Entity } from '@jostle/client/gen/play_pb';
import type { Solids } from '../scene/solids';
import type { VertexBuffer } from '../scene/vertex_buffer';
import type { Water } from '../scene/water';

export interface RenderContext {
  readonly lines: VertexBuffer;
  readonly solids: Solids;
  readonly water: Water;
  readonly blasts: Pick<BlastMarks, 'add'>;
  readonly nowMs: number; // for what fades by itself
  /** What the camera looks at. */
  readonly around: { readonly x: number; readonly y: number; readonly z: number };
  /** Whether to show what is not to be seen, like wind. */
  readonly debug: boolean;
  /** Where an entity is in this picture: px py pz qx qy qz qw. */
  poseOf(entity: number): ArrayLike<number> | undefined;
  entityOf(entity: number): Entity | undefined;
}

/** One channel of a kind. */
export interface ChannelData {
  readonly entity: number; // 0: the module itself
  readonly values: Int32Array;
  readonly seconds: number; // since the tick in which the server told it, at the moment that is shown; may be a little before it
}

/** How entities of which the kind tells are driven. */
export interface Steering {
  readonly keys: string;
  /** `behind`: the camera turns after it. `free`: it goes where the camera looks. */
  readonly camera: 'behind' | 'free';
  readonly distance: number; // m of the camera
  /** What the driver wants to know, like how fast. */
  statusText?(data: ChannelData): string;
}

/** Of one kind: `told` is all of it in the frame that is shown. */
export interface ModuleRenderer {
  draw?(data: readonly ChannelData[], context: RenderContext): void;
  readonly steering?: Steering;
  /** Colours for bodies that have none of their own. */
  bodyColors?(data: readonly ChannelData[], entities: ReadonlyMap<number, Entity>): Map<number, number>;
  /** What everybody wants to know, in one line. */
  statusText?(data: readonly ChannelData[]): string;
}

/** A body that a module made: no scene named it, no player spawned it. */
export function isOfModule({ name, owner }: Entity): boolean {
  return name === '' && owner === 0;
}
