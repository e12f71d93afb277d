// Connects what concerns the other players: list, chat, notices, cursors, name tags and following. main.ts
// forwards the callbacks of the connection and calls update() once per rendered frame.
//
// Messages between viewers use the topics "chat" (UTF-8 text), "cursor" (cursors.ts) and "report" (JSON).
// Two attributes of a player tell the others its color, if it changed, and the entity that it controls.

import type { Connection, Input } from '@jostle/client';
import type { WorldData } from '@jostle/client';
import { InputCode, PlayerEventKind, PlayerRole, type InputResult, type Player, type PlayerEvent, type UserMessage } from '@jostle/client/gen/play_pb';
import * as THREE from 'three';
import type { Camera } from '../camera/camera';
import type { Grab } from '../interaction/tools';
import type { RoomRules } from '../room/room_rules';
import type { SceneView } from '../scene/scene_view';
import type { Solids } from '../scene/solids';
import type { ContextMenu, MenuItem } from '../ui/context_menu';
import type { Panels } from '../ui/panels';
import { ChatLog } from './chat_log';
import { CURSOR_TOPIC, CursorSender, drawCursor, RemoteCursors, type Point, type ShownCursor } from './cursors';
import { Feed } from './feed';
import { isColor, loadIdentity, PLAYER_COLORS, storeIdentity, type Identity } from './identity';
import { MessageBudget } from './message_budget';
import { NameTags, type Tag } from './name_tags';
import { ACTION_LABELS, actionsFor, type PlayerAction } from './player_actions';
import type { ListedPlayer, PlayersPanel } from './players_panel';
import { cleanName, cleanText, messageText } from './text';
import { JoinCodes, linkToWorld, searchWithWorld, takeJoinCode } from './world_address';
import './people.css';

export const TOPICS = ['chat', CURSOR_TOPIC, 'report'] as const;

const COLOR_KEY = 'color';
const CONTROLS_KEY = 'controls'; // entity
const MUTE_SECONDS = 300;
/** Labels and seconds; 0: until it is removed. */
const BANS = [['For 1 hour', 3600], ['For 24 hours', 86_400], ['Until it is removed', 0]] as const;
const CURSOR_INPUTS_MAX = 16;
const CURSOR_PAUSE_MS = 10_000; // after a refusal that waiting does not cure, such as a mute
const CHAT_RETRY_MS = 5000; // a refused message is sent again for this long
const TAG_LIFT = 0.35; // m above a cursor
const FOLLOW_DISTANCE = 12; // m
const FOLLOW_RATE = 6; // 1/s
const REPORT_REASONS = ['Spam', 'Insults', 'Disruptive play', 'Offensive name'] as const;

export interface PeopleOptions {
  readonly connection: () => Connection;
  readonly view: SceneView;
  readonly camera: Camera;
  readonly panels: Panels;
  readonly contextMenu: ContextMenu;
  readonly token: string;
  /** What this client may do in the room. */
  rules(): RoomRules;
  /** What the user grabs and controls. */
  grab(): Grab | undefined;
  controlled(): number;
  /** A recording is played. */
  isRecorded(): boolean;
  join(world: string, joinCode: string): void;
  /** A problem, for the user. */
  showProblem(text: string): void;
}

interface OutgoingChat {
  readonly text: string;
  readonly untilMs: number;
}

const element = (tag: string, id: string, parent: Element, before: Element | null = null) => {
  const created = document.createElement(tag);
  created.id = id;
  parent.insertBefore(created, before);
  return created;
};

export class People {
  readonly log = new ChatLog();
  readonly joinCodes = new JoinCodes(sessionStorage);
  identity: Identity = loadIdentity(localStorage);
  private readonly budget = new MessageBudget();
  private readonly cursors = new RemoteCursors();
  private readonly sender = new CursorSender(this.budget, (data) => {
    this.cursorInputs.push(this.sendMessage(CURSOR_TOPIC, data));
    if (this.cursorInputs.length > CURSOR_INPUTS_MAX) this.cursorInputs.shift();
  });
  private readonly cursorInputs: number[] = []; // sequences of the newest ones
  private readonly tags: NameTags;
  private readonly chip: HTMLElement;
  private readonly chipText = document.createElement('span');
  private outgoing: OutgoingChat[] = []; // waiting for the budget
  private readonly awaiting = new Map<number, OutgoingChat>(); // by input sequence
  private shownCursors: ShownCursor[] = [];
  private hovered: Point | undefined;
  private following = 0; // client; 0: none
  private followedTo: THREE.Vector3 | undefined;
  private controls = 0; // entity that the others know
  private worldId = '';
  private world = ''; // name
  private playersPanel: PlayersPanel | undefined;
  private readonly lastNames = new Map<number, string>(); // before the events of a snapshot
  private announces = false; // joins of others are news
  private replacesAddress = true; // the next world replaces the address instead of adding to the history

