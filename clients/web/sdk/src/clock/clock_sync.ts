// Estimates the server's clock from round trips. The sample with the shortest round trip is the most
// accurate; samples expire after 30 s because clocks drift. All times in microseconds.

const SAMPLE_LIFE_US = 30e6;

export class ClockSync {
  private samples: { offset: number; rtt: number; at: number }[] = [];
  private offset = 0;

  add(sentUs: number, serverUs: number, nowUs: number): void {
    const rtt = nowUs - sentUs;
    if (rtt < 0) return; // not an echo of this client
    this.samples.push({ offset: serverUs - sentUs - rtt / 2, rtt, at: nowUs });
    this.samples = this.samples.filter((s) => s.at + SAMPLE_LIFE_US >= nowUs);
    this.offset = this.samples.reduce((a, b) => (b.rtt < a.rtt ? b : a)).offset;
  }

  get ready(): boolean {
    return this.samples.length > 0;
  }

  serverUs(nowUs: number): number {
    return nowUs + this.offset;
  }

  get rttMs(): number {
    return this.samples.length === 0 ? 0 : Math.min(...this.samples.map((s) => s.rtt)) / 1000;
  }

  reset(): void {
    this.samples = [];
    this.offset = 0;
  }
}

export function nowUs(): number {
  return performance.now() * 1000;
}
