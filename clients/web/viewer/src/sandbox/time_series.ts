// A history of one quantity over time, of bounded size.

export const SERIES_POINTS_MAX = 4096;

export interface Sample {
  readonly seconds: number;
  readonly value: number;
}

export class TimeSeries {
  private readonly samples: Sample[] = [];

  constructor(
    readonly name: string,
    readonly unit: string, // empty: none
    private readonly secondsMax: number,
  ) {}

  get points(): readonly Sample[] {
    return this.samples;
  }
  get newest(): Sample | undefined {
    return this.samples.at(-1);
  }

  /** Time that does not advance replaces the newest sample; time that goes back, as after a rewind, ends the history. */
  add(seconds: number, value: number): void {
    if (!Number.isFinite(seconds) || !Number.isFinite(value)) return;
    const newest = this.newest;
    if (newest && seconds < newest.seconds) this.samples.length = 0;
    else if (newest && seconds === newest.seconds) this.samples.pop();
    this.samples.push({ seconds, value });
    let old = Math.max(0, this.samples.length - SERIES_POINTS_MAX);
    while (old < this.samples.length && this.samples[old]!.seconds < seconds - this.secondsMax) old++;
    if (old > 0) this.samples.splice(0, old);
  }

  /** The sample closest to a time. */
  at(seconds: number): Sample | undefined {
    let [low, high] = [0, this.samples.length - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.samples[middle]!.seconds < seconds) low = middle + 1;
      else high = middle;
    }
    const [before, after] = [this.samples[low - 1], this.samples[low]];
    return before && (!after || seconds - before.seconds < after.seconds - seconds) ? before : after;
  }

  clear(): void {
    this.samples.length = 0;
  }
}

const label = ({ name, unit }: TimeSeries) => (unit ? `${name} (${unit})` : name);
const quoted = (text: string) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** The series as RFC 4180 text: one row per time at which any series has a sample, with empty cells in the others. */
export function seriesToCsv(series: readonly TimeSeries[]): string {
  const rows = new Map<number, (number | undefined)[]>();
  series.forEach(({ points }, column) => {
    for (const { seconds, value } of points) {
      const row = rows.get(seconds) ?? [];
      row[column] = value;
      rows.set(seconds, row);
    }
  });
  const lines = [['time (s)', ...series.map(label)].map(quoted)];
  for (const seconds of [...rows.keys()].sort((a, b) => a - b)) {
    const row = rows.get(seconds)!;
    lines.push([String(Number(seconds.toFixed(6))), ...series.map((_, column) => String(row[column] ?? ''))]);
  }
  return lines.map((line) => `${line.join(',')}\r\n`).join('');
}
