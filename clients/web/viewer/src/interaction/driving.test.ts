import { describe, expect, it } from 'vitest';
import type { Input } from '@jostle/client';
import { combinePads, Driving, readControls, cameraYaw, type Pad } from './driving';

const pad = (axes: number[], pressed: Record<number, number> = {}): Pad => ({
  axes,
  buttons: Array.from({ length: 16 }, (_, k) => ({ pressed: (pressed[k] ?? 0) > 0.5, value: pressed[k] ?? 0 })),
});

describe('control input', () => {
  it('sums keys, sticks and triggers, clamped to 1000', () => {
    expect(readControls(new Set(['KeyW', 'KeyA']), undefined, 0)).toEqual({ axes: [-1000, 1000, 0, 0], buttons: 0 });
    expect(readControls(new Set(['KeyW', 'KeyS']), undefined, 0).axes[1]).toBe(0);
    expect(readControls(new Set(), pad([0.5, 0], { 7: 0.25 }), -0.5)).toEqual({ axes: [500, 250, 0, -500], buttons: 0 });
    expect(readControls(new Set(['KeyW']), pad([0, -1]), 0).axes[1]).toBe(1000);
  });
  it('has one bit per button', () => {
    expect(readControls(new Set(['Space']), undefined, 0).buttons).toBe(1);
    expect(readControls(new Set(['KeyQ', 'ShiftLeft']), undefined, 0).buttons).toBe(10);
    expect(readControls(new Set(), pad([], { 5: 1 }), 0).buttons).toBe(4);
  });
  it('ignores sticks within the dead zone', () => {
    expect(readControls(new Set(), pad([0.1, -0.1]), 0).axes).toEqual([0, 0, 0, 0]);
  });
  it('encodes the camera yaw in half turns to the left of -z', () => {
    expect(cameraYaw({ x: 0, z: -1 })).toBeCloseTo(0, 12);
    expect(cameraYaw({ x: -1, z: 0 })).toBeCloseTo(0.5, 12);
    expect(cameraYaw({ x: 1, z: 0 })).toBeCloseTo(-0.5, 12);
  });
});

describe('driving', () => {
  const startDriving = () => {
    const sent: Input[] = [];
    const driving = new Driving((input) => sent.push(input));
    return { sent, driving, cases: () => sent.map((input) => input.kind?.case) };
  };
  it('sends changes immediately and repeats the input once per second', () => {
    const { sent, driving, cases } = startDriving();
    driving.takeControl(7);
    driving.update(undefined, 0, 0);
    driving.update(undefined, 0, 16);
    expect(cases()).toEqual(['possess', 'control']);
    expect(driving.keyDown('KeyW')).toBe(true);
    driving.update(undefined, 0, 32);
    driving.update(undefined, 0, 900);
    driving.update(undefined, 0, 1100);
    expect(cases()).toEqual(['possess', 'control', 'control', 'control']);
    expect(sent[2]!.kind).toEqual({ case: 'control', value: { axes: [0, 1000, 0, 0], buttons: 0 } });
    driving.keyUp('KeyW');
    driving.update(undefined, 0, 1116);
    expect(sent[4]!.kind).toEqual({ case: 'control', value: { axes: [0, 0, 0, 0], buttons: 0 } });
  });
  it('ignores keys while no entity is controlled', () => {
    const { driving, cases } = startDriving();
    expect(driving.keyDown('KeyW')).toBe(false);
    driving.takeControl(7);
    expect(driving.keyDown('KeyX')).toBe(false);
    driving.stopControlling();
    driving.update(undefined, 0, 0);
    expect(cases()).toEqual(['possess', 'possess']);
    expect(driving.keyDown('KeyW')).toBe(false);
  });
});

it('combines a gamepad with on-screen controls', () => {
  const pad = (axes: number[], pressed: boolean[]) => ({ axes, buttons: pressed.map((one) => ({ pressed: one, value: one ? 1 : 0 })) });
  const combined = combinePads(pad([0.2, 0], [false]), pad([-0.8, 0.5], [true, false]))!;
  expect(combined.axes).toEqual([-0.8, 0.5]);
  expect(combined.buttons.map(({ pressed }) => pressed)).toEqual([true, false]);
  expect(combinePads(undefined, undefined)).toBeUndefined();
});
