import * as THREE from 'three';
import { describe, expect, it, vi } from 'vitest';
import type { Channel } from '@jostle/client';
import type { ModuleRenderer, ChannelData } from './module_renderer';
import { RENDERED_CHANNEL_KINDS, ModuleView, type FrameInput, type RenderedChannels } from './module_view';

const WHITE = new THREE.Color(0xffffff);
const KINDS = [
  { name: 'rare', divisor: 60 },
  { name: 'lines', divisor: 1 },
];

/** One line per value, at the position of the entity. */
const drawLines: ModuleRenderer = {
  draw(data, { lines, poseOf }) {
    for (const { entity, values } of data)
      for (const value of values) {
        const x = poseOf(entity)?.[0] ?? 0;
        lines.vertex(x, 0, 0, WHITE);
        lines.vertex(x, value, 0, WHITE);
      }
  },
  steering: { keys: 'W', buttons: [], camera: 'behind', distance: 5, statusText: ({ values }) => `number ${values[0]}` },
  bodyColors: (data) => new Map(data.map(({ entity, values }) => [entity, 0x100000 + values[0]!])),
  statusText: (data) => `${data.length} of them`,
};
const LINES = new Map([['lines', drawLines]]);

const channel = (kind: number, entity: number, ...values: number[]): Channel => ({ kind, entity, values: new Int32Array(values) });
const rendered = (...channels: Channel[]): RenderedChannels => ({ frame: 31, channels, secondsAfter: -0.01, kinds: KINDS, tickHz: 60 });
const input = (poseOf: FrameInput['poseOf'] = () => undefined): FrameInput => ({
  nowMs: 0,
  cameraTarget: { x: 0, y: 0, z: 0 },
  poseOf,
  entityOf: () => undefined,
});

describe('module channels', () => {
  it('are rendered by the renderer of their kind until they end', () => {
    const scene = new THREE.Scene();
    const view = new ModuleView(scene, LINES);
    const posedInput = input((entity) => [entity * 10]);
    view.update(rendered(channel(1, 7, 1), channel(1, 8, 2)), posedInput);
    expect(scene.children).toContain(view.lines.object);
    expect(view.lines.count).toBe(4);
    expect(view.lines.object.geometry.getAttribute('position').getX(2)).toBe(80);
    view.update(rendered(channel(1, 8, 3)), posedInput);
    expect(view.lines.count).toBe(2);
    view.update(rendered(), posedInput);
    expect(view.lines.count).toBe(0);
    expect(view.lines.object.visible).toBe(false);
  });

  it('are passed to their renderer together with the time since they were sent', () => {
    const calls: (readonly ChannelData[])[] = [];
    const view = new ModuleView(new THREE.Scene(), new Map([['rare', { draw: (data) => calls.push(data) } as ModuleRenderer]]));
    view.update(rendered(channel(0, 3), channel(0, 4), channel(1, 3)), input());
    expect(calls).toHaveLength(1);
    expect(calls[0]!.map(({ entity }) => entity)).toEqual([3, 4]);
    for (const { seconds } of calls[0]!) expect(seconds).toBeCloseTo(0.49, 9);
  });

  it('are ignored when their kind is unknown', () => {
    const view = new ModuleView(new THREE.Scene());
    for (const name of ['counter', 'constructor', '__proto__', ''])
      view.update({ ...rendered(channel(0, 1, 1), channel(7, 1, 1)), kinds: [{ name, divisor: 0 }] }, input());
    expect(view.lines.count + view.solids.count).toBe(0);
  });

  it('are requested by renderable kinds', async () => {
    expect(RENDERED_CHANNEL_KINDS).toContain('fields.waves');
    const view = new ModuleView(new THREE.Scene());
    const craft = channel(0, 3, ...new Array<number>(20).fill(0));
    // The renderer is loaded when the kind appears.
    await vi.waitFor(() => {
      view.update({ ...rendered(craft), kinds: [{ name: 'hovercraft', divisor: 1 }] }, input(() => [0, 0, 0, 0, 0, 0, 1]));
      expect(view.lines.count).toBe(8);
    });
  });

  it('report controllable entities and their keys', () => {
    const view = new ModuleView(new THREE.Scene(), LINES);
    view.update(rendered(channel(0, 9, 1), channel(1, 7, 70), channel(1, 8, 80)), input());
    expect(view.steeringOf(8)?.keys).toBe('W');
    expect(view.steeringOf(9)).toBeUndefined();
    expect(view.controlledStatusText(7)).toBe('number 70');
    expect(view.controlledStatusText(9)).toBe('');
    expect(view.statusText()).toBe('2 of them');
  });

  it('recolor bodies only when channels or bodies change', () => {
    const view = new ModuleView(new THREE.Scene(), LINES);
    const bodyColors = (changed: boolean, ...channels: Channel[]) => view.bodyColors(rendered(...channels), changed, new Map());
    const seven = channel(1, 7, 7);
    expect(bodyColors(false, seven)).toEqual(new Map([[7, 0x100007]]));
    expect(bodyColors(false, channel(0, 7, 1), seven)).toBeUndefined();
    expect(bodyColors(true, seven)).toEqual(new Map([[7, 0x100007]]));
    expect(bodyColors(false, channel(1, 7, 9))).toEqual(new Map([[7, 0x100009]]));
    expect(bodyColors(false)).toEqual(new Map());
    expect(bodyColors(false)).toBeUndefined();
  });
});
