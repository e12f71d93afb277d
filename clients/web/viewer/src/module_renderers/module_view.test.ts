import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import type { Channel } from '@jostle/client';
import type { ModuleRenderer, ChannelData } from './module_renderer';
import { RENDERED_CHANNEL_KINDS, ModuleView, type FrameInput, type RenderedChannels } from './module_view';

const WHITE = new THREE.Color(0xffffff);
const KINDS = [
  { name: 'rare', divisor: 60 },
  { name: 'lines', divisor: 1 },
];

/** One line for each number, where the entity is. */
const drawLines: ModuleRenderer = {
  draw(told, { lines, poseOf }) {
    for (const { entity, values } of told)
      for (const value of values) {
        const x = poseOf(entity)?.[0] ?? 0;
        lines.vertex(x, 0, 0, WHITE);
        lines.vertex(x, value, 0, WHITE);
      }
  },
  steering: { keys: 'W', camera: 'behind', distance: 5, statusText: ({ values }) => `number ${values[0]}` },
  bodyColors: (told) => new Map(told.map(({ entity, values }) => [entity, 0x100000 + values[0]!])),
  statusText: (told) => `${told.length} of them`,
};
const LINES = new Map([['lines', drawLines]]);

const channel = (kind: number, entity: number, ...values: number[]): Channel => ({ kind, entity, values: new Int32Array(values) });
const shown = (...channels: Channel[]): RenderedChannels => ({ frame: 31, channels, secondsAfter: -0.01, kinds: KINDS, tickHz: 60 });
const moment = (poseOf: FrameInput['poseOf'] = () => undefined): FrameInput => ({
  nowMs: 0,
  around: { x: 0, y: 0, z: 0 },
  poseOf,
  entityOf: () => undefined,
});

describe('what modules tell', () => {
  it('is drawn by the drawer of its kind, each picture anew, and gone with the channel', () => {
    const scene = new THREE.Scene();
    const view = new ModuleView(scene, LINES);
    const where = moment((entity) => [entity * 10]);
    view.update(shown(channel(1, 7, 1), channel(1, 8, 2)), where);
    expect(scene.children).toContain(view.lines.object);
    expect(view.lines.count).toBe(4);
    expect(view.lines.object.geometry.getAttribute('position').getX(2)).toBe(80);
    view.update(shown(channel(1, 8, 3)), where);
    expect(view.lines.count).toBe(2);
    view.update(shown(), where);
    expect(view.lines.count).toBe(0);
    expect(view.lines.object.visible).toBe(false);
  });

  it('comes to its drawer all at once, and with how long ago it was told: half a second, of one that is told once a second', () => {
    const pictures: (readonly ChannelData[])[] = [];
    const view = new ModuleView(new THREE.Scene(), new Map([['rare', { draw: (told) => pictures.push(told) } as ModuleRenderer]]));
    view.update(shown(channel(0, 3), channel(0, 4), channel(1, 3)), moment());
    expect(pictures).toHaveLength(1);
    expect(pictures[0]!.map(({ entity }) => entity)).toEqual([3, 4]);
    for (const { seconds } of pictures[0]!) expect(seconds).toBeCloseTo(0.49, 9);
  });

  it('is not shown when nobody knows the kind, whatever that is', () => {
    const view = new ModuleView(new THREE.Scene());
    for (const name of ['counter', 'constructor', '__proto__', ''])
      view.update({ ...shown(channel(0, 1, 1), channel(7, 1, 1)), kinds: [{ name, divisor: 0 }] }, moment());
    expect(view.lines.count + view.solids.count).toBe(0);
  });

  it('is asked for by kinds that can be drawn', () => {
    expect(RENDERED_CHANNEL_KINDS).toContain('fields.waves');
    const view = new ModuleView(new THREE.Scene());
    const craft = channel(0, 3, ...new Array<number>(20).fill(0));
    view.update({ ...shown(craft), kinds: [{ name: 'hovercraft', divisor: 1 }] }, moment(() => [0, 0, 0, 0, 0, 0, 1]));
    expect(view.lines.count).toBe(8);
  });

  it('says who can be driven, and how', () => {
    const view = new ModuleView(new THREE.Scene(), LINES);
    view.update(shown(channel(0, 9, 1), channel(1, 7, 70), channel(1, 8, 80)), moment());
    expect(view.steeringOf(8)?.keys).toBe('W');
    expect(view.steeringOf(9)).toBeUndefined();
    expect(view.controlledStatusText(7)).toBe('number 70');
    expect(view.controlledStatusText(9)).toBe('');
    expect(view.statusText()).toBe('2 of them');
  });

  it('dresses bodies anew only when a channel or the bodies are others', () => {
    const view = new ModuleView(new THREE.Scene(), LINES);
    const bodyColors = (changed: boolean, ...channels: Channel[]) => view.bodyColors(shown(...channels), changed, new Map());
    const seven = channel(1, 7, 7);
    expect(bodyColors(false, seven)).toEqual(new Map([[7, 0x100007]]));
    expect(bodyColors(false, channel(0, 7, 1), seven)).toBeUndefined();
    expect(bodyColors(true, seven)).toEqual(new Map([[7, 0x100007]]));
    expect(bodyColors(false, channel(1, 7, 9))).toEqual(new Map([[7, 0x100009]]));
    expect(bodyColors(false)).toEqual(new Map());
    expect(bodyColors(false)).toBeUndefined();
  });
});
