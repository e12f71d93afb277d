// A menu for the body at a point of the view, opened by a right click or a long press.

export interface MenuItem {
  readonly label: string;
  /** The rule that refuses the item, which is disabled and shows it; empty or absent: it is allowed. */
  readonly refusal?: string;
  run(): void;
}

const MARGIN = 8; // pixels from the border of the page

export class ContextMenu {
  constructor(private readonly element: HTMLElement) {
    addEventListener('pointerdown', (event) => {
      if (!this.element.contains(event.target as Node)) this.close();
    }, { capture: true });
    element.addEventListener('keydown', (event) => this.key(event));
  }

  get isOpen(): boolean {
    return !this.element.hidden;
  }

  open(title: string, items: readonly MenuItem[], x: number, y: number): void {
    const heading = document.createElement('p');
    heading.textContent = title;
    heading.setAttribute('role', 'presentation');
    this.element.setAttribute('aria-label', title);
    this.element.replaceChildren(
      heading,
      ...items.map(({ label, run, refusal }) => {
        const button = document.createElement('button');
        button.type = 'button';
        button.setAttribute('role', 'menuitem');
        button.textContent = label;
        if (refusal) {
          button.setAttribute('aria-disabled', 'true');
          button.append(Object.assign(document.createElement('small'), { textContent: refusal }));
        }
        button.onclick = () => {
          if (refusal) return;
          this.close();
          run();
        };
        return button;
      }),
    );
    this.element.hidden = false;
    const { width, height } = this.element.getBoundingClientRect();
    this.element.style.left = `${Math.max(MARGIN, Math.min(x, innerWidth - width - MARGIN))}px`;
    this.element.style.top = `${Math.max(MARGIN, Math.min(y, innerHeight - height - MARGIN))}px`;
    this.buttons[0]?.focus();
  }

  /** Returns whether the menu was open. */
  close(): boolean {
    if (this.element.hidden) return false;
    this.element.hidden = true;
    return true;
  }

  private get buttons(): HTMLButtonElement[] {
    return [...this.element.querySelectorAll('button')];
  }

  private key(event: KeyboardEvent): void {
    const step = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const { buttons } = this;
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    buttons[(at + step + buttons.length) % buttons.length]?.focus();
  }
}