  constructor(private readonly options: PeopleOptions) {
    const main = document.querySelector('main')!;
    const bottom = document.getElementById('bottom')!;
    const layer = element('div', 'tags', main);
    layer.setAttribute('aria-hidden', 'true');
    this.tags = new NameTags(layer);
    new Feed(element('div', 'feed', bottom, bottom.firstElementChild), this.log);
    this.chip = element('section', 'following', bottom, document.getElementById('driver'));
    this.chip.setAttribute('aria-label', 'Followed player');
    this.chip.hidden = true;
    const stop = document.createElement('button');
    stop.type = 'button';
    stop.textContent = 'Stop';
    stop.onclick = () => this.stopFollowing();
    this.chip.append(this.chipText, stop);
    this.log.listen(() => this.showCounts());
    addEventListener('popstate', () => {
      const world = new URLSearchParams(location.search).get('world') ?? '';
      if (world === this.world) return;
      this.replacesAddress = true;
      this.options.join(world, this.joinCodes.get(world));
    });
    // The others see at once that the user left, not after the resume timeout.
    addEventListener('pagehide', () => this.connection.stop());
    addEventListener('pageshow', ({ persisted }) => {
      if (persisted) this.options.join(this.world, this.joinCodes.get(this.world));
    });
    const { visualViewport } = window;
    visualViewport?.addEventListener('resize', () =>
      document.documentElement.style.setProperty('--keyboard', `${Math.max(0, Math.round(innerHeight - visualViewport.height))}px`),
    );
  }

  private get connection(): Connection {
    return this.options.connection();
  }
  private get client(): number {
    return this.connection.welcome?.clientId ?? 0;
  }
  private get data(): WorldData {
    return this.connection.data;
  }

  /** The options of the connection. */
  get connectionOptions() {
    return { name: this.identity.name, color: this.identity.color, players: true, attributes: true, room: true, topics: TOPICS };
  }

  /** The join code for the world of the page's address. */
  initialJoinCode(world: string): string {
    const replaceHash = (hash: string) => history.replaceState(null, '', location.pathname + location.search + (hash && `#${hash}`));
    const code = takeJoinCode({ hash: location.hash, replaceHash });
    if (code) this.joinCodes.set(world, code);
    return this.joinCodes.get(world);
  }

  // --- callbacks of the connection

  /** The connection is established or the world changed. */
  playing(): void {
    const { welcome } = this.connection;
    if (!welcome || this.options.isRecorded()) return;
    const changed = welcome.worldId !== this.worldId;
    if (changed) this.enterWorld(welcome.worldId, welcome.worldName || welcome.worldId);
    this.announces = false;
    this.outgoing.push(...this.awaiting.values());
    this.awaiting.clear();
    this.controls = 0;
    this.cursorInputs.length = 0;
    this.sender.resend();
  }

  private enterWorld(id: string, name: string): void {
    this.worldId = id;
    this.world = name;
    this.log.clear();
    this.cursors.clear();
    this.lastNames.clear();
    this.outgoing = [];
    this.awaiting.clear();
    this.stopFollowing();
    const address = location.pathname + searchWithWorld(location.search, name);
    const named = new URLSearchParams(location.search).get('world') === name;
    if (!named) history[this.replacesAddress ? 'replaceState' : 'pushState'](null, '', address);
    this.replacesAddress = false;
    document.title = `${name} – Jostle`;
  }

  private showRoomTitle(): void {
    const title = cleanText(this.data.room?.settings?.title ?? '', 64) || this.world;
    if (title && document.title !== `${title} – Jostle`) document.title = `${title} – Jostle`;
  }

  dataChanged(): void {
    this.playersPanel?.invalidate();
    this.showCounts();
    this.showRoomTitle();
    this.lastNames.clear();
    for (const player of this.data.players.values()) this.lastNames.set(player.client, this.nameOf(player));
    // The first list contains those that were there before.
    if (this.data.players.has(this.client)) this.announces = true;
  }

