// The registry of panels. A panel is loaded when it is opened for the first time. On wide screens panels
// are docked at the left and right side; on narrow screens one panel at a time is a sheet at the bottom.

import { iconButton, type IconName } from './icons';

/** A loaded panel. */
export interface PanelContent {
  opened?(): void;
  closed?(): void;
  /** Called once per rendered frame while the panel is open. */
  update?(): void;
}

export interface PanelDefinition {
  readonly id: string; // of the panel's element
  readonly title: string;
  readonly hint: string;
  readonly key: string;
  readonly icon: IconName;
  readonly side: 'left' | 'right';
  /** Only narrow screens have a button for it. */
  readonly narrowOnly?: boolean;
  /** Its button on wide screens shows only the icon. */
  readonly compact?: boolean;
  load(content: HTMLElement): Promise<PanelContent>;
}

interface Panel {
  readonly definition: PanelDefinition;
  readonly section: HTMLElement;
  readonly body: HTMLElement;
  readonly button: HTMLButtonElement;
  content: PanelContent | undefined;
  loading: boolean;
}

export interface PanelPlaces {
  readonly left: HTMLElement;
  readonly right: HTMLElement;
  readonly buttons: HTMLElement;
}

export class Panels {
  private readonly panels = new Map<string, Panel>();
  private readonly open_: string[] = []; // ids, the one opened last at the end
  private readonly resizes = new ResizeObserver(() => this.onChange());
  private readonly narrow = matchMedia('(max-width: 699px)');

  constructor(
    private readonly places: PanelPlaces,
    /** Called when panels opened, closed or changed their size. */
    private readonly onChange: () => void,
  ) {
    this.narrow.addEventListener('change', () => {
      if (this.narrow.matches) this.closeOthers(this.open_.at(-1) ?? '');
    });
  }

  register(definition: PanelDefinition): void {
    const { id, title, hint, key, side } = definition;
    const section = document.createElement('section');
    section.id = id;
    section.className = 'panel';
    section.hidden = true;
    section.setAttribute('aria-label', title);
    const head = document.createElement('header');
    const heading = document.createElement('h2');
    heading.textContent = title;
    const close = iconButton('close', `Close ${title}`);
    close.className = 'close';
    close.onclick = () => this.close(id);
    head.append(heading, close);
    const body = document.createElement('div');
    body.className = 'body';
    body.tabIndex = 0; // so that keys scroll it
    body.setAttribute('role', 'group');
    body.setAttribute('aria-label', title);
    section.append(head, body);
    this.places[side].append(section);
    this.resizes.observe(section);
    const button = iconButton(definition.icon, title, definition.compact ? '' : title);
    button.title = key ? `${hint} (${key.toUpperCase()})` : hint;
    button.classList.toggle('narrow-only', definition.narrowOnly ?? false);
    button.setAttribute('aria-expanded', 'false');
    button.setAttribute('aria-controls', id);
    button.onclick = () => this.toggle(id);
    this.places.buttons.append(button);
    this.panels.set(id, { definition, section, body, button, content: undefined, loading: false });
  }

  get definitions(): readonly PanelDefinition[] {
    return [...this.panels.values()].map(({ definition }) => definition);
  }
  get isNarrow(): boolean {
    return this.narrow.matches;
  }
  isOpen(id: string): boolean {
    return this.open_.includes(id);
  }
  get openIds(): readonly string[] {
    return this.open_;
  }

  toggle(id: string): void {
    if (this.isOpen(id)) this.close(id);
    else this.open(id);
  }

  open(id: string): void {
    const panel = this.panels.get(id);
    if (!panel || this.isOpen(id)) return;
    if (this.narrow.matches) this.closeOthers(id);
    panel.section.hidden = false;
    panel.button.setAttribute('aria-expanded', 'true');
    this.open_.push(id);
    void this.show(panel);
  }

  private async show(panel: Panel): Promise<void> {
    if (!panel.content) {
      if (panel.loading) return;
      panel.loading = true;
      panel.body.textContent = 'Loading …';
      const content = document.createElement('div');
      try {
        panel.content = await panel.definition.load(content);
        panel.body.replaceChildren(content);
      } catch {
        panel.body.textContent = 'This panel could not be loaded. Close it and open it again.';
        return;
      } finally {
        panel.loading = false;
      }
    }
    if (this.isOpen(panel.definition.id)) panel.content.opened?.();
  }

  close(id: string): void {
    const panel = this.panels.get(id);
    const at = this.open_.indexOf(id);
    if (!panel || at < 0) return;
    this.open_.splice(at, 1);
    const focused = panel.section.contains(document.activeElement);
    panel.section.hidden = true;
    panel.button.setAttribute('aria-expanded', 'false');
    if (focused) panel.button.focus();
    panel.content?.closed?.();
  }

  /** Closes the panel that was opened last; returns whether there was one. */
  closeNewest(): boolean {
    const id = this.open_.at(-1);
    if (id === undefined) return false;
    this.close(id);
    return true;
  }

  private closeOthers(id: string): void {
    for (const other of [...this.open_]) if (other !== id) this.close(other);
  }

  /** Call once per rendered frame. */
  update(): void {
    for (const id of this.open_) this.panels.get(id)!.content?.update?.();
  }
}
