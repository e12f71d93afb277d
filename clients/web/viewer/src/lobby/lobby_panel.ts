// The lobby: the worlds of the server as cards, and new worlds from room templates, scenes of the
// catalogue, scene files, and earlier ticks of a world.
//
// The thumbnails of the catalogue scenes are files (thumbnails/NAME.webp), written once by
// `npm run thumbnails`: drawing them in the browser would load and simulate each scene for one small image.

import { counted } from '../panels/describe_events';
import { cleanText } from '../people/text';
import type { ContextMenu } from '../ui/context_menu';
import { iconButton } from '../ui/icons';
import type { PanelContent } from '../ui/panels';
import { excerpt, freeName, nameOfFile, parseProblems } from './scene_problems';
import { ApiError, type Listing, type SceneInfo, type ServerApi, type WorldInfo } from './server_api';
import { button, element } from '../ui/elements';

const FILE_BYTES_MAX = 32 << 20; // as the server's setting scene.request_bytes_max
const PROBLEMS_MAX = 20;
const REFRESH_MS = 5000; // while the lobby is open

export interface LobbyOptions {
  readonly content: HTMLElement;
  readonly api: ServerApi;
  readonly contextMenu: ContextMenu;
  close(): void;
  join(world: string, name: string, joinCode: string): void;
  joinCodeOf(name: string): string;
  /** Id of the current world. */
  current(): string;
  showProblem(text: string): void;
}

/** Text of another user, with its own direction. */
function userText(tag: 'strong' | 'span', text: string, charactersMax: number, className = ''): HTMLElement {
  const created = element(tag, cleanText(text, charactersMax), className);
  created.dir = 'auto';
  return created;
}

const THUMBNAIL_NAME = /^[a-z0-9_]{1,64}$/;

/** The thumbnail of a catalogue scene; other scenes have a mark instead. */
export function thumbnail(scene: string): HTMLElement {
  const frame = element('span', '', 'thumbnail');
  if (!THUMBNAIL_NAME.test(scene)) return frame;
  const image = element('img');
  image.alt = '';
  image.loading = 'lazy';
  image.decoding = 'async';
  image.src = `thumbnails/${scene}.webp`;
  image.onerror = () => image.remove();
  frame.append(image);
  return frame;
}

/** Players and bodies of a world, as one line. */
export function aboutWorld({ bodies, clients, paused, room }: WorldInfo): string {
  const people = room?.capacity ? `${clients} of ${counted(room.capacity, 'player', 'players')}` : counted(clients, 'player', 'players');
  const parts = [people, counted(bodies, 'body', 'bodies')];
  if (room?.isPrivate) parts.push('private');
  if (room?.capacity && clients >= room.capacity) parts.push('full');
  if (paused) parts.push('paused');
  // A line breaks between parts only.
  return parts.map((part) => part.replaceAll(' ', '\u00a0')).join(' · ');
}

/** Whether the text occurs in the name, the title, the description, the scene or a tag. */
export function matches({ name, scene, room }: WorldInfo, text: string): boolean {
  const wanted = text.trim().toLowerCase();
  return [name, scene, room?.title ?? '', room?.description ?? '', ...(room?.tags ?? [])].some((one) => one.toLowerCase().includes(wanted));
}

export class LobbyPanel implements PanelContent {
  private readonly problems = element('div', '', 'problems');
  private readonly worlds = element('div', '', 'worlds');
  private readonly sources = element('div');
  private readonly search = element('input');
  private readonly file = element('input');
  private listing: Listing = { worlds: [], scenes: [] };
  private listedSources = '';
  private refreshes: ReturnType<typeof setInterval> | undefined;

  constructor(private readonly options: LobbyOptions) {
    const { content } = options;
    content.className = 'lobby';
    Object.assign(this.search, { type: 'search', placeholder: 'Search worlds', autocomplete: 'off' });
    this.search.setAttribute('aria-label', 'Search worlds');
    this.search.oninput = () => this.renderWorlds();
    this.problems.setAttribute('role', 'alert');
    Object.assign(this.file, { type: 'file', accept: '.json,application/json', hidden: true });
    this.file.onchange = () => {
      const file = this.file.files?.[0];
      this.file.value = '';
      if (file) void this.upload(file);
    };
    const upload = button('Upload a scene file …', () => this.file.click(), 'upload');
    content.append(this.search, this.problems, this.worlds, upload, this.file, this.sources, this.joinByName());
  }

  opened(): void {
    void this.refresh();
    this.refreshes = setInterval(() => void this.refresh(), REFRESH_MS);
  }
  closed(): void {
    clearInterval(this.refreshes);
  }

  private async run(action: () => Promise<void>): Promise<void> {
    try {
      await action();
    } catch (error) {
      this.options.showProblem(error instanceof Error ? error.message : String(error));
    }
  }

  private refresh(): Promise<void> {
    return this.run(async () => {
      this.listing = await this.options.api.list();
      this.renderWorlds();
      this.renderSources();
    });
  }

  // --- worlds

