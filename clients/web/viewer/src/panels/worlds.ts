// Lists the worlds: join, create from a scene or from an earlier tick of a world, delete. Uses the JSON
// API at /api/worlds.

import { withToken } from '@jostle/client';
import { counted } from './describe_events';

interface WorldInfo {
  id: string;
  name: string;
  scene: string;
  bodies: number;
  awake: number;
  clients: number;
  hz: number;
  tick: number;
  oldestRestorableTick: number; // 0: the world is not persisted
}
interface Listing {
  worlds: WorldInfo[];
  scenes: { name: string; description: string }[];
}

function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  text = '',
  className = '',
): HTMLElementTagNameMap[K] {
  const created = document.createElement(tag);
  created.textContent = text;
  if (className) created.className = className;
  return created;
}

export class WorldsPanel {
  constructor(
    private readonly content: HTMLElement,
    private readonly close: () => void,
    private readonly join: (world: string) => void,
    private readonly showMessage: (text: string) => void,
    private readonly current: () => string,
    private readonly token = '',
  ) {}

  opened(): void {
    void this.refresh();
  }

  private async call(path: string, init?: RequestInit): Promise<unknown> {
    const headers = withToken(this.token, init?.headers as Record<string, string> | undefined);
    const response = await fetch(path, { ...init, headers }).catch(() => {
      throw new Error('the server does not respond');
    });
    const text = await response.text();
    let payload: { message?: string } = {};
    try {
      payload = JSON.parse(text) as typeof payload;
    } catch {
      payload = { message: text };
    }
    if (!response.ok) throw new Error(payload.message || `the server responded with HTTP status ${response.status}`);
    return payload;
  }

  private async run(action: () => Promise<void>): Promise<void> {
    try {
      await action();
    } catch (error) {
      this.showMessage(error instanceof Error ? error.message : String(error));
    }
  }

  private refresh(): Promise<void> {
    return this.run(async () => this.render((await this.call('api/worlds')) as Listing));
  }

  private render({ worlds, scenes }: Listing): void {
    this.content.replaceChildren();
    for (const world of worlds) {
      this.content.append(this.worldRow(world));
      if (world.oldestRestorableTick > 0) this.content.append(this.restoreRow(world, worlds));
    }
    this.content.append(element('h3', 'New world from a scene'));
    for (const scene of scenes) {
      const row = element('button', '', 'scene');
      row.type = 'button';
      row.append(element('strong', scene.name), element('span', scene.description));
      row.onclick = () => this.run(() => this.create(scene.name, { sceneName: scene.name }, worlds));
      this.content.append(row);
    }
  }

  private worldRow(world: WorldInfo): HTMLElement {
    const row = element('div', '', 'world');
    const isCurrent = world.id === this.current();
    const about = `${world.bodies} bodies, ${world.awake} awake, ${counted(world.clients, 'client', 'clients')}`;
    row.append(element('strong', world.name + (isCurrent ? ' (current)' : '')), element('span', about));
    const join = element('button', 'Join');
    join.type = 'button';
    join.disabled = isCurrent;
    join.onclick = () => {
      this.close();
      this.join(world.id);
    };
    const remove = element('button', 'Delete', 'danger');
    remove.type = 'button';
    remove.onclick = () => {
      // A second click confirms, because all clients of the world are disconnected.
      if (remove.textContent === 'Delete') {
        remove.textContent = 'Confirm';
        setTimeout(() => (remove.textContent = 'Delete'), 3000);
        return;
      }
      void this.run(async () => {
        await this.call(`api/worlds/${encodeURIComponent(world.id)}`, { method: 'DELETE' });
        await this.refresh();
      });
    };
    row.append(join, remove);
    return row;
  }

  /** A slider over the restorable ticks, and a button that creates a world from the selected tick. */
  private restoreRow(world: WorldInfo, worlds: WorldInfo[]): HTMLElement {
    const row = element('div', '', 'restore');
    // A tick without inputs is stored up to 1 s later.
    const newest = Math.max(world.oldestRestorableTick, world.tick - Math.ceil(world.hz));
    const slider = element('input');
    Object.assign(slider, { type: 'range', min: String(world.oldestRestorableTick), max: String(newest), value: String(newest) });
    slider.setAttribute('aria-label', `Tick of ${world.name}`);
    const label = element('output');
    const open = element('button', 'Restore copy');
    open.type = 'button';
    open.title = 'Create a new world from this tick';
    open.onclick = () => {
      const tick = Number(slider.value);
      const checkpoint = { world: world.id, tick };
      void this.run(() => this.create(`${world.name}-at-${tick}`, { checkpoint }, worlds));
    };
    const updateLabel = () => {
      const ago = (world.tick - Number(slider.value)) / world.hz;
      label.textContent = `tick ${slider.value}, ${ago.toFixed(1)} s ago`;
    };
    slider.oninput = updateLabel;
    updateLabel();
    row.append(slider, label, open);
    return row;
  }

  /** With the given name, or with the first free number appended. */
  private async create(baseName: string, source: object, worlds: WorldInfo[]): Promise<void> {
    const usedNames = new Set(worlds.map((world) => world.name));
    let name = baseName;
    for (let n = 2; usedNames.has(name); n++) name = `${baseName}-${n}`;
    const payload = (await this.call('api/worlds', {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify({ name, ...source }),
    })) as { world: WorldInfo };
    this.close();
    this.join(payload.world.id);
  }
}
