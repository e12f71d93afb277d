// Which worlds there are: join, make from a scene, delete. Talks JSON to /api/worlds.

import { withToken } from '../token';

interface WorldInfo {
  id: string;
  name: string;
  scene: string;
  bodies: number;
  awake: number;
  clients: number;
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
    let answer: { message?: string } = {};
    try {
      answer = JSON.parse(text) as typeof answer;
    } catch {
      answer = { message: text };
    }
    if (!response.ok) throw new Error(answer.message || `the server answered ${response.status}`);
    return answer;
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
    for (const world of worlds) this.panel.append(this.worldRow(world));
    this.panel.append(element('h2', 'New world from a scene'));
    for (const scene of scenes) {
      const row = element('button', '', 'scene');
      row.type = 'button';
      row.append(element('strong', scene.name), element('span', scene.description));
      row.onclick = () => this.run(() => this.create(scene.name, worlds));
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

  private async create(scene: string, worlds: WorldInfo[]): Promise<void> {
    // The scene's own name, or the first number that is free.
    const taken = new Set(worlds.map((world) => world.name));
    let name = scene;
    for (let n = 2; taken.has(name); n++) name = `${scene}-${n}`;
    const answer = (await this.ask('api/worlds', {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify({ name, sceneName: scene }),
    })) as { world: WorldInfo };
    this.panel.hidden = true;
    this.join(answer.world.id);
  }
}
