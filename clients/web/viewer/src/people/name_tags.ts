// Names of the other players over the view, at their cursors or the entities that they control. They are
// decoration for the eye: the player list has the same names for screen readers.

import { colorText } from './identity';

const TAGS_MAX = 40;
const MARGIN = 4; // pixels from the border of the page

export interface Tag {
  readonly client: number;
  readonly name: string;
  readonly color: number;
  readonly x: number; // pixels, of the tag's lower center
  readonly y: number;
}

interface Shown {
  readonly element: HTMLElement;
  readonly label: HTMLElement;
  name: string;
  color: number;
}

export class NameTags {
  private readonly shown = new Map<number, Shown>();

  constructor(private readonly layer: HTMLElement) {}

  /** Call once per rendered frame. */
  update(tags: readonly Tag[]): void {
    const visible = tags.slice(0, TAGS_MAX);
    const clients = new Set(visible.map(({ client }) => client));
    for (const [client, { element }] of this.shown) {
      if (clients.has(client)) continue;
      element.remove();
      this.shown.delete(client);
    }
    for (const tag of visible) this.place(tag);
  }

  private place({ client, name, color, x, y }: Tag): void {
    let shown = this.shown.get(client);
    if (!shown) {
      const element = document.createElement('span');
      const label = document.createElement('bdi');
      element.append(label);
      shown = { element, label, name: '', color: -1 };
      this.layer.append(element);
      this.shown.set(client, shown);
    }
    if (shown.name !== name) shown.label.textContent = shown.name = name;
    if (shown.color !== color) shown.element.style.setProperty('--player', colorText((shown.color = color)));
    const half = shown.element.offsetWidth / 2 + MARGIN;
    const left = Math.min(Math.max(x, half), innerWidth - half);
    shown.element.style.transform = `translate(${left.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -100%)`;
  }
}
