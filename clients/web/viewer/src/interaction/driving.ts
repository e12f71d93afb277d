// Driving: what keys and a gamepad hold goes to the entity that this client has taken the wheel of, and the camera follows behind. What
// axes and buttons mean is the module's; they are those of Controls (docs/modules.md).

import type { Input } from '@jostle/client';

const AXES = { right: 0, ahead: 1, up: 2, yaw: 3 } as const;
const AXIS_COUNT = 4;
const THOUSANDTHS = 1000;
const REPEAT_MS = 1000; // what is held is told again: an input may have been refused
const DEAD_ZONE = 0.15; // of a stick that nobody touches

/** Keys by KeyboardEvent.code, so that they lie alike on every keyboard. */
const KEYS: Record<string, [axis: number, value: number]> = {
  KeyW: [AXES.ahead, 1],
  ArrowUp: [AXES.ahead, 1],
  KeyS: [AXES.ahead, -1],
  ArrowDown: [AXES.ahead, -1],
  KeyD: [AXES.right, 1],
  ArrowRight: [AXES.right, 1],
  KeyA: [AXES.right, -1],
  ArrowLeft: [AXES.right, -1],
};
/** The bit of each button; the pad's are those of the standard layout. */
const BUTTONS: { code: string; pad: number; bit: number }[] = [
  { code: 'Space', pad: 0, bit: 0 },
  { code: 'ShiftLeft', pad: 1, bit: 1 },
  { code: 'KeyE', pad: 5, bit: 2 },
  { code: 'KeyQ', pad: 4, bit: 3 },
];

export interface ControlInput {
  axes: number[]; // thousandths
  buttons: number;
}

/** What a gamepad tells, as far as we read it. */
export interface Pad {
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

function stick(value: number | undefined): number {
  return value === undefined || Math.abs(value) < DEAD_ZONE ? 0 : value;
}

/** What keys and pad hold together. `look`: where the camera looks, in half turns about y from -z, to the left. */
export function readControls(keys: ReadonlySet<string>, pad: Pad | undefined, yaw: number): ControlInput {
  const axes = new Array<number>(AXIS_COUNT).fill(0);
  for (const code of keys) {
    const key = KEYS[code];
    if (key) axes[key[0]] = axes[key[0]]! + key[1];
  }
  let buttons = 0;
  for (const { code, bit } of BUTTONS) if (keys.has(code)) buttons |= 1 << bit;
  if (pad) {
    axes[AXES.right] = axes[AXES.right]! + stick(pad.axes[0]);
    // Triggers for who drives, the stick for who walks.
    axes[AXES.ahead] = axes[AXES.ahead]! - stick(pad.axes[1]) + (pad.buttons[7]?.value ?? 0) - (pad.buttons[6]?.value ?? 0);
    for (const { pad: index, bit } of BUTTONS) if (pad.buttons[index]?.pressed) buttons |= 1 << bit;
  }
  axes[AXES.yaw] = yaw;
  const whole = (x: number) => Math.round(Math.min(1, Math.max(-1, x)) * THOUSANDTHS) + 0; // no -0
  return { axes: axes.map(whole), buttons };
}

/** From a camera's direction. */
export function cameraYaw(direction: { x: number; z: number }): number {
  return Math.atan2(-direction.x, -direction.z) / Math.PI;
}

export class Driving {
  entity = 0; // 0: none
  private readonly keys = new Set<string>();
  private lastSent: ControlInput | undefined;
  private lastSentAt = 0;

  constructor(private readonly send: (input: Input) => void) {}

  take(entity: number): void {
    this.entity = entity;
    this.lastSent = undefined;
    this.keys.clear();
    this.send({ kind: { case: 'possess', value: { entity } } });
  }
  stopControlling(): void {
    if (this.entity !== 0) this.take(0);
  }
  /** The entity went, or the world changed: nobody need be told. */
  forget(): void {
    this.entity = 0;
    this.keys.clear();
  }

  /** Whether the key is one to drive with. */
  down(code: string): boolean {
    if (this.entity === 0 || !(code in KEYS || BUTTONS.some((button) => button.code === code))) return false;
    this.keys.add(code);
    return true;
  }
  up(code: string): void {
    this.keys.delete(code);
  }
  /** The page lost the keyboard: nothing is held any more. */
  blur(): void {
    this.keys.clear();
  }

  /** Once a picture. */
  update(pad: Pad | undefined, yaw: number, nowMs: number): void {
    if (this.entity === 0) return;
    const held = readControls(this.keys, pad, yaw);
    const same = this.lastSent?.buttons === held.buttons && this.lastSent.axes.every((axis, k) => axis === held.axes[k]);
    if (same && nowMs - this.lastSentAt < REPEAT_MS) return;
    this.lastSent = held;
    this.lastSentAt = nowMs;
    this.send({ kind: { case: 'control', value: held } });
  }
}
