// Draws time series over a common time axis, with units and a cursor that reads all values at a time.

import { axisOf } from './axis_ticks';
import type { TimeSeries } from './time_series';

const MARGIN = { left: 46, right: 8, top: 8, bottom: 20 }; // px
const FONT = '11px system-ui, sans-serif';
const KEY_STEP = 0.02; // share of the time axis

export class LinePlot {
  readonly element = document.createElement('figure');
  private readonly caption = document.createElement('figcaption');
  private readonly canvas = document.createElement('canvas');
  private readonly value = document.createElement('output');
  private cursor: number | undefined; // share of the time axis

  constructor(
    readonly series: TimeSeries,
    private readonly seconds: number, // length of the time axis
    /** Called when the cursor moves, so that all plots show the same time. */
    private readonly onCursor: (cursor: number | undefined) => void,
  ) {
    const name = document.createElement('span');
    name.textContent = series.unit ? `${series.name} (${series.unit})` : series.name;
    this.caption.append(name, this.value);
    this.element.className = 'line-plot';
    this.element.append(this.caption, this.canvas);
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    const move = (event: PointerEvent) => this.onCursor(this.share(event.clientX));
    this.canvas.addEventListener('pointermove', move);
    this.canvas.addEventListener('pointerdown', move);
    this.canvas.addEventListener('pointerleave', () => this.onCursor(undefined));
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    this.canvas.addEventListener('blur', () => this.onCursor(undefined));
  }

  setCursor(cursor: number | undefined): void {
    this.cursor = cursor;
  }

  private share(clientX: number): number {
    const box = this.canvas.getBoundingClientRect();
    return Math.min(1, Math.max(0, (clientX - box.left - MARGIN.left) / (box.width - MARGIN.left - MARGIN.right)));
  }

  private key(event: KeyboardEvent): void {
    const step = event.key === 'ArrowLeft' ? -KEY_STEP : event.key === 'ArrowRight' ? KEY_STEP : 0;
    if (step === 0) return;
    event.preventDefault();
    event.stopPropagation();
    this.onCursor(Math.min(1, Math.max(0, (this.cursor ?? 1) + step)));
  }

  /** `now`: the right end of the time axis, s. */
  draw(now: number): void {
    const { series, canvas } = this;
    const scale = Math.min(2, devicePixelRatio);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0) return;
    if (canvas.width !== Math.round(width * scale)) [canvas.width, canvas.height] = [Math.round(width * scale), Math.round(height * scale)];
    // Software rendering is faster for such small plots; the hint selects it.
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (!context) return;
    const style = getComputedStyle(canvas);
    const [text, grid, line] = [style.getPropertyValue('--dim'), style.getPropertyValue('--line'), style.getPropertyValue('--accent')];
    const start = now - this.seconds;
    const points = series.points.filter(({ seconds }) => seconds >= start);
    let [low, high] = [Infinity, -Infinity];
    for (const { value } of points) [low, high] = [Math.min(low, value), Math.max(high, value)];
    const axis = axisOf(points.length > 0 ? low : 0, points.length > 0 ? high : 1, 3);
    const right = width - MARGIN.right;
    const bottom = height - MARGIN.bottom;
    const x = (seconds: number) => MARGIN.left + ((seconds - start) / this.seconds) * (right - MARGIN.left);
    const y = (value: number) => bottom - ((value - axis.min) / (axis.max - axis.min)) * (bottom - MARGIN.top);

    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.clearRect(0, 0, width, height);
    context.font = FONT;
    context.lineWidth = 1;
    context.textBaseline = 'middle';
    context.textAlign = 'right';
    for (const tick of axis.ticks) {
      context.strokeStyle = grid;
      context.beginPath();
      context.moveTo(MARGIN.left, Math.round(y(tick)) + 0.5);
      context.lineTo(right, Math.round(y(tick)) + 0.5);
      context.stroke();
      context.fillStyle = text;
      context.fillText(tick.toFixed(Math.min(6, axis.digits)), MARGIN.left - 5, y(tick));
    }
    context.textBaseline = 'alphabetic';
    for (let k = 0; k <= 2; k++) {
      const seconds = (k / 2 - 1) * this.seconds;
      context.textAlign = (['left', 'center', 'right'] as const)[k]!;
      context.fillText(k === 2 ? 'now' : `${seconds} s`, x(now + seconds), height - 5);
    }
    context.strokeStyle = line;
    context.lineWidth = 1.6;
    context.beginPath();
    points.forEach(({ seconds, value }, k) => (k === 0 ? context.moveTo(x(seconds), y(value)) : context.lineTo(x(seconds), y(value))));
    context.stroke();
    this.showValue(context, start, { x, y, bottom, text, line });
  }

  private showValue(
    context: CanvasRenderingContext2D,
    start: number,
    { x, y, bottom, text, line }: { x: (s: number) => number; y: (v: number) => number; bottom: number; text: string; line: string },
  ): void {
    const sample = this.cursor === undefined ? this.series.newest : this.series.at(start + this.cursor * this.seconds);
    const valueText = sample && sample.seconds >= start ? formatValue(sample.value) : '–';
    const { unit, name } = this.series;
    const shown = this.cursor === undefined || !sample ? valueText : `${valueText} at ${(sample.seconds - start - this.seconds).toFixed(2)} s`;
    if (this.value.textContent !== shown) {
      this.value.textContent = shown;
      this.canvas.setAttribute('aria-label', `${name}: ${valueText} ${unit}. Arrow keys move the cursor`);
    }
    this.drawCursor(context, sample, { x, y, bottom, text, line });
  }

  private drawCursor(
    context: CanvasRenderingContext2D,
    sample: { seconds: number; value: number } | undefined,
    { x, y, bottom, text, line }: { x: (s: number) => number; y: (v: number) => number; bottom: number; text: string; line: string },
  ): void {
    if (this.cursor === undefined || !sample || x(sample.seconds) < MARGIN.left) return;
    context.strokeStyle = text;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x(sample.seconds), MARGIN.top);
    context.lineTo(x(sample.seconds), bottom);
    context.stroke();
    context.fillStyle = line;
    context.beginPath();
    context.arc(x(sample.seconds), y(sample.value), 3, 0, 2 * Math.PI);
    context.fill();
  }
}

/** Four significant digits without an exponent in the usual range. */
export function formatValue(value: number): string {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const magnitude = Math.abs(value);
  if (magnitude < 1e-4 || magnitude >= 1e7) return value.toExponential(2);
  return value.toFixed(Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(magnitude)))));
}
