// Limits how often requested work runs: at most once per interval, never concurrently, and once more
// after the last request.

export class Throttle {
  private due = false;
  private running = false;
  private last = -Infinity; // ms, when it last started
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly intervalMs: number,
    private readonly run: () => Promise<void>,
  ) {}

  request(): void {
    this.due = true;
    this.next();
  }

  private next(): void {
    if (!this.due || this.running || this.timer !== undefined) return;
    const wait = this.last + this.intervalMs - performance.now();
    if (wait > 0) {
      this.timer = setTimeout(() => {
        this.timer = undefined;
        this.next();
      }, wait);
      return;
    }
    this.due = false;
    this.running = true;
    this.last = performance.now();
    const done = () => {
      this.running = false;
      this.next();
    };
    this.run().then(done, (error: unknown) => {
      console.error(error);
      done();
    });
  }
}
