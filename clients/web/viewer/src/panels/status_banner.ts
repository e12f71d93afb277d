// A banner above the scene while the world is paused or slow or the connection is lost, and for a short
// time after it is resumed: what happened, what the user can do, and a button for it.

import { withToken, type ConnectionState } from '@jostle/client';
import type { WorldStats } from '@jostle/client/gen/play_pb';

const BEHIND_BELOW = 0.95; // time scale
const TIME_SCALE_MS = 5000; // over which the server measures the time scale
const BY_MEMBER = 'by '; // begins the cause of a pause by a member of the room
const RESUMED_MS = 5000; // how long the banner of a resumed connection is shown

export type BannerAction = 'resume' | 'reconnect' | 'worlds';
export interface Banner {
  readonly kind: 'paused' | 'slow' | 'disconnected' | 'stopped' | 'resumed';
  readonly text: string;
  readonly advice: string;
  readonly action?: BannerAction;
}

/** What the banner depends on. */
export interface WorldStatus {
  readonly connection: ConnectionState;
  readonly reason: string; // of the connection state
  readonly hasPlayed: boolean; // the world was joined before
  readonly stats: Pick<WorldStats, 'paused' | 'timeScale'> | undefined;
  readonly mayResume: boolean; // the user may resume a paused world
  readonly reconnected: 'session' | 'new client' | undefined; // a short time ago
}

const sentence = (text: string) => {
  const first = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?…]$/.test(first) ? first : `${first}.`;
};

/**
 * The share of the speed that the members of a room chose, which is no overload. `settled`: the speed has not changed
 * while the time scale was measured.
 */
export function shareOfSpeed(timeScale: number, speedPercent: number, settled: boolean): number {
  if (!settled) return 1;
  return speedPercent > 0 && speedPercent < 100 ? Math.min(1, timeScale / (speedPercent / 100)) : timeScale;
}

/** undefined: the world runs. */
export function bannerOf({ connection, reason, hasPlayed, stats, mayResume, reconnected }: WorldStatus): Banner | undefined {
  if (connection === 'stopped') {
    return reason ? { kind: 'stopped', text: sentence(reason), advice: 'Choose a world to join.', action: 'worlds' } : undefined;
  }
  if (connection === 'waiting')
    return { kind: 'disconnected', text: sentence(reason || 'the connection was lost'), advice: 'The viewer tries again automatically. Check your network if this takes longer.', action: 'reconnect' };
  if (connection === 'connecting')
    return hasPlayed ? { kind: 'disconnected', text: 'Reconnecting …', advice: 'The world is shown as it was when the connection was lost.' } : undefined;
  if (stats?.paused.startsWith(BY_MEMBER))
    return { kind: 'paused', text: sentence(`This world is paused ${stats.paused}`), advice: 'Members who may pause it can resume and step it in the panel Time.' };
  if (stats?.paused) {
    const text = `This world is paused: ${stats.paused}`;
    return mayResume
      ? { kind: 'paused', text: sentence(text), advice: 'Resume it when the cause is fixed.', action: 'resume' }
      : { kind: 'paused', text: sentence(text), advice: 'An operator can resume it. You can join another world meanwhile.', action: 'worlds' };
  }
  // Servers before version 0.1.0 do not send the time scale.
  if (stats && stats.timeScale > 0 && stats.timeScale < BEHIND_BELOW) {
    const percent = Math.round(100 * stats.timeScale);
    return { kind: 'slow', text: `The server is overloaded: this world runs at ${percent} % of its speed.`, advice: 'Delete bodies that you spawned, or join another world.', action: 'worlds' };
  }
  if (reconnected === 'session') return { kind: 'resumed', text: 'Connected again.', advice: 'Your session and your bodies were resumed.' };
  if (reconnected === 'new client') return { kind: 'resumed', text: 'Connected again as a new client.', advice: 'The session had expired: take control of your entity again.' };
  return undefined;
}

