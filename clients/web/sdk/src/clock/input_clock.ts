// Which tick of the server an input that is made now is meant for (Input.tick). It runs ahead of the server, so that inputs arrive
// before their tick: the server tells by how much (the margin, Private.input_margin_us), and this clock is steered until that is a
// tick and four times its jitter. Within a tick of that it runs evenly; after three margins in a row beyond, at 1.05 or 0.95 times
// the speed, for as long as it takes; more than ten ticks off, it jumps. The C++ client library has the same
// (jostle/client/input_clock.h). Times in microseconds.

const MEAN_WEIGHT = 1 / 8;
const JITTER_WEIGHT = 1 / 16;
const JITTER_MARGIN_FACTOR = 4;
const FIRST_JITTER_US = 4000;
const SPEED_CORRECTION = 0.05;
const JUMP_TICKS = 10;
const CONSECUTIVE_MARGINS = 3;
const MARGIN_TIMEOUT_FRAMES = 120;

export class InputClock {
  ready = false;
  speed = 1;
  jumps = 0;
  private tickUs = 1e6 / 60;
  private positionTicks = 0; // in ticks
  private now = 0;
  private correctionUs = 0; // how much is still to be won or lost
  private measured = false;
  private mean = 0;
  private last = 0;
  private jitter = FIRST_JITTER_US;
  private framesSinceMargin = 0; // since the last margin
  private consecutiveOutOfRange = 0; // how many margins in a row were beyond; negative: short of it
  private sentSequence = 0;
  private lastMarginSequence = 0;

  /** A stream of a world with so many ticks a second begins. */
  begin(tickHz: number): void {
    Object.assign(this, new InputClock());
    if (tickHz > 0 && Number.isFinite(tickHz)) this.tickUs = 1e6 / tickHz;
  }

  get targetUs(): number {
    return this.tickUs + JITTER_MARGIN_FACTOR * this.jitter;
  }
  /** As told, smoothed. */
  get marginUs(): number {
    return this.mean;
  }

  /** A frame arrived: its tick was due so long ago, by the server's clock; and how long an input is on its way. */
  onFrame(tick: number, dueAgoUs: number, oneWayUs: number, nowUs: number): void {
    const wanted = tick + (dueAgoUs + oneWayUs + this.targetUs) / this.tickUs;
    if (!this.ready) {
      this.ready = true;
      this.positionTicks = wanted;
      this.now = nowUs;
      return;
    }
    // Margins know better; but without inputs there are none.
    const off = wanted - this.position(nowUs);
    if (++this.framesSinceMargin > MARGIN_TIMEOUT_FRAMES && Math.abs(off) > JUMP_TICKS) this.jump(off);
  }

  /** Inputs up to that number have left. */
  sent(sequence: number): void {
    this.sentSequence = sequence;
  }

  /**
   * The server told the margin of an input. That of one that was sent before the last jump tells nothing, nor does 0: it knows
   * none.
   */
  onMargin(sequence: number, marginUs: number): void {
    if (sequence <= this.lastMarginSequence || marginUs === 0) return;
    this.lastMarginSequence = sequence;
    this.framesSinceMargin = 0;
    if (!this.measured) this.mean = this.last = marginUs;
    this.measured = true;
    // From one to the next: that the way became longer is no jitter.
    const change = Math.min(Math.abs(marginUs - this.last), 2 * this.tickUs);
    this.jitter += JITTER_WEIGHT * (change - this.jitter);
    this.last = marginUs;
    this.mean += MEAN_WEIGHT * (marginUs - this.mean);
    this.steer(marginUs - this.targetUs);
  }

  private steer(off: number): void {
    if (Math.abs(off) > JUMP_TICKS * this.tickUs) return this.jump(-off / this.tickUs);
    if (Math.abs(off) < this.tickUs) {
      this.consecutiveOutOfRange = 0;
      this.speed = 1;
      return;
    }
    this.correctionUs = Math.abs(off);
    this.consecutiveOutOfRange = off > 0 ? Math.max(0, this.consecutiveOutOfRange) + 1 : Math.min(0, this.consecutiveOutOfRange) - 1;
    if (this.consecutiveOutOfRange >= CONSECUTIVE_MARGINS) this.speed = 1 - SPEED_CORRECTION;
    if (this.consecutiveOutOfRange <= -CONSECUTIVE_MARGINS) this.speed = 1 + SPEED_CORRECTION;
  }

  private jump(ticks: number): void {
    this.positionTicks += ticks;
    this.jumps++;
    this.speed = 1;
    this.consecutiveOutOfRange = 0;
    this.measured = false;
    this.lastMarginSequence = Math.max(this.lastMarginSequence, this.sentSequence);
  }

  /** In ticks, with a fraction; never back but by a jump. 0 until ready. */
  position(nowUs: number): number {
    if (this.ready && nowUs > this.now) {
      const passed = nowUs - this.now;
      this.positionTicks += (passed * this.speed) / this.tickUs;
      this.now = nowUs;
      this.correctionUs -= Math.abs(this.speed - 1) * passed;
      if (this.correctionUs <= 0) this.speed = 1;
    }
    return this.positionTicks;
  }

  /** The tick that an input of now is meant for: the next whole one. */
  tick(nowUs: number): number {
    return Math.ceil(Math.min(2 ** 32 - 1, Math.max(0, this.position(nowUs)))); // a server may say anything of its time
  }
}
