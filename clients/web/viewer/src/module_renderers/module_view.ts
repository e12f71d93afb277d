// Renders module channels, and reports which entities can be controlled and how. Kinds without a
// renderer are not subscribed to.

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

/** By kind. A new module needs a file in this folder and a line here. */
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

/** Channel kinds that can be rendered. */
export const RENDERED_CHANNEL_KINDS: readonly string[] = [...RENDERERS.keys()];

/** The channels of the rendered frame. */
export interface RenderedChannels {
  readonly frame: number;
  readonly channels: Channels;
  readonly secondsAfter: number; // s, from that frame to the rendered time
  readonly kinds: readonly { name: string; divisor: number }[];
  readonly tickHz: number;
}

/** Input of one rendered frame. */
export interface FrameInput extends Pick<RenderContext, 'nowMs' | 'cameraTarget' | 'poseOf' | 'entityOf'> {
  /** Adds solids that do not belong to a module. */
  decorate?(solids: Solids): void;
}

/** The channels of one kind and their renderer. */
interface KindChannels {
  readonly renderer: ModuleRenderer;
  readonly data: readonly ChannelData[];
}

export class ModuleView {
  readonly lines = VertexBuffer.lines(0.9);
  readonly solids: Solids;
  readonly water: Water;
  readonly blasts: BlastMarks;
  debug = false;
  private renderedKinds: readonly KindChannels[] = [];
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

  /** Call once per rendered frame, after the body poses were updated. */
  update(rendered: RenderedChannels, input: FrameInput): void {
    this.renderedKinds = this.groupByKind(rendered, rendered.channels);
    const { lines, solids, water, blasts, debug } = this;
    for (const buffer of [lines, solids, water]) buffer.begin();
    const context: RenderContext = { ...input, lines, solids, water, blasts, debug };
    for (const { renderer, data } of this.renderedKinds) renderer.draw?.(data, context);
    input.decorate?.(solids);
    for (const buffer of [lines, solids, water]) buffer.end();
    blasts.update(input.nowMs);
  }

  /**
   * Colors of bodies without an own color; undefined if they did not change. `changed`: the set of
   * bodies changed.
   */
  bodyColors(rendered: RenderedChannels, changed: boolean, entities: ReadonlyMap<number, Entity>): Map<number, number> | undefined {
    const coloring = rendered.channels.filter(({ kind }) => this.rendererOf(rendered, kind)?.bodyColors);
    // Frames share channels that did not change.
    const same = coloring.length === this.coloredChannels.length && coloring.every((channel, k) => channel === this.coloredChannels[k]);
    if (same && !changed) return undefined;
    this.coloredChannels = coloring;
    const colors = new Map<number, number>();
    for (const { renderer, data } of this.groupByKind(rendered, coloring))
      for (const [entity, color] of renderer.bodyColors?.(data, entities) ?? []) colors.set(entity, color);
    return colors;
  }

  /** How an entity is controlled; undefined if no rendered module has it. */
  steeringOf(entity: number): Steering | undefined {
    return this.controlledRenderer(entity)?.steering;
  }

  /** Status text for the user who controls the entity. */
  controlledStatusText(entity: number): string {
    const { steering, data } = this.controlledRenderer(entity) ?? {};
    return (data && steering?.statusText?.(data)) ?? '';
  }

  /** Status text for all users. */
  statusText(): string {
    return this.renderedKinds
      .map(({ renderer, data }) => renderer.statusText?.(data) ?? '')
      .filter((statusText) => statusText !== '')
      .join(' · ');
  }

  private rendererOf({ kinds }: RenderedChannels, kind: number): ModuleRenderer | undefined {
    return this.renderers.get(kinds[kind]?.name ?? '');
  }

  /** Groups channels, which are in ascending order of kind. */
  private groupByKind(rendered: RenderedChannels, channels: Channels): KindChannels[] {
    const data = new Map<number, ChannelData[]>();
    for (const { kind, entity, values } of channels) {
      // A kind is sent in tick 1 and every `divisor` ticks after it.
      const ticks = (rendered.frame - 1) % Math.max(rendered.kinds[kind]?.divisor ?? 1, 1);
      const seconds = ticks / rendered.tickHz + rendered.secondsAfter;
      const ofKind = data.get(kind);
      if (ofKind) ofKind.push({ entity, values, seconds });
      else data.set(kind, [{ entity, values, seconds }]);
    }
    return [...data].flatMap(([kind, ofKind]) => {
      const renderer = this.rendererOf(rendered, kind);
      return renderer ? [{ renderer, data: ofKind }] : [];
    });
  }

  private controlledRenderer(entity: number): { steering: Steering; data: ChannelData } | undefined {
    for (const { renderer, data } of this.renderedKinds) {
      const one = renderer.steering && data.find((of) => of.entity === entity);
      if (renderer.steering && one) return { steering: renderer.steering, data: one };
    }
    return undefined;
  }
}
