// Draws what modules tell, and says who can be driven and how. Only kinds that have a drawer are asked for.

import type * as THREE from 'three';
import { BlastMarks } from '../scene/blast_marks';
import type { Channel, Channels } from '@jostle/client';
import { boats } from './boat';
import { characters } from './character';
import { destructibles } from './destruction';
import type { ModuleRenderer, RenderContext, Steering, ChannelData } from './module_renderer';
import { fields, waves } from './fields';
import { hovercraft } from './hovercraft';
import { ragdolls } from './ragdoll';
import { vehicles } from './vehicle';
import type { Entity } from '@jostle/client/gen/play_pb';
import { Solids } from '../scene/solids';
import { VertexBuffer } from '../scene/vertex_buffer';
import { Water } from '../scene/water';

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
export interface RenderedChannels {
  readonly frame: number;
  readonly channels: Channels;
  readonly secondsAfter: number; // s, from that frame to the moment that is shown
  readonly kinds: readonly { name: string; divisor: number }[];
  readonly tickHz: number;
}

/** Of the moment that a picture shows. */
export interface FrameInput extends Pick<RenderContext, 'nowMs' | 'around' | 'poseOf' | 'entityOf'> {
  /** What else is to be drawn, that no module tells. */
  decorate?(solids: Solids): void;
}

/** What is told of one kind, and who draws it. */
interface Part {
  readonly renderer: ModuleRenderer;
  readonly data: readonly ChannelData[];
}

export class ModuleView {
  readonly lines = VertexBuffer.lines(0.9);
  readonly solids: Solids;
  readonly water: Water;
  readonly blasts: BlastMarks;
  debug = false;
  private parts: readonly Part[] = [];
  private coloredChannels: readonly Channel[] = [];

  constructor(
    scene: THREE.Scene,
    private readonly renderers = RENDERERS,
  ) {
    scene.add(this.lines.object);
    this.solids = new Solids(scene);
    this.water = new Water(scene);
    this.blasts = new BlastMarks(scene);
  }

  /** Once a picture, after the bodies were put where they are. */
  update(shown: RenderedChannels, input: FrameInput): void {
    this.parts = this.partsOf(shown, shown.channels);
    const { lines, solids, water, blasts, debug } = this;
    for (const buffer of [lines, solids, water]) buffer.begin();
    const context: RenderContext = { ...input, lines, solids, water, blasts, debug };
    for (const { renderer, data } of this.parts) renderer.draw?.(data, context);
    input.decorate?.(solids);
    for (const buffer of [lines, solids, water]) buffer.end();
    blasts.update(input.nowMs);
  }

  /** Colours for bodies that have none; nothing when they are as they were. `changed`: other bodies are there than before. */
  bodyColors(shown: RenderedChannels, changed: boolean, entities: ReadonlyMap<number, Entity>): Map<number, number> | undefined {
    const dressing = shown.channels.filter(({ kind }) => this.drawerOf(shown, kind)?.bodyColors);
    // Frames share channels that did not change.
    const same = dressing.length === this.coloredChannels.length && dressing.every((channel, k) => channel === this.coloredChannels[k]);
    if (same && !changed) return undefined;
    this.coloredChannels = dressing;
    const colors = new Map<number, number>();
    for (const { renderer, data } of this.partsOf(shown, dressing))
      for (const [entity, color] of renderer.bodyColors?.(data, entities) ?? []) colors.set(entity, color);
    return colors;
  }

  /** How an entity is driven; nothing when no module that we know has it. */
  steeringOf(entity: number): Steering | undefined {
    return this.controlledRenderer(entity)?.steering;
  }

  /** What the driver of that entity wants to know. */
  controlledStatusText(entity: number): string {
    const { steering, data } = this.controlledRenderer(entity) ?? {};
    return (data && steering?.statusText?.(data)) ?? '';
  }

  /** What everybody wants to know. */
  statusText(): string {
    return this.parts
      .map(({ renderer, data }) => renderer.statusText?.(data) ?? '')
      .filter((statusText) => statusText !== '')
      .join(' · ');
  }

  private drawerOf({ kinds }: RenderedChannels, kind: number): ModuleRenderer | undefined {
    return this.renderers.get(kinds[kind]?.name ?? '');
  }

  /** Of some of its channels, which are in order of their kinds. */
  private partsOf(shown: RenderedChannels, channels: Channels): Part[] {
    const data = new Map<number, ChannelData[]>();
    for (const { kind, entity, values } of channels) {
      // A kind is told in tick 1 and every `divisor` ticks from there.
      const ticks = (shown.frame - 1) % Math.max(shown.kinds[kind]?.divisor ?? 1, 1);
      const seconds = ticks / shown.tickHz + shown.secondsAfter;
      const ofKind = data.get(kind);
      if (ofKind) ofKind.push({ entity, values, seconds });
      else data.set(kind, [{ entity, values, seconds }]);
    }
    return [...data].flatMap(([kind, ofKind]) => {
      const renderer = this.drawerOf(shown, kind);
      return renderer ? [{ renderer, data: ofKind }] : [];
    });
  }

  private controlledRenderer(entity: number): { steering: Steering; data: ChannelData } | undefined {
    for (const { renderer, data } of this.parts) {
      const one = renderer.steering && data.find((of) => of.entity === entity);
      if (renderer.steering && one) return { steering: renderer.steering, data: one };
    }
    return undefined;
  }
}