const ACTION_LABELS: Record<BannerAction, string> = { resume: 'Resume', reconnect: 'Reconnect now', worlds: 'Worlds' };

export interface StatusBannerOptions {
  readonly element: HTMLElement;
  readonly world: () => string;
  readonly token: string;
  showMessage(text: string): void;
  reconnect(): void;
  openWorlds(): void;
  /** Called when the size of the banner changed. */
  onChange(): void;
}

export class StatusBanner {
  private readonly text = document.createElement('strong');
  private readonly advice = document.createElement('span');
  private readonly button = document.createElement('button');
  private status: WorldStatus = { connection: 'stopped', reason: '', hasPlayed: false, stats: undefined, mayResume: false, reconnected: undefined };
  private asked = ''; // the world whose permission was requested during this pause
  private speedPercent: number | undefined; // undefined: no statistics yet
  private speedChangedMs = -Infinity;
  private shown: Banner | undefined;

  constructor(private readonly options: StatusBannerOptions) {
    this.button.type = 'button';
    this.button.onclick = () => this.act();
    const words = document.createElement('div');
    words.append(this.text, ' ', this.advice);
    options.element.append(words, this.button);
    options.element.hidden = true;
  }

  setConnection(connection: ConnectionState, reason: string): void {
    this.update({ connection, reason, stats: connection === 'playing' ? this.status.stats : undefined });
  }

  /** The connection was established again. */
  setReconnected(reconnected: 'session' | 'new client'): void {
    this.update({ reconnected });
    setTimeout(() => this.update({ reconnected: undefined }), RESUMED_MS);
  }

  /** The user joins a world; the previous one no longer counts. */
  begin(): void {
    this.update({ hasPlayed: false, reconnected: undefined, stats: undefined });
  }
  setPlayed(): void {
    this.update({ hasPlayed: true });
  }

  /** Called with each statistics message; undefined: a recording is played. */
  setStats(stats: Pick<WorldStats, 'paused' | 'timeScale' | 'speedPercent'> | undefined): void {
    if (!stats?.paused) this.asked = '';
    else if (this.asked !== this.options.world()) {
      this.asked = this.options.world();
      void this.request('GET').then((mayResume) => this.update({ mayResume }));
    }
    if (!stats) return this.update({ stats });
    const { paused, timeScale, speedPercent } = stats;
    const now = performance.now();
    if (this.speedPercent !== undefined && speedPercent !== this.speedPercent) this.speedChangedMs = now;
    this.speedPercent = speedPercent;
    this.update({ stats: { paused, timeScale: shareOfSpeed(timeScale, speedPercent, now - this.speedChangedMs > TIME_SCALE_MS + 500) } });
  }

  private update(change: Partial<WorldStatus>): void {
    this.status = { ...this.status, ...change };
    const banner = bannerOf(this.status);
    if (banner?.text === this.shown?.text && banner?.advice === this.shown?.advice && banner?.action === this.shown?.action) return;
    this.shown = banner;
    const { element } = this.options;
    element.hidden = banner === undefined;
    if (banner) {
      element.dataset['kind'] = banner.kind;
      this.text.textContent = banner.text;
      this.advice.textContent = banner.advice;
      this.button.hidden = banner.action === undefined;
      this.button.textContent = banner.action ? ACTION_LABELS[banner.action] : '';
    }
    this.options.onChange();
  }

  private act(): void {
    switch (this.shown?.action) {
      case 'resume':
        return void this.resume();
      case 'reconnect':
        return this.options.reconnect();
      case 'worlds':
        return this.options.openWorlds();
    }
  }

  private async resume(): Promise<void> {
    if (!(await this.request('POST'))) this.options.showMessage('the server did not resume the world');
  }

  private async request(method: 'GET' | 'POST'): Promise<boolean> {
    const path = `api/worlds/${encodeURIComponent(this.options.world())}/resume`;
    const response = await fetch(path, { method, headers: withToken(this.options.token) }).catch(() => undefined);
    return response?.ok ?? false;
  }
}
