// Toggles of the debug view. While a toggle needs solver data, the server is queried five times per
// second.

import { islandTints, type DebugView, type DebugOptions } from '../scene/debug_view';
import type { DebugResponse } from '@jostle/client/gen/query_pb';
import { Throttle } from '../interaction/throttle';
import type { Queries } from '@jostle/client';
import type { SceneView } from '../scene/scene_view';

const QUERY_INTERVAL_MS = 200;
const MISSED_RESPONSES_MAX = 2;

const NOTHING_SHOWN = 'Choose what the view shows of the solver.';

type Toggle = keyof DebugOptions | 'sleep' | 'fields';
const LOCAL_TOGGLES: readonly Toggle[] = ['sleep', 'fields']; // shown from snapshots and channels, without queries
const TOGGLES: { toggle: Toggle; label: string; hint: string }[] = [
  { toggle: 'contacts', label: 'Contacts', hint: 'Points and normals: red touching, blue near; longer means a larger impulse' },
  { toggle: 'islands', label: 'Islands', hint: 'One color per island' },
  { toggle: 'sleep', label: 'Sleep', hint: 'Sleeping bodies are blue' },
  { toggle: 'bounds', label: 'Bounds', hint: 'Bounding box of each shape' },
  { toggle: 'joints', label: 'Joints', hint: 'Lines from each body to its anchor' },
  { toggle: 'fields', label: 'Fields', hint: 'Wind as arrows, attractors as rings' },
  { toggle: 'broadPhase', label: 'Broad phase', hint: 'Grid cells or tree nodes' },
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
  private missedResponses = 0;
  private readonly note = document.createElement('p');
  private readonly throttle = new Throttle(QUERY_INTERVAL_MS, () => this.query());

  constructor(
    content: HTMLElement,
    private readonly queries: Queries,
    private readonly lines: DebugView,
    private readonly view: SceneView,
  ) {
    content.append(...TOGGLES.map(({ toggle, label, hint }) => this.row(toggle, label, hint)), this.note);
    this.note.className = 'note';
    this.note.textContent = NOTHING_SHOWN;
  }

  private row(toggle: Toggle, label: string, hint: string): HTMLElement {
    const row = document.createElement('label');
    row.title = hint;
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.name = toggle;
    box.onchange = () => {
      this.on[toggle] = box.checked;
      box.blur(); // keys select tools again
      this.toggled();
    };
    row.append(box, label);
    return row;
  }

  private get needsServer(): boolean {
    return TOGGLES.some(({ toggle }) => !LOCAL_TOGGLES.includes(toggle) && this.on[toggle]);
  }

  private toggled(): void {
    this.view.markAsleep(this.on.sleep); // snapshots have the sleep state
    if (!this.on.islands) this.view.setTints(undefined);
    if (!this.needsServer) {
      this.lines.clear();
      this.note.textContent = Object.values(this.on).some((on) => on) ? '' : NOTHING_SHOWN;
    }
  }

  /** Call once per rendered frame. */
  update(): void {
    if (this.needsServer) this.throttle.request();
  }

  private async query(): Promise<void> {
    if (!this.needsServer) return;
    const { contacts, islands, bounds, joints, broadPhase } = this.on;
    const response = await this.queries.debug({ contacts, islands, bounds, joints, broadPhase });
    // Toggles may have changed during the query.
    if (!this.needsServer) return;
    // A single missing response must not make the lines flicker.
    this.missedResponses = response ? 0 : this.missedResponses + 1;
    if (!response) {
      if (this.missedResponses < MISSED_RESPONSES_MAX) return;
      this.lines.clear();
      this.view.setTints(undefined);
      this.note.textContent = 'The server did not respond.';
      return;
    }
    this.lines.show(response, this.on, (entity) => this.view.dynamicPoseOf(entity));
    if (this.on.islands) this.view.setTints(islandTints(response.islands));
    this.note.textContent = summary(response, this.on);
  }
}

export function summary(response: DebugResponse, on: DebugOptions): string {
  const counts: string[] = [];
  const count = (enabled: boolean, n: number, one: string, many: string) => {
    if (enabled) counts.push(`${n} ${n === 1 ? one : many}`);
  };
  count(on.contacts, response.contacts.length, 'contact', 'contacts');
  count(on.islands, response.islands.length, 'island', 'islands');
  count(on.bounds, response.bounds.length, 'box', 'boxes');
  count(on.joints, response.joints.length, 'joint', 'joints');
  count(on.broadPhase, response.broadPhase.length, 'cell', 'cells');
  return counts.join(', ') + (response.truncated ? '; truncated' : '');
}
