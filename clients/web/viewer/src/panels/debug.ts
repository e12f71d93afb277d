// Toggles of the debug view. The server is asked five times a second while something is on that it has to tell, else never.

import { islandTints, type DebugView, type DebugOptions } from '../scene/debug_view';
import type { DebugResponse } from '@jostle/client/gen/query_pb';
import { Throttle } from '../interaction/throttle';
import type { Queries } from '@jostle/client';
import type { SceneView } from '../scene/scene_view';

const EVERY_MS = 200;
const MISSES = 2;

type Toggle = keyof DebugOptions | 'sleep' | 'fields';
const LOCAL_TOGGLES: readonly Toggle[] = ['sleep', 'fields']; // snapshots tell
const TOGGLES: { toggle: Toggle; label: string; hint: string }[] = [
  { toggle: 'contacts', label: 'Contacts', hint: 'Points and normals: red presses, blue is near; the longer, the harder' },
  { toggle: 'islands', label: 'Islands', hint: 'Bodies that hang together have one colour' },
  { toggle: 'sleep', label: 'Sleep', hint: 'Bodies that sleep are blue' },
  { toggle: 'bounds', label: 'Bounds', hint: 'The box around each shape' },
  { toggle: 'joints', label: 'Joints', hint: 'From body to anchor to body' },
  { toggle: 'fields', label: 'Fields', hint: 'Wind as arrows, rings round what attracts' },
  { toggle: 'broadPhase', label: 'Broad phase', hint: 'Cells, or branches of the tree' },
];

export class DebugPanel {
  readonly on: Record<Toggle, boolean> = {
    contacts: false,
    islands: false,
    sleep: false,
    bounds: false,
    joints: false,
    broadPhase: false,
    fields: false,
  };
  private missed = 0;
  private readonly note = document.createElement('p');
  private readonly throttle = new Throttle(EVERY_MS, () => this.ask());

  constructor(
    panel: HTMLElement,
    private readonly queries: Queries,
    private readonly lines: DebugView,
    private readonly view: SceneView,
  ) {
    const title = document.createElement('h2');
    title.textContent = 'Debug view';
    panel.append(title, ...TOGGLES.map(({ toggle, label, hint }) => this.row(toggle, label, hint)), this.note);
    this.note.className = 'note';
  }

  private row(toggle: Toggle, label: string, hint: string): HTMLElement {
    const row = document.createElement('label');
    row.title = hint;
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.name = toggle;
    box.onchange = () => {
      this.on[toggle] = box.checked;
      box.blur(); // keys go on meaning tools
      this.toggled();
    };
    row.append(box, label);
    return row;
  }

  private get asksServer(): boolean {
    return TOGGLES.some(({ toggle }) => !LOCAL_TOGGLES.includes(toggle) && this.on[toggle]);
  }

  private toggled(): void {
    this.view.markAsleep(this.on.sleep); // snapshots say who sleeps
    if (!this.on.islands) this.view.setTints(undefined);
    if (!this.asksServer) {
      this.lines.clear();
      this.note.textContent = '';
    }
  }

  /** Once a picture. */
  update(): void {
    if (this.asksServer) this.throttle.request();
  }

  private async ask(): Promise<void> {
    if (!this.asksServer) return;
    const { contacts, islands, bounds, joints, broadPhase } = this.on;
    const response = await this.queries.debug({ contacts, islands, bounds, joints, broadPhase });
    // Toggles may have changed in the meantime.
    if (!this.asksServer) return;
    // One answer that came too late is no reason to make the lines flicker.
    this.missed = response ? 0 : this.missed + 1;
    if (!response) {
      if (this.missed < MISSES) return;
      this.lines.clear();
      this.view.setTints(undefined);
      this.note.textContent = 'The server does not tell.';
      return;
    }
    this.lines.show(response, this.on, (entity) => this.view.loosePoseOf(entity));
    if (this.on.islands) this.view.setTints(islandTints(response.islands));
    this.note.textContent = summary(response, this.on);
  }
}

export function summary(response: DebugResponse, on: DebugOptions): string {
  const counts: string[] = [];
  const count = (wished: boolean, n: number, one: string, many: string) => {
    if (wished) counts.push(`${n} ${n === 1 ? one : many}`);
  };
  count(on.contacts, response.contacts.length, 'contact', 'contacts');
  count(on.islands, response.islands.length, 'island', 'islands');
  count(on.bounds, response.bounds.length, 'box', 'boxes');
  count(on.joints, response.joints.length, 'joint', 'joints');
  count(on.broadPhase, response.broadPhase.length, 'cell', 'cells');
  return counts.join(', ') + (response.truncated ? '; there are more than are shown' : '');
}
