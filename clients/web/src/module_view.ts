// Draws what modules tell, and says who can be driven and how. Only kinds that have a drawer are asked for.

import type * as THREE from 'three';
import { BlastMarks } from './blast_marks';
import type { Channel, Channels } from './channels';
import { boats } from './drawers/boat';
import { characters } from './drawers/character';
import { destructibles } from './drawers/destruction';
import type { ModuleRenderer, RenderContext, Steering, ChannelData } from './drawers/drawer';
import { fields, waves } from './drawers/fields';
import { hovercraft } from './drawers/hovercraft';
import { ragdolls } from './drawers/ragdoll';
import { vehicles } from './drawers/vehicle';
import type { Entity } from './gen/jostle/v1/play_pb';
import { Solids } from './solids';
import { VertexBuffer } from './vertex_buffer';
import { Water } from './water';

/** By kind: a new one is a file in drawers/ and a line here. */
const RENDERERS: ReadonlyMap<string, ModuleRenderer> = new Map([
  ['boat', boats],
  ['character', characters],
  ['destruction', destructibles],
  ['fields', fields],
  ['fields.waves', waves],
  ['hovercraft', hovercraft],
  ['ragdoll', ragdolls],
  ['vehicle', vehicles],
]);

/** Kinds that can be drawn. */
export const RENDERED_CHANNEL_KINDS: readonly string[] = [...RENDERERS.keys()];

/** What is shown of what modules tell. */
export interface Shown {
  readonly frame: number;
  readonly channels: Channels;
  readonly later: number; // s, from that frame to the moment that is shown
  readonly kinds: readonly { name: string; divisor: number }[];
  readonly tickHz: number;
}

/** Of the moment that a picture shows. */
export interface Moment extends Pick<RenderContext, 'nowMs' | 'around' | 'poseOf' | 'entityOf'> {
  /** What else is to be drawn, that no module tells. */
  decorate?(solids: Solids): void;
}

/** What is told of one kind, and who draws it. */
interface Part {
  readonly renderer: ModuleRenderer;
  readonly told: readonly ChannelData[];
}

export class ModuleView {
  readonly lines = VertexBuffer.lines(0.9);
  readonly solids: Solids;
  readonly water: Water;
  readonly blasts: BlastMarks;
  debug = false;
  private parts: readonly Part[] = [];
  private dressed: readonly Channel[] = [];

  constructor(
    scene: THREE.Scene,
    private readonly module_renderers = RENDERERS,
  ) {
    scene.add(this.lines.object);
    this.solids = new Solids(scene);
    this.water = new Water(scene);
    this.blasts = new BlastMarks(scene);
  }

  /** Once a picture, after the bodies were put where they are. */
  update(shown: Shown, moment: Moment): void {
    this.parts = this.partsOf(shown, shown.channels);
    const { lines, solids, water, blasts, debug } = this;
    for (const buffer of [lines, solids, water]) buffer.begin();
    const context: RenderContext = { ...moment, lines, solids, water, blasts, debug };
    for (const { renderer, told } of this.parts) renderer.draw?.(told, context);
    moment.decorate?.(solids);
    for (const buffer of [lines, solids, water]) buffer.end();
    blasts.update(moment.nowMs);
  }

  /** Colours for bodies that have none; nothing when they are as they were. `changed`: other bodies are there than before. */
  dress(shown: Shown, changed: boolean, entities: ReadonlyMap<number, Entity>): Map<number, number> | undefined {
    const dressing = shown.channels.filter(({ kind }) => this.drawerOf(shown, kind)?.dress);
    // Frames share channels that did not change.
    const same = dressing.length === this.dressed.length && dressing.every((channel, k) => channel === this.dressed[k]);
    if (same && !changed) return undefined;
    this.dressed = dressing;
    const colors = new Map<number, number>();
    for (const { renderer, told } of this.partsOf(shown, dressing))
      for (const [entity, color] of renderer.dress?.(told, entities) ?? []) colors.set(entity, color);
    return colors;
  }

  /** How an entity is driven; nothing when no module that we know has it. */
  steeringOf(entity: number): Steering | undefined {
    return this.atWheel(entity)?.steering;
  }

  /** What the driver of that entity wants to know. */
  drivenWords(entity: number): string {
    const { steering, told } = this.atWheel(entity) ?? {};
    return (told && steering?.words?.(told)) ?? '';
  }

  /** What everybody wants to know. */
  words(): string {
    return this.parts
      .map(({ renderer, told }) => renderer.words?.(told) ?? '')
      .filter((words) => words !== '')
      .join(' · ');
  }

  private drawerOf({ kinds }: Shown, kind: number): ModuleRenderer | undefined {
    return this.module_renderers.get(kinds[kind]?.name ?? '');
  }

  /** Of some of its channels, which are in order of their kinds. */
  private partsOf(shown: Shown, channels: Channels): Part[] {
    const told = new Map<number, ChannelData[]>();
    for (const { kind, entity, values } of channels) {
      // A kind is told in tick 1 and every `divisor` ticks from there.
      const ticks = (shown.frame - 1) % Math.max(shown.kinds[kind]?.divisor ?? 1, 1);
      const seconds = ticks / shown.tickHz + shown.later;
      const ofKind = told.get(kind);
      if (ofKind) ofKind.push({ entity, values, seconds });
      else told.set(kind, [{ entity, values, seconds }]);
    }
    return [...told].flatMap(([kind, ofKind]) => {
      const renderer = this.drawerOf(shown, kind);
      return renderer ? [{ renderer, told: ofKind }] : [];
    });
  }

  private atWheel(entity: number): { steering: Steering; told: ChannelData } | undefined {
    for (const { renderer, told } of this.parts) {
      const one = renderer.steering && told.find((of) => of.entity === entity);
      if (renderer.steering && one) return { steering: renderer.steering, told: one };
    }
    return undefined;
  }
}
