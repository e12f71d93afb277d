// Work that is asked for often and done at most so often: never twice at the same time, and once more after the last asking.

export class Throttle {
  private due = false;
  private running = false;
  private last = -Infinity; // ms, when it last began
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly everyMs: number,
    private readonly run: () => Promise<void>,
  ) {}

  request(): void {
    this.due = true;
    this.next();
  }

  private next(): void {
    if (!this.due || this.running || this.timer !== undefined) return;
    const wait = this.last + this.everyMs - performance.now();
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
