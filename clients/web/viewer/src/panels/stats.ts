// Statistics with a short history each, as small plots.

import type { Connection } from '@jostle/client';
import type { WorldStats } from '@jostle/client/gen/play_pb';
import { counted } from './describe_events';

const HISTORY = 120; // samples
const PLOT = { width: 150, height: 26 };

class Plot {
  readonly row = document.createElement('div');
  private readonly value = document.createElement('output');
  private readonly canvas = document.createElement('canvas');
  private readonly history: number[] = [];

  constructor(
    label: string,
    private readonly unit: string,
    color: string,
    private readonly digits = 0,
  ) {
    const name = document.createElement('span');
    name.textContent = label;
    this.canvas.setAttribute('aria-hidden', 'true'); // the value is text
    this.canvas.width = PLOT.width * 2;
    this.canvas.height = PLOT.height * 2;
    this.row.className = 'plot';
    this.row.style.setProperty('--plot', color);
    this.row.append(name, this.value, this.canvas);
  }

  add(value: number): void {
    this.history.push(value);
    if (this.history.length > HISTORY) this.history.shift();
    this.value.textContent = `${value.toFixed(this.digits)}${this.unit}`;
    this.draw();
  }

  private draw(): void {
    // Software rendering is faster for such small plots; the hint selects it.
    const context = this.canvas.getContext('2d', { willReadFrequently: true });
    if (!context) return;
    const { width, height } = this.canvas;
    const top = Math.max(1e-6, ...this.history) * 1.1;
    context.clearRect(0, 0, width, height);
    context.beginPath();
    this.history.forEach((value, i) => {
      const x = (i / (HISTORY - 1)) * width;
      const y = height - 2 - (value / top) * (height - 4);
      if (i === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    });
    context.strokeStyle = getComputedStyle(this.canvas).color; // depends on the theme
    context.lineWidth = 3;
    context.stroke();
  }
}

export class StatsPanel {
  private readonly tick = document.createElement('p');
  private readonly plots = {
    age: new Plot('Latency', ' ms', '#ffd166', 1),
    rtt: new Plot('Round trip', ' ms', '#ef8354', 1),
    bandwidth: new Plot('Bandwidth', ' kbit/s', '#5b8def'),
    awake: new Plot('Awake', '', '#81b29a'),
    asleep: new Plot('Asleep', '', '#8896a5'),
    step: new Plot('Step', ' ms', '#b388eb', 2),
    fps: new Plot('Frame rate', ' /s', '#7fb7d9'),
  };
  private lastBytes = 0;
  private lastAt = performance.now();
  private frames = 0;

  constructor(content: HTMLElement, private readonly connection: Connection) {
    this.tick.className = 'tick';
    content.append(this.tick, ...Object.values(this.plots).map((plot) => plot.row));
  }

  frameRendered(): void {
    this.frames++;
  }

  /** Called with each statistics message of the world. */
  update(stats: WorldStats): void {
    const now = performance.now();
    const seconds = Math.max(0.01, (now - this.lastAt) / 1000);
    const bytes = this.connection.bytesReceived - this.lastBytes;
    this.lastBytes = this.connection.bytesReceived;
    this.lastAt = now;
    const { tick, bodies, clients, lateTicks, paused } = stats;
    const parts = [`tick ${tick}`, counted(bodies, 'body', 'bodies'), counted(clients, 'client', 'clients')];
    if (lateTicks > 0) parts.push(counted(lateTicks, 'late tick', 'late ticks'));
    // A line breaks between the parts only.
    this.tick.textContent = [...parts.map((part) => part.replaceAll(' ', '\u00a0')), ...(paused ? [`paused: ${paused}`] : [])].join(' · ');
    this.plots.age.add(this.connection.ageMs);
    this.plots.rtt.add(this.connection.clock.rttMs);
    this.plots.bandwidth.add((bytes * 8) / 1000 / seconds);
    this.plots.awake.add(stats.awake);
    this.plots.asleep.add(this.asleep());
    this.plots.step.add(stats.stepMsMean);
    this.plots.fps.add(this.frames / seconds);
    this.frames = 0;
  }

  private asleep(): number {
    let count = 0;
    for (const entity of this.connection.frames.newest?.entities ?? [])
      if (entity.atRest && (this.connection.entities.get(entity.id)?.mass ?? 0) > 0) count++;
    return count;
  }
}