  playerEvent({ kind, player }: PlayerEvent): void {
    if (!player || player.client === this.client || this.options.isRecorded()) return;
    const name = this.nameOf(player);
    switch (kind) {
      case PlayerEventKind.JOINED:
        this.sender.resend();
        return this.notice(`${name} joined`);
      case PlayerEventKind.LEFT:
        this.cursors.remove(player.client);
        if (this.following === player.client) this.stopFollowing();
        return this.notice(`${name} left`);
      case PlayerEventKind.DISCONNECTED:
        this.cursors.remove(player.client);
        return this.notice(`${name} lost the connection`);
      case PlayerEventKind.RESUMED:
        return this.notice(`${name} is back`);
      case PlayerEventKind.RENAMED:
        return this.notice(`${this.lastNames.get(player.client) ?? 'A player'} is now ${name}`);
    }
  }

  message({ from, topic, data, direct }: UserMessage): void {
    if (this.options.isRecorded()) return;
    if (topic === CURSOR_TOPIC) {
      if (from !== this.client && from !== 0) this.cursors.receive(from, data, performance.now());
      return;
    }
    const text = messageText(data);
    if (!text) return;
    if (topic === 'report') return direct ? this.receiveReport(from, text) : undefined;
    if (topic !== 'chat') return;
    const player = this.data.players.get(from);
    const name = from === 0 ? 'Server' : player ? this.nameOf(player) : 'A player that left';
    this.log.add({ kind: 'message', from, name, color: this.colorOf(from, player), text, own: from === this.client, timeMs: Date.now() });
  }

  /** Returns true if the result concerns a message of this class. */
  rejected(result: InputResult): boolean {
    const chat = this.awaiting.get(result.sequence);
    const now = performance.now();
    // A mute is a limit as well, which takes longer.
    const limited = result.code === InputCode.LIMIT && result.retryAfterMs <= CHAT_RETRY_MS;
    const isCursor = this.cursorInputs.includes(result.sequence);
    if ((chat || isCursor) && limited) this.budget.close(now, result.retryAfterMs || 1000);
    else if (isCursor) this.sender.pause(now + CURSOR_PAUSE_MS);
    if (!chat) return isCursor;
    this.awaiting.delete(result.sequence);
    if (limited && now < chat.untilMs) this.outgoing.unshift(chat);
    else this.addRefused(chat.text, result.message);
    return true;
  }

  private addRefused(text: string, refused: string): void {
    const { name, color } = this.identity;
    this.log.add({ kind: 'message', from: this.client, name, color, text, own: true, timeMs: Date.now(), refused });
  }

  // --- users

  nameOfClient(client: number): string {
    const player = this.data.players.get(client);
    return player ? this.nameOf(player) : `Player ${client}`;
  }

  private nameOf(player: Pick<Player, 'name' | 'client'>): string {
    return cleanName(player.name) || `Player ${player.client}`;
  }

  /** 0xRRGGBB */
  private colorOf(client: number, player = this.data.players.get(client)): number {
    const changed = Number(this.data.value({ kind: 'player', id: client }, COLOR_KEY) ?? -1);
    if (isColor(changed)) return changed;
    return isColor(player?.color) ? player.color : PLAYER_COLORS[client % PLAYER_COLORS.length]!;
  }

  private get others(): number {
    return [...this.data.players.values()].filter(({ client, disconnected }) => client !== this.client && !disconnected).length;
  }

  listed(): ListedPlayer[] {
    return [...this.data.players.values()].map((player) => ({
      client: player.client,
      name: this.nameOf(player),
      color: this.colorOf(player.client, player),
      role: player.role,
      pingMs: player.pingMs,
      disconnected: player.disconnected,
      own: player.client === this.client,
      hidden: this.log.isHidden(player.client),
      followed: player.client === this.following,
    }));
  }

  saveIdentity(identity: Identity): void {
    const recolored = identity.color !== this.identity.color;
    this.identity = identity;
    storeIdentity(localStorage, identity);
    this.connection.setIdentity(identity.name, identity.color);
    if (recolored) this.setAttribute(COLOR_KEY, identity.color);
  }

  /** 0 removes the attribute, except for colors. */
  private setAttribute(key: string, value: number): void {
    const removed = key !== COLOR_KEY && value === 0;
    const attribute = { key, value: removed ? { case: undefined } : { case: 'integer' as const, value: BigInt(value) } };
    this.send({ case: 'setAttributes', value: { set: { target: { case: 'player', value: this.client }, attributes: [attribute] } } });
  }

