// Renders module channels, and reports which entities can be controlled and how. Kinds without a
// renderer are not subscribed to. A renderer is loaded when a world has its kind.

import type * as THREE from 'three';
import { BlastMarks } from '../scene/blast_marks';
import type { Channel, Channels } from '@jostle/client';
import type { ModuleRenderer, RenderContext, Steering, ChannelData } from './module_renderer';
import type { Entity } from '@jostle/client/gen/play_pb';
import { Solids } from '../scene/solids';
import { VertexBuffer } from '../scene/vertex_buffer';
import { Water } from '../scene/water';

const RETRY_MS = 5000; // after a failed download

export type RendererLoader = () => Promise<ModuleRenderer>;

/** By kind. A new module needs a file in this folder and a line here. */
const RENDERERS: ReadonlyMap<string, ModuleRenderer | RendererLoader> = new Map<string, RendererLoader>([
  ['boat', async () => (await import('./boat')).boats],
  ['character', async () => (await import('./character')).characters],
  ['destruction', async () => (await import('./destruction')).destructibles],
  ['fields', async () => (await import('./fields')).fields],
  ['fields.waves', async () => (await import('./fields')).waves],
  ['hovercraft', async () => (await import('./hovercraft')).hovercraft],
  ['ragdoll', async () => (await import('./ragdoll')).ragdolls],
  ['vehicle', async () => (await import('./vehicle')).vehicles],
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
  private readonly loaded = new Map<string, ModuleRenderer>();
  private readonly loading = new Set<string>();

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

  /** undefined: not loaded yet, or unknown. */
  private rendererOf({ kinds }: RenderedChannels, kind: number): ModuleRenderer | undefined {
    const name = kinds[kind]?.name ?? '';
    const loaded = this.loaded.get(name);
    const renderer = loaded ? undefined : this.renderers.get(name);
    if (typeof renderer !== 'function') return loaded ?? renderer;
    if (!this.loading.has(name)) {
      this.loading.add(name);
      renderer().then(
        (made) => this.loaded.set(name, made),
        () => setTimeout(() => this.loading.delete(name), RETRY_MS),
      );
    }
    return undefined;
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
