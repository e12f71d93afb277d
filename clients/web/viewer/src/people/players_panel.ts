// The list of players: color, name, role and ping, and a menu for each.

import type { PanelContent } from '../ui/panels';
import { iconButton } from '../ui/icons';
import { colorText } from './identity';
import { ROLE_NAMES } from './player_actions';
import type { PlayerRole } from '@jostle/client/gen/play_pb';

export interface ListedPlayer {
  readonly client: number;
  readonly name: string;
  readonly color: number;
  readonly role: PlayerRole;
  readonly pingMs: number; // 0: unknown
  readonly disconnected: boolean;
  readonly own: boolean;
  readonly hidden: boolean; // muted by the user
  readonly followed: boolean;
}

/** Own first, then by role and name. */
export function sortPlayers(players: readonly ListedPlayer[]): ListedPlayer[] {
  return [...players].sort((a, b) => Number(b.own) - Number(a.own) || b.role - a.role || a.name.localeCompare(b.name) || a.client - b.client);
}

/** Everything but the name, as one line. */
export function describePlayer({ role, pingMs, disconnected, own, hidden, followed }: ListedPlayer, showRole: boolean): string {
  const parts = [own ? 'you' : '', showRole ? (ROLE_NAMES[role] ?? '') : '', disconnected ? 'connection lost' : pingMs > 0 ? `${pingMs} ms` : '', hidden ? 'muted' : '', followed ? 'followed' : ''];
  return parts.filter((part) => part !== '').join(' · ');
}

interface Row {
  readonly element: HTMLElement;
  readonly name: HTMLElement;
  readonly about: HTMLElement;
  readonly menu: HTMLButtonElement;
}

export class PlayersPanel implements PanelContent {
  private readonly list = document.createElement('ul');
  private readonly rows = new Map<number, Row>();
  private changed = true;

  constructor(
    content: HTMLElement,
    private readonly players: () => ListedPlayer[],
    private readonly isRoom: () => boolean,
    private readonly openMenu: (client: number, at: HTMLElement) => void,
    private readonly editSelf: () => void,
  ) {
    this.list.className = 'players';
    content.append(this.list);
  }

  opened(): void {
    this.changed = true;
  }
  invalidate(): void {
    this.changed = true;
  }

  /** Call once per rendered frame. Rows stay, so that a focused button keeps the focus. */
  update(): void {
    if (!this.changed) return;
    this.changed = false;
    const players = sortPlayers(this.players());
    const clients = new Set(players.map(({ client }) => client));
    for (const [client, { element }] of this.rows) {
      if (clients.has(client)) continue;
      element.remove();
      this.rows.delete(client);
    }
    let before: Element | null = this.list.firstElementChild;
    for (const player of players) {
      const row = this.rowOf(player);
      this.fill(row, player);
      if (row.element === before) before = before.nextElementSibling;
      else this.list.insertBefore(row.element, before);
    }
  }

  private rowOf(player: ListedPlayer): Row {
    const known = this.rows.get(player.client);
    if (known) return known;
    const element = document.createElement('li');
    const name = document.createElement('bdi');
    name.className = 'name';
    const about = document.createElement('span');
    about.className = 'about';
    const menu = iconButton(player.own ? 'edit' : 'more', '');
    menu.onclick = () => (player.own ? this.editSelf() : this.openMenu(player.client, menu));
    element.append(name, about, menu);
    const row = { element, name, about, menu };
    this.rows.set(player.client, row);
    return row;
  }

  private fill({ element, name, about, menu }: Row, player: ListedPlayer): void {
    element.style.setProperty('--player', colorText(player.color));
    element.classList.toggle('disconnected', player.disconnected);
    if (name.textContent !== player.name) name.textContent = player.name;
    const text = describePlayer(player, this.isRoom());
    if (about.textContent !== text) about.textContent = text;
    menu.setAttribute('aria-label', player.own ? 'Change your name and color' : `Actions for ${player.name}`);
  }
}