  /** Cards that the user works with stay: a slider that moves, a code that is typed, a focused button. */
  private renderWorlds(): void {
    const shown = this.listing.worlds.filter((world) => matches(world, this.search.value));
    const before = new Map([...this.worlds.children].map((card) => [(card as HTMLElement).dataset['world'] ?? '', card as HTMLElement]));
    const cards = shown.map((world) => {
      const known = before.get(world.id);
      const version = `${world.id === this.options.current()} ${world.oldestRestorableTick > 0}`;
      if (!known || known.dataset['version'] !== version) return this.card(world, version);
      known.querySelector('.about')!.textContent = aboutWorld(world);
      return known;
    });
    const same = cards.length === this.worlds.childElementCount && cards.every((card, k) => this.worlds.children[k] === card);
    if (!same) this.worlds.replaceChildren(...cards);
    if (cards.length === 0) this.worlds.replaceChildren(element('p', this.search.value ? 'No world matches.' : 'The server has no worlds.', 'note'));
  }

  private card(world: WorldInfo, version: string): HTMLElement {
    const { room } = world;
    const card = element('article', '', 'card');
    card.dataset['world'] = world.id;
    card.dataset['version'] = version;
    const row = element('div', '', 'world');
    const isCurrent = world.id === this.options.current();
    const title = userText('strong', room?.title || world.name, 64);
    card.setAttribute('aria-label', cleanText(room?.title || world.name, 64));
    const words = element('div', '', 'words');
    words.append(title, element('span', aboutWorld(world), 'about'));
    if (room?.title && room.title !== world.name) words.append(userText('span', world.name, 64, 'dim'));
    if (room?.description) words.append(userText('span', room.description, 140, 'dim'));
    const join = button(isCurrent ? 'Joined' : 'Join', () => this.join(world, card), 'primary');
    join.disabled = isCurrent;
    const more = iconButton('more', `More about ${cleanText(room?.title || world.name, 64)}`);
    more.onclick = () => this.openMenu(world, more);
    row.append(thumbnail(world.scene), words, join, more);
    card.append(row);
    if (world.oldestRestorableTick > 0) card.append(this.restoreRow(world));
    return card;
  }

  private join(world: WorldInfo, card: HTMLElement): void {
    const known = this.options.joinCodeOf(world.name);
    if (world.room?.isPrivate && !known) return this.askForCode(world, card);
    this.enter(world.id, world.name, known);
  }

  private enter(world: string, name: string, joinCode = ''): void {
    this.options.close();
    this.options.join(world, name, joinCode);
  }

  private askForCode(world: WorldInfo, card: HTMLElement): void {
    card.querySelector('form')?.remove();
    const form = element('form', '', 'code');
    const field = element('input');
    Object.assign(field, { type: 'text', placeholder: 'Join code', autocomplete: 'off', maxLength: 64, required: true });
    field.setAttribute('aria-label', `Join code of ${cleanText(world.name, 64)}`);
    const submit = element('button', 'Join');
    submit.type = 'submit';
    form.append(field, submit);
    form.onsubmit = (event) => {
      event.preventDefault();
      this.enter(world.id, world.name, field.value);
    };
    card.append(form);
    field.focus();
  }

  private openMenu(world: WorldInfo, at: HTMLElement): void {
    const { left, bottom } = at.getBoundingClientRect();
    const open = (title: string, items: Parameters<ContextMenu['open']>[1]) => this.options.contextMenu.open(title, items, left, bottom + 4);
    open(cleanText(world.room?.title || world.name, 64), [
      { label: 'Download as a scene file', run: () => void this.download(world) },
      {
        label: 'Delete …',
        run: () =>
          open(`Delete ${cleanText(world.name, 64)}? All its players are disconnected.`, [
            { label: 'Delete', run: () => void this.run(() => this.options.api.delete(world.id).then(() => this.refresh())) },
            { label: 'Cancel', run: () => {} },
          ]),
      },
    ]);
  }

  /** A slider over the restorable ticks, and a button that creates a world from the selected tick. */
  private restoreRow(world: WorldInfo): HTMLElement {
    const row = element('div', '', 'restore');
    // A tick without inputs is stored up to 1 s later.
    const newest = Math.max(world.oldestRestorableTick, world.tick - Math.ceil(world.hz));
    const slider = element('input');
    Object.assign(slider, { type: 'range', min: String(world.oldestRestorableTick), max: String(newest), value: String(newest) });
    slider.setAttribute('aria-label', `Tick of ${cleanText(world.name, 64)}`);
    const label = element('output');
    const open = button('Restore copy', () => {
      const tick = Number(slider.value);
      void this.run(() => this.create(`${world.name}-at-${tick}`, { checkpoint: { world: world.id, tick } }));
    });
    open.title = 'Create a new world from this tick';
    const updateLabel = () => {
      const ago = (world.tick - Number(slider.value)) / world.hz;
      label.textContent = `tick ${slider.value}, ${ago.toFixed(1)} s ago`;
    };
    slider.oninput = updateLabel;
    updateLabel();
    row.append(slider, label, open);
    return row;
  }

  // --- new worlds