  private send(kind: NonNullable<Input['kind']>): number {
    return this.options.isRecorded() ? 0 : this.connection.send({ kind });
  }
  private sendMessage(topic: string, data: Uint8Array<ArrayBuffer>, to: number[] = [], toServer = false): number {
    return this.send({ case: 'sendMessage', value: { topic, data, to, toServer } });
  }

  // --- chat

  private notice(text: string): void {
    if (this.announces) this.log.add({ kind: 'notice', from: 0, name: '', color: 0, text, own: false, timeMs: Date.now() });
  }
  /** Shows and announces a line that concerns only this user. */
  private confirm(text: string): void {
    this.log.add({ kind: 'notice', from: 0, name: '', color: 0, text, own: false, timeMs: Date.now() });
  }

  say(text: string): void {
    const cleaned = cleanText(text, 300);
    if (!cleaned) return;
    if (this.connection.state !== 'playing') return this.addRefused(cleaned, 'you are not connected');
    this.outgoing.push({ text: cleaned, untilMs: performance.now() + CHAT_RETRY_MS });
    this.sendChat(performance.now());
  }

  private sendChat(nowMs: number): void {
    while (this.outgoing.length > 0 && this.connection.state === 'playing' && this.budget.take(nowMs, 0)) {
      const chat = this.outgoing.shift()!;
      const sequence = this.sendMessage('chat', new TextEncoder().encode(chat.text));
      this.awaiting.set(sequence, chat);
      if (this.awaiting.size > 64) this.awaiting.delete(this.awaiting.keys().next().value!);
    }
  }

  private report(client: number, reason: string): void {
    const player = this.data.players.get(client);
    if (!player) return;
    const messages = this.log.newestOf(client, 3).map(({ text }) => cleanText(text, 100));
    const data = new TextEncoder().encode(JSON.stringify({ client, name: this.nameOf(player), reason, messages }));
    this.sendMessage('report', data, [], true);
    const moderators = [...this.data.players.values()].filter(({ client: id, role, disconnected }) => role >= PlayerRole.BUILDER && id !== client && id !== this.client && !disconnected);
    if (moderators.length > 0) this.sendMessage('report', data, moderators.slice(0, 16).map(({ client: id }) => id));
    const recipients = moderators.length > 0 ? 'the server and the moderators in this world' : 'the server';
    this.confirm(`You reported ${this.nameOf(player)} to ${recipients}`);
  }

  private receiveReport(from: number, text: string): void {
    try {
      const { client, reason } = JSON.parse(text) as { client?: unknown; reason?: unknown };
      const reported = this.data.players.get(Number(client));
      const reporter = this.data.players.get(from);
      if (!reported || !reporter || typeof reason !== 'string') return;
      this.confirm(`${this.nameOf(reporter)} reports ${this.nameOf(reported)}: ${cleanText(reason, 60)}`);
    } catch {
      // Another client may send anything.
    }
  }

  // --- actions

  openMenu(client: number, at: HTMLElement): void {
    const player = this.data.players.get(client);
    if (!player) return this.options.showProblem('this player left');
    const { left, bottom } = at.getBoundingClientRect();
    const hidden = this.log.isHidden(client);
    const ownRole = this.data.players.get(this.client)?.role ?? PlayerRole.SPECTATOR;
    const actions = actionsFor({ rules: this.options.rules(), ownRole, role: player.role, hidden });
    const items = actions.map(({ action, refusal }) => ({ label: ACTION_LABELS[action], refusal, run: () => this.act(action, player, left, bottom) }));
    this.options.contextMenu.open(this.nameOf(player), items, left, bottom + 4);
  }

