// Durations of the script of rendered frames, without the calls that draw.

const FRAMES = 600;

export class FrameTimes {
  private readonly times = new Float64Array(FRAMES);
  private count = 0;

  add(ms: number): void {
    this.times[this.count++ % FRAMES] = ms;
  }
  reset(): void {
    this.count = 0;
  }
  /** Of the newest 600 frames, in ms; 0 without frames. */
  percentile(share: number): number {
    const sorted = this.times.slice(0, Math.min(FRAMES, this.count)).sort();
    return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0;
  }
  get frames(): number {
    return this.count;
  }
}
