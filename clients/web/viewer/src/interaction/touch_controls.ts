// On-screen controls of the controlled entity, for touch screens: a stick and a button per function.
// They read like a gamepad.

import { BUTTONS, type Pad } from './driving';

const REACH = 44; // pixels from the center of the stick to its rim

export class TouchControls implements Pad {
  readonly axes = [0, 0];
  readonly buttons = Array.from({ length: 8 }, () => ({ pressed: false, value: 0 }));
  private readonly stick = document.createElement('div');
  private readonly knob = document.createElement('div');
  private readonly row = document.createElement('div');
  private pointer: number | undefined; // that moves the stick
  private shownLabels = '';

  constructor(private readonly element: HTMLElement) {
    this.stick.className = 'stick';
    this.knob.className = 'knob';
    this.row.className = 'actions';
    this.stick.setAttribute('role', 'img');
    this.stick.setAttribute('aria-label', 'Stick: drag to steer');
    this.stick.append(this.knob);
    element.append(this.stick, this.row);
    element.hidden = true;
    this.stick.addEventListener('pointerdown', (event) => {
      this.pointer = event.pointerId;
      this.stick.setPointerCapture(event.pointerId);
      this.steer(event);
    });
    this.stick.addEventListener('pointermove', (event) => event.pointerId === this.pointer && this.steer(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      this.stick.addEventListener(end, (event) => event.pointerId === this.pointer && this.center());
  }

  /** `labels`: of the buttons, by their bits; undefined: hides the controls. */
  show(labels: readonly string[] | undefined): void {
    this.element.hidden = labels === undefined;
    if (!labels) return this.releaseAll();
    const shown = labels.join('\n');
    if (shown === this.shownLabels) return;
    this.shownLabels = shown;
    this.releaseAll();
    this.row.replaceChildren(...labels.flatMap((label, bit) => (label ? [this.button(label, bit)] : [])));
  }

  private button(label: string, bit: number): HTMLButtonElement {
    const state = this.buttons[BUTTONS.find((button) => button.bit === bit)!.pad]!;
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = label;
    const press = (pressed: boolean) => {
      state.pressed = pressed;
      state.value = pressed ? 1 : 0;
      button.classList.toggle('pressed', pressed);
    };
    button.addEventListener('pointerdown', (event) => {
      button.setPointerCapture(event.pointerId);
      press(true);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) button.addEventListener(end, () => press(false));
    button.addEventListener('contextmenu', (event) => event.preventDefault());
    return button;
  }

  private steer(event: PointerEvent): void {
    const box = this.stick.getBoundingClientRect();
    const [x, y] = stickPosition(event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2);
    [this.axes[0], this.axes[1]] = [x, y];
    this.knob.style.transform = `translate(${REACH * x}px, ${REACH * y}px)`;
  }

  private center(): void {
    this.pointer = undefined;
    this.axes.fill(0);
    this.knob.style.transform = '';
  }

  private releaseAll(): void {
    this.center();
    for (const button of this.buttons) Object.assign(button, { pressed: false, value: 0 });
  }
}

/** Deflection of the stick by an offset in pixels from its center: at most 1 in any direction. */
export function stickPosition(right: number, down: number): [x: number, y: number] {
  const scale = 1 / Math.max(REACH, Math.hypot(right, down));
  return [right * scale, down * scale];
}
