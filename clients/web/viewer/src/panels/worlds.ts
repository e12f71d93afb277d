// Which worlds there are: join, make from a scene or from what another one was a while ago, delete. Talks JSON to
// /api/worlds.

import { withToken } from '@jostle/client';

interface WorldInfo {
  id: string;
  name: string;
  scene: string;
  bodies: number;
  awake: number;
  clients: number;
  hz: number;
  tick: number;
  oldestRestorableTick: number; // 0: it ends with its process
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
  const made = document.createElement(tag);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

export class WorldsPanel {
  constructor(
    private readonly panel: HTMLElement,
    private readonly join: (world: string) => void,
    private readonly say: (text: string) => void,
    private readonly current: () => string,
    private readonly token = '',
  ) {}

  async toggle(): Promise<void> {
    if (this.panel.hidden) await this.show();
    else this.panel.hidden = true;
  }

  async show(): Promise<void> {
    this.panel.hidden = false;
    await this.refresh();
  }

  private async ask(path: string, init?: RequestInit): Promise<unknown> {
    const headers = withToken(this.token, init?.headers as Record<string, string> | undefined);
    const response = await fetch(path, { ...init, headers }).catch(() => {
      throw new Error('the server does not answer');
    });
    const text = await response.text();
    let payload: { message?: string } = {};
    try {
      payload = JSON.parse(text) as typeof payload;
    } catch {
      payload = { message: text };
    }
    if (!response.ok) throw new Error(payload.message || `the server answers ${response.status}`);
    return payload;
  }

  private async run(action: () => Promise<void>): Promise<void> {
    try {
      await action();
    } catch (error) {
      this.say(error instanceof Error ? error.message : String(error));
    }
  }

  private refresh(): Promise<void> {
    return this.run(async () => this.draw((await this.ask('api/worlds')) as Listing));
  }

  private draw({ worlds, scenes }: Listing): void {
    this.panel.replaceChildren(element('h2', 'Worlds'));
    for (const world of worlds) {
      this.panel.append(this.worldRow(world));
      if (world.oldestRestorableTick > 0) this.panel.append(this.restoreRow(world, worlds));
    }
    this.panel.append(element('h2', 'New world from a scene'));
    for (const scene of scenes) {
      const row = element('button', '', 'scene');
      row.type = 'button';
      row.append(element('strong', scene.name), element('span', scene.description));
      row.onclick = () => this.run(() => this.create(scene.name, { sceneName: scene.name }, worlds));
      this.panel.append(row);
    }
  }

  private worldRow(world: WorldInfo): HTMLElement {
    const row = element('div', '', 'world');
    const here = world.id === this.current();
    const about = `${world.bodies} bodies, ${world.awake} awake, ${world.clients} playing`;
    row.append(element('strong', world.name + (here ? ' (here)' : '')), element('span', about));
    const join = element('button', 'Join');
    join.type = 'button';
    join.disabled = here;
    join.onclick = () => {
      this.panel.hidden = true;
      this.join(world.id);
    };
    const remove = element('button', 'Delete', 'danger');
    remove.type = 'button';
    remove.onclick = () => {
      // A second click confirms: everyone in the world is thrown out.
      if (remove.textContent === 'Delete') {
        remove.textContent = 'Really?';
        setTimeout(() => (remove.textContent = 'Delete'), 3000);
        return;
      }
      void this.run(async () => {
        await this.ask(`api/worlds/${encodeURIComponent(world.id)}`, { method: 'DELETE' });
        await this.refresh();
      });
    };
    row.append(join, remove);
    return row;
  }

  /** What if: a slider over the ticks that are kept, and a button that opens one as a world of its own. */
  private restoreRow(world: WorldInfo, worlds: WorldInfo[]): HTMLElement {
    const row = element('div', '', 'past');
    // What nobody did anything in is kept a second later.
    const newest = Math.max(world.oldestRestorableTick, world.tick - Math.ceil(world.hz));
    const slider = element('input');
    Object.assign(slider, { type: 'range', min: String(world.oldestRestorableTick), max: String(newest), value: String(newest) });
    slider.setAttribute('aria-label', `Tick of ${world.name}`);
    const words = element('output');
    const open = element('button', 'What if');
    open.type = 'button';
    open.title = 'Opens this moment as a world of its own';
    open.onclick = () => {
      const tick = Number(slider.value);
      const checkpoint = { world: world.id, tick };
      void this.run(() => this.create(`${world.name}-at-${tick}`, { checkpoint }, worlds));
    };
    const tell = () => {
      const ago = (world.tick - Number(slider.value)) / world.hz;
      words.textContent = `tick ${slider.value}, ${ago.toFixed(1)} s ago`;
    };
    slider.oninput = tell;
    tell();
    row.append(slider, words, open);
    return row;
  }

  /** Of that name, or with the first number that is free. */
  private async create(wanted: string, source: object, worlds: WorldInfo[]): Promise<void> {
    const taken = new Set(worlds.map((world) => world.name));
    let name = wanted;
    for (let n = 2; taken.has(name); n++) name = `${wanted}-${n}`;
    const payload = (await this.ask('api/worlds', {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify({ name, ...source }),
    })) as { world: WorldInfo };
    this.panel.hidden = true;
    this.join(payload.world.id);
  }
}
