// Draws what modules tell, and says who can be driven and how. A module whose tag has no drawer is not shown.

import type * as THREE from 'three';
import { BlastMarks } from './blast_marks';
import { boats } from './drawers/boat';
import { characters } from './drawers/character';
import { destructibles } from './drawers/destruction';
import type { Drawer, Drawing, Steering } from './drawers/drawer';
import { fields } from './drawers/fields';
import { hovercraft } from './drawers/hovercraft';
import { ragdolls } from './drawers/ragdoll';
import { vehicles } from './drawers/vehicle';
import type { Entity } from './gen/jostle/v1/play_pb';
import { NO_CHUNKS, type Chunks } from './module_chunks';
import { Solids } from './solids';
import { VertexBuffer } from './vertex_buffer';
import { Water } from './water';

/** By tag: a new kind is a file in drawers/ and a line here. */
const DRAWERS: ReadonlyMap<string, Drawer> = new Map([
  ['boat', boats],
  ['character', characters],
  ['destruction', destructibles],
  ['fields', fields],
  ['hovercraft', hovercraft],
  ['ragdoll', ragdolls],
  ['vehicle', vehicles],
]);

/** Of the moment that a picture shows. */
export interface Moment extends Pick<Drawing, 'seconds' | 'nowMs' | 'around' | 'poseOf' | 'entityOf'> {
  /** What else is to be drawn, that no module tells. */
  decorate?(solids: Solids): void;
}

export class ModuleView {
  readonly lines = VertexBuffer.lines(0.9);
  readonly solids: Solids;
  readonly water: Water;
  readonly blasts: BlastMarks;
  debug = false;
  private chunks: Chunks = NO_CHUNKS;
  private dressed: Chunks = NO_CHUNKS;

  constructor(
    scene: THREE.Scene,
    private readonly drawers = DRAWERS,
  ) {
    scene.add(this.lines.object);
    this.solids = new Solids(scene);
    this.water = new Water(scene);
    this.blasts = new BlastMarks(scene);
  }

  /** Once a picture, after the bodies were put where they are. */
  update(chunks: Chunks, moment: Moment): void {
    this.chunks = chunks;
    const { lines, solids, water, blasts, debug } = this;
    for (const buffer of [lines, solids, water]) buffer.begin();
    const drawing: Drawing = { ...moment, lines, solids, water, blasts, debug };
    for (const [tag, bytes] of chunks) this.drawers.get(tag)?.draw?.(bytes, drawing);
    moment.decorate?.(solids);
    for (const buffer of [lines, solids, water]) buffer.end();
    blasts.update(moment.nowMs);
  }

  /** Colours for bodies that have none; nothing when they are as they were. `changed`: other bodies are there than before. */
  dress(chunks: Chunks, changed: boolean, entities: ReadonlyMap<number, Entity>): Map<number, number> | undefined {
    const before = this.dressed;
    const same = [...chunks].every(([tag, bytes]) => !this.drawers.get(tag)?.dress || before.get(tag) === bytes);
    if (same && !changed) return undefined;
    this.dressed = chunks;
    const colors = new Map<number, number>();
    for (const [tag, bytes] of chunks)
      for (const [entity, color] of this.drawers.get(tag)?.dress?.(bytes, entities) ?? []) colors.set(entity, color);
    return colors;
  }

  /** How an entity is driven; nothing when no module that we know has it. */
  steeringOf(entity: number): Steering | undefined {
    for (const [tag, bytes] of this.chunks) {
      const steering = this.drawers.get(tag)?.steering;
      if (steering?.entities(bytes).includes(entity)) return steering;
    }
    return undefined;
  }

  /** What the driver of that entity wants to know. */
  drivenWords(entity: number): string {
    for (const [tag, bytes] of this.chunks) {
      const steering = this.drawers.get(tag)?.steering;
      if (steering?.words && steering.entities(bytes).includes(entity)) return steering.words(bytes, entity);
    }
    return '';
  }

  /** What everybody wants to know. */
  words(): string {
    return [...this.chunks]
      .map(([tag, bytes]) => this.drawers.get(tag)?.words?.(bytes) ?? '')
      .filter((words) => words !== '')
      .join(' · ');
  }
}
