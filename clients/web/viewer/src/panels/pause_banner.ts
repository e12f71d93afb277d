// A banner above the scene while the world is paused or falls behind, with the reason, and with a
// button for users who may resume the world.

import { withToken } from '@jostle/client';
import type { WorldStats } from '@jostle/client/gen/play_pb';

const BEHIND_BELOW = 0.95; // time scale

/** The text of the banner; empty: the world keeps its rate. */
export function bannerText(stats: Pick<WorldStats, 'paused' | 'timeScale'>): string {
  if (stats.paused) return `This world is paused: ${stats.paused}`;
  // Servers before version 0.1.0 do not send the time scale.
  if (stats.timeScale <= 0 || stats.timeScale >= BEHIND_BELOW) return '';
  return `The server is overloaded: this world runs at ${Math.round(100 * stats.timeScale)} % of its speed`;
}

export class PauseBanner {
  private readonly text = document.createElement('span');
  private readonly button = document.createElement('button');
  private asked = ''; // the world whose permission was requested during this pause

  constructor(
    private readonly box: HTMLElement,
    private readonly world: () => string,
    private readonly showMessage: (text: string) => void,
    private readonly token: string,
  ) {
    this.button.type = 'button';
    this.button.textContent = 'Resume';
    this.button.hidden = true;
    this.button.onclick = () => void this.resume();
    box.append(this.text, this.button);
    box.hidden = true;
  }

  /** Called with each statistics message; undefined: no world is joined. */
  update(stats: Pick<WorldStats, 'paused' | 'timeScale'> | undefined): void {
    const text = stats ? bannerText(stats) : '';
    this.box.hidden = text === '';
    if (this.text.textContent !== text) this.text.textContent = text;
    if (!stats?.paused) {
      this.button.hidden = true;
      this.asked = '';
    } else if (this.asked !== this.world()) {
      this.asked = this.world();
      void this.request('GET').then((allowed) => (this.button.hidden = !allowed));
    }
  }

  private async resume(): Promise<void> {
    this.button.hidden = true;
    if (!(await this.request('POST'))) this.showMessage('the server did not resume the world');
  }

  private async request(method: 'GET' | 'POST'): Promise<boolean> {
    const path = `api/worlds/${encodeURIComponent(this.world())}/resume`;
    const response = await fetch(path, { method, headers: withToken(this.token) }).catch(() => undefined);
    return response?.ok ?? false;
  }
}