  private act(action: PlayerAction, player: Player, x: number, y: number): void {
    const { client } = player;
    const name = this.nameOf(player);
    const ask = (title: string, items: MenuItem[]) => this.options.contextMenu.open(title, [...items, { label: 'Cancel', run: () => {} }], x, y + 4);
    switch (action) {
      case 'follow':
        return this.follow(client);
      case 'hide':
      case 'show':
        this.log.setHidden(client, action === 'hide');
        this.playersPanel?.invalidate();
        return this.confirm(action === 'hide' ? `You no longer see messages of ${name}` : `You see messages of ${name} again`);
      case 'report':
        return ask(`Report ${name}`, REPORT_REASONS.map((label) => ({ label, run: () => this.report(client, label) })));
      case 'vote':
        return this.room_({ case: 'voteKick', value: { client } });
      case 'mute':
        return this.room_({ case: 'mute', value: { client, seconds: MUTE_SECONDS } });
      case 'unmute':
        return this.room_({ case: 'mute', value: { client, seconds: 0 } });
      case 'clean_up':
        return this.room_({ case: 'cleanUp', value: { client } });
      case 'kick':
        return this.room_({ case: 'kick', value: { client, reason: '' } });
      case 'ban':
        return ask(`Ban ${name}`, BANS.map(([label, seconds]) => ({ label, run: () => this.room_({ case: 'ban', value: { client, seconds, reason: '' } }) })));
      case 'player':
        return this.room_({ case: 'setRole', value: { client, role: PlayerRole.PLAYER } });
      case 'builder':
        return this.room_({ case: 'setRole', value: { client, role: PlayerRole.BUILDER } });
      case 'owner':
        return ask(`${name} becomes the owner`, [{ label: 'Transfer the room', run: () => this.room_({ case: 'setRole', value: { client, role: PlayerRole.OWNER } }) }]);
    }
  }

  private room_(kind: NonNullable<Extract<NonNullable<Input['kind']>, { case: 'room' }>['value']>['kind']): void {
    this.send({ case: 'room', value: { kind: kind! } });
  }

  // --- following

  follow(client: number): void {
    const player = this.data.players.get(client);
    if (!player || client === this.client) return;
    this.following = client;
    this.followedTo = undefined;
    this.chip.hidden = false;
    this.playersPanel?.invalidate();
  }

  /** Returns whether a player was followed. */
  stopFollowing(): boolean {
    if (this.following === 0) return false;
    this.following = 0;
    this.chip.hidden = true;
    this.playersPanel?.invalidate();
    return true;
  }

  get followed(): number {
    return this.following;
  }

  /** The point of the world at which a player is; undefined: unknown. */
  private anchorOf(client: number): THREE.Vector3 | undefined {
    const entity = Number(this.data.value({ kind: 'player', id: client }, CONTROLS_KEY) ?? 0);
    const pose = entity > 0 ? this.options.view.poseOf(entity) : undefined;
    if (pose) return new THREE.Vector3(pose[0], pose[1], pose[2]);
    const cursor = this.shownCursors.find((shown) => shown.client === client);
    return cursor && new THREE.Vector3(cursor.position.x, cursor.position.y, cursor.position.z);
  }

  private updateFollowing(seconds: number): void {
    if (this.following === 0) return;
    const player = this.data.players.get(this.following);
    if (!player || this.options.controlled() !== 0) return void this.stopFollowing();
    const anchor = this.anchorOf(this.following);
    const text = anchor ? `Following ${this.nameOf(player)}` : `Waiting until ${this.nameOf(player)} moves`;
    if (this.chipText.textContent !== text) this.chipText.textContent = text;
    if (!anchor) return;
    const { camera } = this.options;
    if (!this.followedTo) {
      this.followedTo = camera.controls.target.clone();
      camera.startApproach(FOLLOW_DISTANCE);
    }
    this.followedTo.lerp(anchor, 1 - Math.exp(-FOLLOW_RATE * seconds));
    camera.follow(this.followedTo.toArray(), undefined, seconds);
  }

  // --- rendering

  /** The body under the pointer, or undefined. */
  hover(point: Point | undefined): void {
    this.hovered = point && { x: point.x, y: point.y, z: point.z };
  }

  /** Call once per rendered frame, after the poses were updated. */
  update(seconds: number): void {
    const now = performance.now();
    if (this.options.isRecorded()) {
      this.shownCursors = [];
      return this.tags.update([]);
    }
    if (this.connection.state === 'playing') {
      const grab = this.options.grab();
      this.sendChat(now);
      this.sender.update(now, this.others, grab?.target ?? this.hovered, grab);
      const controlled = this.options.controlled();
      if (controlled !== this.controls) this.setAttribute(CONTROLS_KEY, (this.controls = controlled));
    }
    this.shownCursors = this.cursors.shown(now).filter(({ client }) => this.data.players.has(client) && !this.log.isHidden(client));
    this.updateFollowing(seconds);
    this.tags.update(this.tagsToShow());
  }

  /** Draws the cursors and grabs of the others. */
  draw(solids: Solids, poseOf: (entity: number) => ArrayLike<number> | undefined): void {
    for (const cursor of this.shownCursors) drawCursor(solids, cursor, this.colorOf(cursor.client), poseOf, this.options.camera.distance);
  }

