// A bar that shows the scale at the target of the camera.

const WIDTH_MAX = 120; // pixels

/** The greatest length of 1, 2 or 5 times a power of ten that is at most `metersMax`. */
export function scaleLength(metersMax: number): number {
  const power = 10 ** Math.floor(Math.log10(metersMax));
  const digit = metersMax / power;
  return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
}

export function scaleText(meters: number): string {
  if (meters >= 1000) return `${meters / 1000} km`;
  return meters >= 1 ? `${Math.round(meters)} m` : meters >= 0.01 ? `${Math.round(100 * meters)} cm` : `${Number((1000 * meters).toPrecision(1))} mm`;
}

export class ScaleBar {
  private shown = '';

  constructor(private readonly element: HTMLElement) {}

  /** `metersPerPixel` at the target of the camera. */
  update(metersPerPixel: number): void {
    if (!(metersPerPixel > 0) || !Number.isFinite(metersPerPixel)) return;
    const meters = scaleLength(WIDTH_MAX * metersPerPixel);
    const width = Math.round(meters / metersPerPixel);
    const text = scaleText(meters);
    if (this.shown === `${width} ${text}`) return;
    this.shown = `${width} ${text}`;
    this.element.style.width = `${width}px`;
    this.element.textContent = text;
  }
}
