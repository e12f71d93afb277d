// Plots of the selected body or joint and of the world over the last 20 s.

import { POSE_FLOATS, type Connection } from '@jostle/client';
import type { InspectResponse } from '@jostle/client/gen/query_pb';
import type { WorldStats } from '@jostle/client/gen/play_pb';
import { LinePlot } from './line_plot';
import type { Selected } from './selection';
import { seriesToCsv, TimeSeries } from './time_series';

const SECONDS = 20; // of the time axis
const HISTORY_SECONDS = 60; // in CSV files
const DRAW_INTERVAL_MS = 100;
const SPEED_INTERVAL_S = 0.1; // of positions, if the server sends no velocities

interface Source {
  readonly series: TimeSeries;
  readonly group: 'body' | 'joint' | 'world';
}

const source = (group: Source['group'], name: string, unit: string): Source => ({ group, series: new TimeSeries(name, unit, HISTORY_SECONDS) });

export interface PlotsOptions {
  readonly connection: Connection;
  /** Saves a file. */
  save(name: string, text: string): void;
}

export class PlotsPanel {
  private readonly sources = {
    height: source('body', 'Height', 'm'),
    speed: source('body', 'Speed', 'm/s'),
    energy: source('body', 'Kinetic energy', 'J'),
    contact: source('body', 'Contact force', 'N'),
    force: source('joint', 'Joint force', 'N'),
    torque: source('joint', 'Joint torque', 'N m'),
    coordinate: source('joint', 'Coordinate', 'rad or m'),
    step: source('world', 'Step', 'ms'),
    contacts: source('world', 'Contacts', ''),
    awake: source('world', 'Awake bodies', ''),
  };
  private readonly note = document.createElement('p');
  private readonly plots = document.createElement('div');
  private shown: LinePlot[] = [];
  private selected: Selected | undefined;
  private lastDrawMs = 0;
  private lastFrame = 0;
  private inspected = false; // the server sends velocities
  private lastPose: { seconds: number; x: number; y: number; z: number } | undefined;

  constructor(
    content: HTMLElement,
    private readonly options: PlotsOptions,
  ) {
    content.className = 'plots-panel';
    this.note.className = 'note';
    const csv = document.createElement('button');
    csv.type = 'button';
    csv.textContent = 'Save CSV';
    csv.title = 'Saves the last 60 s of the plotted values';
    csv.onclick = () => this.options.save('jostle-plots.csv', this.csv());
    content.append(this.note, this.plots, csv);
    this.select(undefined);
  }

  select(selected: Selected | undefined): void {
    this.selected = selected;
    this.lastPose = undefined;
    this.inspected = false;
    for (const { group, series } of Object.values(this.sources)) if (group !== 'world') series.clear();
    const groups = [selected?.kind, 'world'];
    this.shown = Object.values(this.sources)
      .filter(({ group }) => groups.includes(group))
      .map(({ series }) => new LinePlot(series, SECONDS, (cursor) => this.setCursor(cursor)));
    this.plots.replaceChildren(...this.shown.map(({ element }) => element));
    this.note.hidden = selected !== undefined;
    this.note.textContent = selected ? '' : 'Select a body or a joint to plot its motion and forces.';
  }

  csv(): string {
    return seriesToCsv(this.shown.map(({ series }) => series));
  }

  private setCursor(cursor: number | undefined): void {
    for (const plot of this.shown) plot.setCursor(cursor);
    this.lastDrawMs = 0;
  }

  private secondsOf(tick: number): number {
    return tick / (this.options.connection.welcome?.tickHz || 60);
  }

  addStats(stats: WorldStats): void {
    const seconds = this.secondsOf(stats.tick);
    this.sources.step.series.add(seconds, stats.stepMsMean);
    this.sources.contacts.series.add(seconds, stats.contacts);
    this.sources.awake.series.add(seconds, stats.awake);
  }

  addInspection({ tick, body, joint }: InspectResponse): void {
    const seconds = this.secondsOf(tick);
    const { sources } = this;
    if (body && this.selected?.kind === 'body') {
      const hz = this.options.connection.welcome?.tickHz || 60;
      const impulse = body.contacts.flatMap(({ points }) => points).reduce((sum, point) => sum + point.impulse, 0);
      this.inspected = true;
      const v = body.linearVelocity;
      sources.speed.series.add(seconds, Math.hypot(v?.x ?? 0, v?.y ?? 0, v?.z ?? 0));
      sources.energy.series.add(seconds, body.kineticEnergy);
      sources.contact.series.add(seconds, impulse * hz);
    }
    if (joint && this.selected?.kind === 'joint') {
      sources.force.series.add(seconds, joint.force);
      sources.torque.series.add(seconds, joint.torque);
      sources.coordinate.series.add(seconds, joint.coordinate);
    }
  }

  /** Adds the newest received position of the selected body, which is newer than the rendered one. */
  private addPose(): void {
    const { newest } = this.options.connection.frames;
    const { selected } = this;
    if (!newest || newest.frame === this.lastFrame || selected?.kind !== 'body') return;
    this.lastFrame = newest.frame;
    const index = newest.entities.findIndex(({ id }) => id === selected.id);
    if (index < 0) return;
    const [x, y, z] = newest.poses.subarray(index * POSE_FLOATS, index * POSE_FLOATS + 3) as unknown as [number, number, number];
    const seconds = this.secondsOf(newest.frame);
    this.sources.height.series.add(seconds, y);
    // Rounded positions give no usable speed over a single tick.
    const elapsed = seconds - (this.lastPose?.seconds ?? -Infinity);
    if (elapsed >= 0 && elapsed < SPEED_INTERVAL_S) return;
    if (this.lastPose && !this.inspected && elapsed < 1)
      this.sources.speed.series.add(seconds, Math.hypot(x - this.lastPose.x, y - this.lastPose.y, z - this.lastPose.z) / elapsed);
    this.lastPose = { seconds, x, y, z };
  }

  update(): void {
    this.addPose();
    const now = performance.now();
    if (now - this.lastDrawMs < DRAW_INTERVAL_MS) return;
    this.lastDrawMs = now;
    const seconds = this.secondsOf(this.options.connection.frames.newest?.frame ?? 0);
    for (const plot of this.shown) plot.draw(seconds);
  }
}