  private tagsToShow(): Tag[] {
    const tags: (Tag & { depth: number })[] = [];
    const { camera } = this.options.camera;
    for (const player of this.data.players.values()) {
      if (player.client === this.client || this.log.isHidden(player.client)) continue;
      const anchor = this.anchorOf(player.client);
      if (!anchor) continue;
      const controlled = Number(this.data.value({ kind: 'player', id: player.client }, CONTROLS_KEY) ?? 0);
      anchor.y += controlled > 0 ? this.heightOf(controlled) : TAG_LIFT * Math.max(0.2, this.options.camera.distance / 10);
      const { x, y, z } = anchor.project(camera);
      if (z > 1 || Math.abs(x) > 1 || Math.abs(y) > 1) continue;
      tags.push({ client: player.client, name: this.nameOf(player), color: this.colorOf(player.client, player), x: ((x + 1) / 2) * innerWidth, y: ((1 - y) / 2) * innerHeight, depth: z });
    }
    return tags.sort((a, b) => a.depth - b.depth);
  }

  /** m from the center of an entity to its top, and a little more. */
  private heightOf(entity: number): number {
    const box = this.options.view.boxOf(entity);
    return box.isEmpty() ? 1 : (box.max.y - box.min.y) / 2 + 0.3;
  }

  // --- panels

  registerPanels(): void {
    const { panels } = this.options;
    panels.register({
      id: 'players',
      title: 'Players',
      hint: 'Names, roles and latency; follow, mute and report',
      key: 'p',
      icon: 'players',
      side: 'right',
      load: async (content) => {
        const loaded = await import('./players_panel');
        this.playersPanel = new loaded.PlayersPanel(content, () => this.listed(), () => this.data.room !== undefined, (client, at) => this.openMenu(client, at), () => panels.open('identity'));
        return this.playersPanel;
      },
    });
    panels.register({
      id: 'chat',
      title: 'Chat',
      hint: 'Messages to everybody in this world',
      key: 'c',
      icon: 'chat',
      side: 'left',
      load: async (content) => {
        const { chatPanel } = await import('./chat_panel');
        const leave = () => document.getElementById('view')!.focus();
        return chatPanel(content, { log: this.log, send: (text) => this.say(text), leave, openMenu: (client, at) => this.openMenu(client, at) });
      },
    });
    panels.register({
      id: 'share',
      title: 'Invite',
      hint: 'Link and QR code of this world',
      key: 'i',
      icon: 'share',
      side: 'left',
      load: async (content) => {
        const { sharePanel } = await import('./share_panel');
        const joinCode = () => this.joinCodes.get(this.world);
        return sharePanel(content, { link: (withCode) => linkToWorld(location, this.world, withCode ? joinCode() : ''), joinCode, title: () => document.title });
      },
    });
    panels.register({
      id: 'identity',
      title: 'Your name',
      hint: 'Name and color that the others see',
      key: 'n',
      icon: 'edit',
      side: 'left',
      load: async (content) => {
        const { identityPanel } = await import('./identity_panel');
        return identityPanel(content, () => this.identity, (identity) => this.saveIdentity(identity), () => panels.close('identity'));
      },
    });
  }

  /** At the first visit, the user is asked for a name. */
  askForName(): void {
    if (!this.identity.chosen) this.options.panels.open('identity');
  }

  /** Numbers of players and unread messages on the buttons. */
  private showCounts(): void {
    this.badge('players', this.data.players.size > 1 ? this.data.players.size : 0, 'players');
    this.badge('chat', this.log.unread, 'unread');
  }
  private badge(panel: string, count: number, what: string): void {
    for (const button of document.querySelectorAll<HTMLElement>(`#panel-buttons [aria-controls=${panel}]`)) {
      const title = panel === 'chat' ? 'Chat' : 'Players';
      button.setAttribute('aria-label', count > 0 ? `${title}, ${count} ${what}` : title);
      if (count > 0) button.dataset['count'] = count > 99 ? '99+' : String(count);
      else delete button.dataset['count'];
    }
  }

  /** For browser tests. */
  inspect() {
    const { world, shownCursors, following, identity } = this;
    return { world, following, identity, cursorMessagesSent: this.sender.sent, cursors: shownCursors.map(({ client, position, grab }) => ({ client, position, grab: grab?.entity })), lines: this.log.lines.map(({ kind, name, text, refused }) => ({ kind, name, text, refused })) };
  }
}
