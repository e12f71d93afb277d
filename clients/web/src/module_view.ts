// Draws what modules tell. Only kinds that have a drawer are asked for.

import type * as THREE from 'three';
import type { Channels } from './channels';
import type { Drawer, Drawing } from './drawers/drawer';
import { drawHovercraft } from './drawers/hovercraft';
import { drawVehicle } from './drawers/vehicle';
import { VertexBuffer } from './vertex_buffer';

/** By kind: a new one is a file in drawers/ and a line here. */
const DRAWERS: ReadonlyMap<string, Drawer> = new Map([
  ['hovercraft', drawHovercraft],
  ['vehicle', drawVehicle],
]);

/** What is shown of what modules tell. */
export interface Shown {
  readonly frame: number;
  readonly channels: Channels;
  readonly later: number; // s, from that frame to the moment that is shown
  readonly kinds: readonly { name: string; divisor: number }[];
  readonly tickHz: number;
}

/** Kinds that can be drawn. */
export const DRAWN_KINDS: readonly string[] = [...DRAWERS.keys()];

export class ModuleView {
  readonly lines = VertexBuffer.lines(0.9);

  constructor(
    scene: THREE.Scene,
    private readonly drawers = DRAWERS,
  ) {
    scene.add(this.lines.object);
  }

  /** Once a picture, after the bodies were put where they are. */
  update(shown: Shown, poseOf: Drawing['poseOf']): void {
    if (shown.channels.length === 0 && this.lines.count === 0) return;
    this.lines.begin();
    const drawing: Drawing = { lines: this.lines, poseOf };
    for (const { kind, entity, values } of shown.channels) {
      const { name, divisor } = shown.kinds[kind] ?? { name: '', divisor: 1 };
      // A kind is told in tick 1 and every `divisor` ticks from there.
      const ticks = (shown.frame - 1) % Math.max(divisor, 1);
      this.drawers.get(name)?.({ entity, values, seconds: ticks / shown.tickHz + shown.later }, drawing);
    }
    this.lines.end();
  }
}
