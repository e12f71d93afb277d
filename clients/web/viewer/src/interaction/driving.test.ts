import { describe, expect, it } from 'vitest';
import type { Input } from '@jostle/client';
import { Driving, readControls, cameraYaw, type Pad } from './driving';

const pad = (axes: number[], pressed: Record<number, number> = {}): Pad => ({
  axes,
  buttons: Array.from({ length: 16 }, (_, k) => ({ pressed: (pressed[k] ?? 0) > 0.5, value: pressed[k] ?? 0 })),
});

describe('what is held', () => {
  it('is the sum of keys, sticks and triggers, within a thousand', () => {
    expect(readControls(new Set(['KeyW', 'KeyA']), undefined, 0)).toEqual({ axes: [-1000, 1000, 0, 0], buttons: 0 });
    expect(readControls(new Set(['KeyW', 'KeyS']), undefined, 0).axes[1]).toBe(0);
    expect(readControls(new Set(), pad([0.5, 0], { 7: 0.25 }), -0.5)).toEqual({ axes: [500, 250, 0, -500], buttons: 0 });
    expect(readControls(new Set(['KeyW']), pad([0, -1]), 0).axes[1]).toBe(1000);
  });
  it('has a bit for each button', () => {
    expect(readControls(new Set(['Space']), undefined, 0).buttons).toBe(1);
    expect(readControls(new Set(['KeyQ', 'ShiftLeft']), undefined, 0).buttons).toBe(10);
    expect(readControls(new Set(), pad([], { 5: 1 }), 0).buttons).toBe(4);
  });
  it('is nothing when a stick only trembles', () => {
    expect(readControls(new Set(), pad([0.1, -0.1]), 0).axes).toEqual([0, 0, 0, 0]);
  });
  it('says where the camera looks, in half turns to the left of -z', () => {
    expect(cameraYaw({ x: 0, z: -1 })).toBeCloseTo(0, 12);
    expect(cameraYaw({ x: -1, z: 0 })).toBeCloseTo(0.5, 12);
    expect(cameraYaw({ x: 1, z: 0 })).toBeCloseTo(-0.5, 12);
  });
});

describe('driving', () => {
  const begun = () => {
    const sent: Input[] = [];
    const driving = new Driving((input) => sent.push(input));
    return { sent, driving, cases: () => sent.map((input) => input.kind?.case) };
  };
  it('tells what changed, and once a second what is held', () => {
    const { sent, driving, cases } = begun();
    driving.take(7);
    driving.update(undefined, 0, 0);
    driving.update(undefined, 0, 16);
    expect(cases()).toEqual(['possess', 'control']);
    expect(driving.down('KeyW')).toBe(true);
    driving.update(undefined, 0, 32);
    driving.update(undefined, 0, 900);
    driving.update(undefined, 0, 1100);
    expect(cases()).toEqual(['possess', 'control', 'control', 'control']);
    expect(sent[2]!.kind).toEqual({ case: 'control', value: { axes: [0, 1000, 0, 0], buttons: 0 } });
    driving.up('KeyW');
    driving.update(undefined, 0, 1116);
    expect(sent[4]!.kind).toEqual({ case: 'control', value: { axes: [0, 0, 0, 0], buttons: 0 } });
  });
  it('leaves keys alone while nothing is driven', () => {
    const { driving, cases } = begun();
    expect(driving.down('KeyW')).toBe(false);
    driving.take(7);
    expect(driving.down('KeyX')).toBe(false);
    driving.stopControlling();
    driving.update(undefined, 0, 0);
    expect(cases()).toEqual(['possess', 'possess']);
    expect(driving.down('KeyW')).toBe(false);
  });
});
