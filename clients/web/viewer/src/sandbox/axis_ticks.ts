// Round numbers for the ticks of an axis.

export interface Axis {
  readonly min: number;
  readonly max: number;
  readonly ticks: readonly number[];
  /** Digits after the decimal point that distinguish the ticks. */
  readonly digits: number;
}

/** The axis that covers the values with steps of 1, 2 or 5 times a power of ten; at most `count` steps. */
export function axisOf(low: number, high: number, count: number): Axis {
  if (!(high - low > 1e-9 * Math.max(1, Math.abs(high)))) {
    const margin = 0.5 * Math.abs(high);
    [low, high] = margin > 1e-9 ? [low - margin, high + margin] : [0, 1];
  }
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= raw * (1 - 1e-9)) ?? 10);
  const first = Math.floor(low / step + 1e-9);
  const last = Math.ceil(high / step - 1e-9);
  const ticks = Array.from({ length: last - first + 1 }, (_, k) => (first + k) * step);
  return { min: first * step, max: last * step, ticks, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}