  private renderSources(): void {
    const { scenes, templates = [] } = this.listing;
    const version = JSON.stringify([scenes, templates]);
    if (version === this.listedSources) return;
    this.listedSources = version;
    this.sources.replaceChildren();
    if (templates.length > 0) this.sources.append(element('h3', 'New room'));
    for (const { name, scene, room } of templates)
      this.sources.append(this.sourceButton(scene, room?.title || name, room?.description ?? '', 'template', () => this.create(name, { roomTemplate: name })));
    const button = ({ name, description }: SceneInfo) => this.sourceButton(name, name, description, 'scene', () => this.create(name, { sceneName: name }));
    const isBenchmark = ({ name }: SceneInfo) => name.startsWith('bench_');
    this.sources.append(element('h3', 'New world from a scene'), ...scenes.filter((scene) => !isBenchmark(scene)).map(button));
    const benchmarks = scenes.filter(isBenchmark);
    if (benchmarks.length === 0) return;
    const more = element('details');
    more.append(element('summary', `Benchmark scenes (${benchmarks.length})`), ...benchmarks.map(button));
    this.sources.append(more);
  }

  private sourceButton(scene: string, title: string, description: string, className: string, create: () => Promise<void>): HTMLButtonElement {
    const row = button('', () => void this.run(create), className);
    const words = element('span', '', 'words');
    words.append(userText('strong', title, 64), userText('span', description, 200));
    row.append(thumbnail(scene), words);
    return row;
  }

  /** With the given name, or with the first free number appended. */
  private async create(baseName: string, source: object): Promise<void> {
    const { worlds } = await this.options.api.list();
    const world = await this.options.api.create(freeName(baseName, new Set(worlds.map(({ name }) => name))), source);
    this.enter(world.id, world.name);
  }

  /** For rooms that lists do not contain. */
  private joinByName(): HTMLElement {
    const details = element('details');
    const form = element('form', '', 'by-name');
    const field = (placeholder: string, required: boolean) => {
      const input = element('input');
      Object.assign(input, { type: 'text', placeholder, autocomplete: 'off', maxLength: 64, required });
      input.setAttribute('aria-label', placeholder);
      return input;
    };
    const name = field('Name of the world', true);
    const code = field('Join code, if it is private', false);
    const submit = element('button', 'Join');
    submit.type = 'submit';
    form.append(name, code, submit);
    form.onsubmit = (event) => {
      event.preventDefault();
      this.enter(name.value.trim(), name.value.trim(), code.value);
    };
    details.append(element('summary', 'Join a world by name'), form);
    return details;
  }

  // --- scene files

  /** Creates a world from a scene file and joins it, or shows the problems of the file. */
  async upload(file: File): Promise<void> {
    this.problems.replaceChildren();
    if (file.size > FILE_BYTES_MAX) return this.showProblems(file.name, '', `the file has ${(file.size / 1e6).toFixed(1)} MB; the server accepts at most ${(FILE_BYTES_MAX / 1e6).toFixed(1)} MB`);
    const text = await file.text();
    try {
      await this.create(nameOfFile(file.name), { sceneJson: text });
    } catch (error) {
      this.showProblems(file.name, text, error instanceof Error ? error.message : String(error), error instanceof ApiError && error.status === 400);
    }
  }

  private showProblems(name: string, text: string, message: string, isAboutFile = false): void {
    const problems = parseProblems(message).slice(0, PROBLEMS_MAX);
    const heading = element('h3', `${cleanText(name, 40)}: ${isAboutFile ? counted(problems.length, 'problem', 'problems') : 'not uploaded'}`);
    const list = element('ol');
    for (const problem of problems) {
      const item = element('li');
      const where = problem.line > 0 ? `Line ${problem.line}, column ${problem.column}: ` : '';
      const words = element('p');
      words.append(element('strong', where), cleanText(problem.text, 400));
      item.append(words);
      const lines = isAboutFile ? excerpt(text, problem) : [];
      if (lines.length > 0) {
        const code = element('pre');
        code.tabIndex = 0;
        code.setAttribute('role', 'group');
        code.setAttribute('aria-label', `Lines ${lines[0]!.number} to ${lines.at(-1)!.number} of the file`);
        for (const line of lines) {
          const row = element('span', '', line.isProblem ? 'at' : '');
          row.append(element('b', String(line.number)), line.text);
          code.append(row);
        }
        item.append(code);
      }
      list.append(item);
    }
    const dismiss = button('Dismiss', () => this.problems.replaceChildren());
    this.problems.replaceChildren(heading, list, dismiss);
    this.problems.scrollIntoView({ block: 'nearest' });
  }

  private download(world: WorldInfo): Promise<void> {
    return this.run(async () => {
      const { scene, omitted = [] } = await this.options.api.scene(world.id);
      const link = element('a');
      link.href = URL.createObjectURL(new Blob([JSON.stringify(scene ?? {}, null, 1)], { type: 'application/json' }));
      link.download = `${nameOfFile(world.name)}.json`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
      if (omitted.length > 0) this.options.showProblem(`the scene file omits: ${omitted.join(' ')}`);
    });
  }
}
