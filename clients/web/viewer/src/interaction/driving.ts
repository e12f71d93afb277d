// Sends the input of keys, gamepad and on-screen controls to the controlled entity. Axes and buttons are those of Controls
// (docs/guides/game_developer/modules.md).

import type { Input } from '@jostle/client';

const AXES = { right: 0, forward: 1, up: 2, yaw: 3 } as const;
const AXIS_COUNT = 4;
const THOUSANDTHS = 1000;
const REPEAT_MS = 1000; // the input is repeated in case one was rejected
const DEAD_ZONE = 0.15; // of an untouched stick

/** By KeyboardEvent.code, which is independent of the keyboard layout. */
const KEYS: Record<string, [axis: number, value: number]> = {
  KeyW: [AXES.forward, 1],
  ArrowUp: [AXES.forward, 1],
  KeyS: [AXES.forward, -1],
  ArrowDown: [AXES.forward, -1],
  KeyD: [AXES.right, 1],
  ArrowRight: [AXES.right, 1],
  KeyA: [AXES.right, -1],
  ArrowLeft: [AXES.right, -1],
};
/** The bit of each button; `pad` is its index in the standard gamepad layout. */
export const BUTTONS: readonly { code: string; pad: number; bit: number }[] = [
  { code: 'Space', pad: 0, bit: 0 },
  { code: 'ShiftLeft', pad: 1, bit: 1 },
  { code: 'KeyE', pad: 5, bit: 2 },
  { code: 'KeyQ', pad: 4, bit: 3 },
];

export interface ControlInput {
  axes: number[]; // thousandths
  buttons: number;
}

/** The part of Gamepad that is read. */
export interface Pad {
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

/** The stronger input of two pads; undefined: one of them. */
export function combinePads(a: Pad | undefined, b: Pad | undefined): Pad | undefined {
  if (!a || !b) return a ?? b;
  const stronger = (x = 0, y = 0) => (Math.abs(y) > Math.abs(x) ? y : x);
  const length = Math.max(a.buttons.length, b.buttons.length);
  return {
    axes: [0, 1].map((axis) => stronger(a.axes[axis], b.axes[axis])),
    buttons: Array.from({ length }, (_, k) => ({
      pressed: (a.buttons[k]?.pressed ?? false) || (b.buttons[k]?.pressed ?? false),
      value: Math.max(a.buttons[k]?.value ?? 0, b.buttons[k]?.value ?? 0),
    })),
  };
}

function stick(value: number | undefined): number {
  return value === undefined || Math.abs(value) < DEAD_ZONE ? 0 : value;
}

/**
 * Combined input of keys and gamepad. `yaw`: direction of the camera, in half turns about y from -z, to
 * the left.
 */
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
    // Triggers for vehicles, the stick for characters.
    axes[AXES.forward] = axes[AXES.forward]! - stick(pad.axes[1]) + (pad.buttons[7]?.value ?? 0) - (pad.buttons[6]?.value ?? 0);
    for (const { pad: index, bit } of BUTTONS) if (pad.buttons[index]?.pressed) buttons |= 1 << bit;
  }
  axes[AXES.yaw] = yaw;
  const toThousandths = (x: number) => Math.round(Math.min(1, Math.max(-1, x)) * THOUSANDTHS) + 0; // + 0: no negative zero
  return { axes: axes.map(toThousandths), buttons };
}

/** Yaw of a camera direction, in half turns. */
export function cameraYaw(direction: { x: number; z: number }): number {
  return Math.atan2(-direction.x, -direction.z) / Math.PI;
}

export class Driving {
  entity = 0; // 0: none
  private readonly keys = new Set<string>();
  private lastSent: ControlInput | undefined;
  private lastSentAt = 0;

  constructor(private readonly send: (input: Input) => void) {}

  takeControl(entity: number): void {
    this.entity = entity;
    this.lastSent = undefined;
    this.keys.clear();
    this.send({ kind: { case: 'possess', value: { entity } } });
  }
  stopControlling(): void {
    if (this.entity !== 0) this.takeControl(0);
  }
  /** The entity was removed or the world changed: no message is necessary. */
  reset(): void {
    this.entity = 0;
    this.keys.clear();
  }

  /** Returns whether the key controls the entity. */
  keyDown(code: string): boolean {
    if (this.entity === 0 || !(code in KEYS || BUTTONS.some((button) => button.code === code))) return false;
    this.keys.add(code);
    return true;
  }
  keyUp(code: string): void {
    this.keys.delete(code);
  }
  /** The page lost the keyboard focus. */
  blur(): void {
    this.keys.clear();
  }

  /** Call once per rendered frame. */
  update(pad: Pad | undefined, yaw: number, nowMs: number): void {
    if (this.entity === 0) return;
    const controls = readControls(this.keys, pad, yaw);
    const same = this.lastSent?.buttons === controls.buttons && this.lastSent.axes.every((axis, k) => axis === controls.axes[k]);
    if (same && nowMs - this.lastSentAt < REPEAT_MS) return;
    this.lastSent = controls;
    this.lastSentAt = nowMs;
    this.send({ kind: { case: 'control', value: controls } });
  }
}
