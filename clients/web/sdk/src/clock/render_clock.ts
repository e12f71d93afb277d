// Which moment of the server's world a picture shows. It is a little in the past, so that there is a frame on either side although
// frames arrive unevenly. This clock never goes backwards, and its speed stays within 8 % of 1, whatever the link does: a change of
// the delay is walked, not jumped. It needs no ping: both its times come with frames. The C++ client library has the same
// (jostle/client/render_clock.h). All in microseconds.

const ARRIVALS_MAX = 256;
const FRAMES_PER_UPDATE = 8;
const REST_US = 200_000;
const FRAME_GAP_US = 500_000;
const DELAY_MAX_US = 300_000;
const FIRST_DELAY_US = 60_000;
const BURST_INTERVAL_RATIO = 0.25; // of their interval: frames that come faster one after the other came at once
const INTERVALS_BEHIND = 1.7;
const JITTER_PERCENTILE = 0.95;
// Of the difference to the delay that is wanted, by each frame.
const DELAY_GROWTH_RATE = 1 / 60;
const DELAY_SHRINK_RATE = 1 / 240;
const SPEED_CHANGE_MAX = 0.08;
const SETTLE_US = 500_000;
const JUMP_US = 1_000_000;

/** Of a list that may be put into another order. */
function percentile(values: Float64Array, share: number): number {
  return values.sort()[Math.floor(share * (values.length - 1))]!;
}

export class RenderClock {
  // Of the last 256 frames, the oldest overwritten by the newest.
  private readonly lateness = new Float64Array(ARRIVALS_MAX); // arrival less tick: the way, and how the clocks differ
  private readonly intervals = new Float64Array(ARRIVALS_MAX); // since the tick before; 0: tells nothing of the jitter
  private arrivals = 0; // so far
  private targetDelayUs = FIRST_DELAY_US;
  private framesUntilUpdate = 0; // frames; what is wanted is looked at with every eighth
  private newest = 0;
  private arrived = 0;
  private minLatenessUs = 0; // lateness of the quickest of them
  private gapEnded = false; // and what it held up still comes
  private started = false;
  private now = 0;
  /**
   * Behind what could be shown at the soonest: max(1.7 intervals, interval + jitter), at most 300 ms; 60 ms at first. The interval
   * is the median of the last 256 frames. Jitter is the 95th percentile of how much later one came than the quickest. What came
   * more than 200 ms after the tick before tells nothing, for the world rested; nor does what came at once with the frame that
   * ended a silence of half a second: no delay makes up for such. Growing takes about a second, shrinking about four.
   */
  delayUs = FIRST_DELAY_US;
  renderTimeUs = 0;
  speed = 1; // over the last picture

  /**
   * A frame arrived: when its tick was due, on the server's clock, and when it came, on ours. After a rest no frames were sent, so
   * how long that was tells nothing of the rhythm.
   */
  onFrame(serverUs: number, arrivedUs: number, afterRest = false): void {
    const first = this.arrivals === 0;
    if (!first && serverUs <= this.newest) return;
    const interval = first ? 0 : serverUs - this.newest;
    const gap = first ? 0 : arrivedUs - this.arrived;
    this.gapEnded = (gap > FRAME_GAP_US && !afterRest) || (this.gapEnded && gap < BURST_INTERVAL_RATIO * interval);
    const countsForJitter = !first && !afterRest && interval < REST_US && !this.gapEnded;
    const at = this.arrivals++ % ARRIVALS_MAX;
    this.lateness[at] = arrivedUs - serverUs;
    this.intervals[at] = countsForJitter ? interval : 0;
    this.newest = serverUs;
    this.arrived = arrivedUs;
    this.adapt();
  }

  /**
   * A picture is drawn: what it shows, on the server's clock. `nowUs` is on ours; when it did not rise, nothing changes. 0 before
   * the first frame. It approaches now - shortest way - delay. More than a second behind it jumps there: the only step it takes.
   */
  advance(nowUs: number): number {
    if (this.arrivals === 0) return 0;
    const target = nowUs - this.minLatenessUs - this.delayUs;
    if (!this.started) {
      this.started = true;
      this.now = nowUs;
      this.renderTimeUs = target;
    }
    if (nowUs <= this.now) return this.renderTimeUs;
    const passed = nowUs - this.now;
    this.now = nowUs;
    const behind = target - (this.renderTimeUs + passed);
    if (behind > JUMP_US) {
      this.speed = 1;
      return (this.renderTimeUs = target);
    }
    const most = SPEED_CHANGE_MAX * passed;
    const change = Math.min(most, Math.max(-most, behind * Math.min(1, passed / SETTLE_US)));
    this.speed = 1 + change / passed;
    return (this.renderTimeUs += passed + change);
  }

  reset(): void {
    Object.assign(this, new RenderClock());
  }

  private adapt(): void {
    const count = Math.min(this.arrivals, ARRIVALS_MAX);
    this.minLatenessUs = this.lateness[0]!;
    for (let k = 1; k < count; k++) this.minLatenessUs = Math.min(this.minLatenessUs, this.lateness[k]!);
    if (this.framesUntilUpdate-- === 0) {
      this.framesUntilUpdate = FRAMES_PER_UPDATE - 1;
      this.look(count);
    }
    this.delayUs += (this.targetDelayUs > this.delayUs ? DELAY_GROWTH_RATE : DELAY_SHRINK_RATE) * (this.targetDelayUs - this.delayUs);
  }

  private look(count: number): void {
    const intervals = new Float64Array(count);
    const late = new Float64Array(count);
    let telling = 0;
    for (let k = 0; k < count; k++) {
      if (this.intervals[k] === 0) continue;
      intervals[telling] = this.intervals[k]!;
      late[telling++] = this.lateness[k]! - this.minLatenessUs;
    }
    if (telling === 0) return;
    const interval = percentile(intervals.subarray(0, telling), 0.5);
    const jitter = percentile(late.subarray(0, telling), JITTER_PERCENTILE);
    this.targetDelayUs = Math.min(DELAY_MAX_US, Math.max(INTERVALS_BEHIND * interval, interval + jitter));
  }
}
