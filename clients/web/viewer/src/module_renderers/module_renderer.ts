// Interface of module renderers. A renderer draws the channels of one kind once per rendered frame.
// Channel values are untrusted: a renderer ignores values that it cannot decode, and never throws.

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
  readonly nowMs: number; // for animations
  /** Target of the camera. */
  readonly cameraTarget: { readonly x: number; readonly y: number; readonly z: number };
  /** Whether to show invisible effects such as wind. */
  readonly debug: boolean;
  /** Pose of an entity in this rendered frame: px py pz qx qy qz qw. */
  poseOf(entity: number): ArrayLike<number> | undefined;
  entityOf(entity: number): Entity | undefined;
}

/** One channel of a kind. */
export interface ChannelData {
  readonly entity: number; // 0: the module itself
  readonly values: Int32Array;
  readonly seconds: number; // from the tick of the data to the rendered time; may be slightly negative
}

/** How entities with this kind of channel are controlled. */
export interface Steering {
  readonly keys: string;
  /** Labels of the buttons by their bits, for on-screen controls; empty: the bit has no effect. */
  readonly buttons: readonly string[];
  /** `behind`: the camera turns with the entity. `free`: the entity moves relative to the camera. */
  readonly camera: 'behind' | 'free';
  readonly distance: number; // m, of the camera
  /** Status for the user who controls the entity, such as its speed. */
  statusText?(data: ChannelData): string;
}

/** Renderer of one kind; `data` has all channels of the kind in the rendered frame. */
export interface ModuleRenderer {
  draw?(data: readonly ChannelData[], context: RenderContext): void;
  readonly steering?: Steering;
  /** Colors of bodies that have no color of their own. */
  bodyColors?(data: readonly ChannelData[], entities: ReadonlyMap<number, Entity>): Map<number, number>;
  /** Status for all users, in one line. */
  statusText?(data: readonly ChannelData[]): string;
}

/** Whether a module created the body: it has neither a scene name nor an owner. */
export function isOfModule({ name, owner }: Entity): boolean {
  return name === '' && owner === 0;
}
