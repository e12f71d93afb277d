// The server tick that an input made now is meant for (Input.tick). The clock runs ahead of the server,
// so that inputs arrive before their tick. The server reports the margin
// (ClientUpdate.input_margin_us), and the clock is adjusted until the margin is one tick plus four
// times its jitter. Within a quarter of a tick of that target the speed is 1. After three consecutive
// smoothed margins outside, it is 1.003 or 0.997 for as long as necessary, or 1.05 or 0.95 if the error
// exceeds one tick. An error of more than ten ticks causes a jump.
// Same algorithm as jostle/client/input_clock.h of the C++ client library. Times in microseconds.

const MEAN_WEIGHT = 1 / 8;
const JITTER_WEIGHT = 1 / 16;
const JITTER_MARGIN_FACTOR = 4;
const FIRST_JITTER_US = 4000;
// Errors up to one tick are corrected slowly: the margins of single inputs differ by that, and the
// error is not worth a visible change of the speed of predicted motion.
const SPEED_CORRECTION = 0.05;
const SLOW_CORRECTION = 0.003;
const TOLERANCE_TICKS = 0.25;
const JUMP_TICKS = 10;
const CONSECUTIVE_MARGINS = 3;
const MARGIN_TIMEOUT_FRAMES = 120;

export class InputClock {
  ready = false;
  speed = 1;
  jumps = 0;
  private tickUs = 1e6 / 60;
  private positionTicks = 0;
  private updatedUs = 0;
  private correctionUs = 0; // remaining correction
  private hasMargin = false;
  private meanMarginUs = 0;
  private lastMarginUs = 0;
  private jitterUs = FIRST_JITTER_US;
  private framesSinceMargin = 0;
  private consecutiveOutOfRange = 0; // consecutive margins above (positive) or below (negative) the target
  private sentSequence = 0;
  private lastMarginSequence = 0;

  /** Starts a stream of a world with `tickHz` ticks per second. */
  begin(tickHz: number): void {
    Object.assign(this, new InputClock());
    if (tickHz > 0 && Number.isFinite(tickHz)) this.tickUs = 1e6 / tickHz;
  }

  get halfTickUs(): number {
    return this.tickUs / 2;
  }
  get targetUs(): number {
    return this.tickUs + JITTER_MARGIN_FACTOR * this.jitterUs;
  }
  /** The reported margin, smoothed. */
  get marginUs(): number {
    return this.meanMarginUs;
  }

  /**
   * A frame arrived. `dueAgoUs`: time since its tick was due, on the server's clock; `oneWayUs`:
   * latency of an input.
   */
  onFrame(tick: number, dueAgoUs: number, oneWayUs: number, nowUs: number): void {
    const target = tick + (dueAgoUs + oneWayUs + this.targetUs) / this.tickUs;
    if (!this.ready) {
      this.ready = true;
      this.positionTicks = target;
      this.updatedUs = nowUs;
      return;
    }
    // Margins are more accurate, but there are none without inputs.
    const error = target - this.position(nowUs);
    if (++this.framesSinceMargin > MARGIN_TIMEOUT_FRAMES && Math.abs(error) > JUMP_TICKS) this.jump(error);
  }

  /** Inputs up to this number were sent. */
  sent(sequence: number): void {
    this.sentSequence = sequence;
  }

  /**
   * The server reported the margin of an input; 0: unknown. Margins of inputs sent before the last jump
   * are ignored.
   */
  onMargin(sequence: number, marginUs: number): void {
    if (sequence <= this.lastMarginSequence || marginUs === 0) return;
    this.lastMarginSequence = sequence;
    this.framesSinceMargin = 0;
    if (!this.hasMargin) this.meanMarginUs = this.lastMarginUs = marginUs;
    this.hasMargin = true;
    // Between consecutive margins, because a longer latency is not jitter.
    const change = Math.min(Math.abs(marginUs - this.lastMarginUs), 2 * this.tickUs);
    this.jitterUs += JITTER_WEIGHT * (change - this.jitterUs);
    this.lastMarginUs = marginUs;
    this.meanMarginUs += MEAN_WEIGHT * (marginUs - this.meanMarginUs);
    const error = marginUs - this.targetUs;
    if (Math.abs(error) > JUMP_TICKS * this.tickUs) return this.jump(-error / this.tickUs);
    this.adjust(Math.abs(error) > this.tickUs ? error : this.meanMarginUs - this.targetUs);
  }

  private adjust(error: number): void {
    if (Math.abs(error) < TOLERANCE_TICKS * this.tickUs) {
      this.consecutiveOutOfRange = 0;
      this.speed = 1;
      return;
    }
    this.correctionUs = Math.abs(error);
    this.consecutiveOutOfRange = error > 0 ? Math.max(0, this.consecutiveOutOfRange) + 1 : Math.min(0, this.consecutiveOutOfRange) - 1;
    const correction = this.correctionUs > this.tickUs ? SPEED_CORRECTION : SLOW_CORRECTION;
    if (this.consecutiveOutOfRange >= CONSECUTIVE_MARGINS) this.speed = 1 - correction;
    if (this.consecutiveOutOfRange <= -CONSECUTIVE_MARGINS) this.speed = 1 + correction;
  }

  private jump(ticks: number): void {
    this.positionTicks += ticks;
    this.jumps++;
    this.speed = 1;
    this.consecutiveOutOfRange = 0;
    this.hasMargin = false;
    this.lastMarginSequence = Math.max(this.lastMarginSequence, this.sentSequence);
  }

  /** In ticks, with a fraction; decreases only in a jump. 0 until ready. */
  position(nowUs: number): number {
    if (this.ready && nowUs > this.updatedUs) {
      const elapsed = nowUs - this.updatedUs;
      this.positionTicks += (elapsed * this.speed) / this.tickUs;
      this.updatedUs = nowUs;
      this.correctionUs -= Math.abs(this.speed - 1) * elapsed;
      if (this.correctionUs <= 0) this.speed = 1;
    }
    return this.positionTicks;
  }

  /** The tick of an input made now: the next whole tick. */
  tick(nowUs: number): number {
    return Math.ceil(Math.min(2 ** 32 - 1, Math.max(0, this.position(nowUs)))); // the server's times are untrusted
  }
}
