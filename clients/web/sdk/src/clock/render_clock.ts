// The server time that a rendered frame shows. It is slightly in the past, so that there are frames
// before and after it although frames arrive irregularly. The clock never goes backwards and its speed
// stays within 8 % of 1 under all network conditions: changes of the delay are gradual. It needs no
// pings, because frames carry both times. Same algorithm as jostle/client/render_clock.h of the C++
// client library. All times in microseconds.

const ARRIVALS_MAX = 256;
const FRAMES_PER_UPDATE = 8;
const REST_US = 200_000;
const FRAME_GAP_US = 500_000;
const DELAY_MAX_US = 300_000;
const FIRST_DELAY_US = 60_000;
const BURST_INTERVAL_RATIO = 0.25; // of their interval: frames that arrive closer together are a burst
const INTERVALS_BEHIND = 1.7;
const JITTER_PERCENTILE = 0.95;
// Fraction of the difference to the target delay, per frame.
const DELAY_GROWTH_RATE = 1 / 60;
const DELAY_SHRINK_RATE = 1 / 240;
const SPEED_CHANGE_MAX = 0.08;
const SETTLE_US = 500_000;
const JUMP_US = 1_000_000;

/** Sorts `values`. */
function percentile(values: Float64Array, fraction: number): number {
  return values.sort()[Math.floor(fraction * (values.length - 1))]!;
}

export class RenderClock {
  // Ring buffers of the last 256 frames.
  private readonly lateness = new Float64Array(ARRIVALS_MAX); // arrival minus tick: latency plus clock difference
  private readonly intervals = new Float64Array(ARRIVALS_MAX); // since the previous tick; 0: not used for the jitter
  private arrivals = 0; // total
  private targetDelayUs = FIRST_DELAY_US;
  private framesUntilUpdate = 0; // the target delay is updated with every eighth frame
  private newestUs = 0;
  private newestArrivalUs = 0;
  private minLatenessUs = 0; // the smallest lateness
  private gapEnded = false; // the frames that a gap delayed are still arriving
  private started = false;
  private updatedUs = 0;
  /**
   * Delay behind the earliest time that could be rendered: max(1.7 intervals, interval + jitter), at
   * most 300 ms; 60 ms at first. The interval is the median of the last 256 frames. The jitter is the
   * 95th percentile of the lateness beyond the smallest one. Frames more than 200 ms after the previous
   * tick do not count, because the world rested. Nor does the burst of frames after a gap of 0.5 s,
   * which no delay could compensate. Growing takes about 1 s, shrinking about 4 s.
   */
  delayUs = FIRST_DELAY_US;
  renderTimeUs = 0;
  speed = 1; // over the last rendered frame

  /**
   * A frame arrived. `serverUs`: when its tick was due, on the server's clock; `arrivedUs`: on the
   * local clock; `afterRest`: no frames were sent before it because nothing moved.
   */
  onFrame(serverUs: number, arrivedUs: number, afterRest = false): void {
    const first = this.arrivals === 0;
    if (!first && serverUs <= this.newestUs) return;
    const interval = first ? 0 : serverUs - this.newestUs;
    const gap = first ? 0 : arrivedUs - this.newestArrivalUs;
    this.gapEnded = (gap > FRAME_GAP_US && !afterRest) || (this.gapEnded && gap < BURST_INTERVAL_RATIO * interval);
    const countsForJitter = !first && !afterRest && interval < REST_US && !this.gapEnded;
    const at = this.arrivals++ % ARRIVALS_MAX;
    this.lateness[at] = arrivedUs - serverUs;
    this.intervals[at] = countsForJitter ? interval : 0;
    this.newestUs = serverUs;
    this.newestArrivalUs = arrivedUs;
    this.adapt();
  }

  /**
   * Returns the server time to render at `nowUs` on the local clock; unchanged unless `nowUs`
   * increased, 0 before the first frame. It approaches now - smallest lateness - delay. If it is more
   * than 1 s behind, it jumps there.
   */
  advance(nowUs: number): number {
    if (this.arrivals === 0) return 0;
    const target = nowUs - this.minLatenessUs - this.delayUs;
    if (!this.started) {
      this.started = true;
      this.updatedUs = nowUs;
      this.renderTimeUs = target;
    }
    if (nowUs <= this.updatedUs) return this.renderTimeUs;
    const elapsed = nowUs - this.updatedUs;
    this.updatedUs = nowUs;
    const behind = target - (this.renderTimeUs + elapsed);
    if (behind > JUMP_US) {
      this.speed = 1;
      return (this.renderTimeUs = target);
    }
    const maxChange = SPEED_CHANGE_MAX * elapsed;
    const change = Math.min(maxChange, Math.max(-maxChange, behind * Math.min(1, elapsed / SETTLE_US)));
    this.speed = 1 + change / elapsed;
    return (this.renderTimeUs += elapsed + change);
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
      this.updateTargetDelay(count);
    }
    this.delayUs += (this.targetDelayUs > this.delayUs ? DELAY_GROWTH_RATE : DELAY_SHRINK_RATE) * (this.targetDelayUs - this.delayUs);
  }

  private updateTargetDelay(count: number): void {
    const intervals = new Float64Array(count);
    const relativeLateness = new Float64Array(count);
    let samples = 0;
    for (let k = 0; k < count; k++) {
      if (this.intervals[k] === 0) continue;
      intervals[samples] = this.intervals[k]!;
      relativeLateness[samples++] = this.lateness[k]! - this.minLatenessUs;
    }
    if (samples === 0) return;
    const interval = percentile(intervals.subarray(0, samples), 0.5);
    const jitter = percentile(relativeLateness.subarray(0, samples), JITTER_PERCENTILE);
    this.targetDelayUs = Math.min(DELAY_MAX_US, Math.max(INTERVALS_BEHIND * interval, interval + jitter));
  }
}
