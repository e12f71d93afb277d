// Draws what modules tell. A module whose tag has no drawer is not shown.

import type * as THREE from 'three';
import type { Drawer, Drawing } from './drawers/drawer';
import { drawHovercraft } from './drawers/hovercraft';
import { drawVehicles } from './drawers/vehicle';
import type { Chunks } from './module_chunks';
import { VertexBuffer } from './vertex_buffer';

/** By tag: a new kind is a file in drawers/ and a line here. */
const DRAWERS: ReadonlyMap<string, Drawer> = new Map([
  ['hovercraft', drawHovercraft],
  ['vehicle', drawVehicles],
]);

export class ModuleView {
  readonly lines = VertexBuffer.lines(0.9);

  constructor(
    scene: THREE.Scene,
    private readonly drawers = DRAWERS,
  ) {
    scene.add(this.lines.object);
  }

  /** Once a picture, after the bodies were put where they are. */
  update(chunks: Chunks, poseOf: Drawing['poseOf']): void {
    if (chunks.size === 0 && this.lines.count === 0) return;
    this.lines.begin();
    const drawing: Drawing = { lines: this.lines, poseOf };
    for (const [tag, bytes] of chunks) this.drawers.get(tag)?.(bytes, drawing);
    this.lines.end();
  }
}
