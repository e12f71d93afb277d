// A render context for tests.

import * as THREE from 'three';
import type { Entity } from '@jostle/client/gen/play_pb';
import { Solids } from '../scene/solids';
import { VertexBuffer } from '../scene/vertex_buffer';
import { Water } from '../scene/water';
import type { RenderContext } from '../module_renderers/module_renderer';

export interface TestRenderContext extends RenderContext {
  readonly flashes: number[][];
}

/** begin() was called. All bodies are at `pose`, or where it returns. */
export function testRenderContext(
  pose: number[] | ((entity: number) => number[] | undefined) = [0, 0, 0, 0, 0, 0, 1],
  entities: ReadonlyMap<number, Entity> = new Map(),
  more: Partial<RenderContext> = {},
): TestRenderContext {
  const scene = new THREE.Scene();
  const flashes: number[][] = [];
  const context: TestRenderContext = {
    lines: VertexBuffer.lines(1),
    solids: new Solids(scene),
    water: new Water(scene),
    blasts: { add: (...mark: number[]) => void flashes.push(mark) },
    flashes,
    nowMs: 0,
    cameraTarget: { x: 0, y: 0, z: 0 },
    debug: false,
    poseOf: typeof pose === 'function' ? pose : () => pose,
    entityOf: (entity) => entities.get(entity),
    ...more,
  };
  context.lines.begin();
  context.solids.begin();
  context.water.begin();
  return context;
}
