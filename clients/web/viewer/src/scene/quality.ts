// Rendering quality. Automatic quality drops a level when frames take too long and raises it again after
// a longer time of short frames. A level that turned out to be too slow is tried less and less often.

export interface QualityLevel {
  readonly name: string;
  readonly pixelRatioMax: number;
  readonly sunShadowPixels: number; // resolution of the shadow map; 0: no shadows
  readonly contactShadows: boolean;
  readonly blur: boolean; // behind panels
}

export const QUALITY_LEVELS: readonly QualityLevel[] = [
  { name: 'high', pixelRatioMax: 2, sunShadowPixels: 2048, contactShadows: true, blur: true },
  { name: 'reduced', pixelRatioMax: 1.5, sunShadowPixels: 1024, contactShadows: false, blur: false },
  { name: 'medium', pixelRatioMax: 1, sunShadowPixels: 0, contactShadows: false, blur: false },
  { name: 'minimal', pixelRatioMax: 0.5, sunShadowPixels: 0, contactShadows: false, blur: false },
];
/** For machines without a GPU; never selected automatically. */
export const LOW_QUALITY: QualityLevel = { ...QUALITY_LEVELS[3]!, name: 'low', pixelRatioMax: 0.25 };

const SLOW_MS = 25; // mean frame time above which a level is too slow
const FAST_MS = 18; // and below which the next better level is tried
const WINDOW_MS = 1000;
const SLOW_WINDOWS = 2; // before a drop
const FAST_WINDOWS = 8; // before a raise
const FAST_WINDOWS_MAX = 300;
const GAP_MS = 1500; // a longer frame is a hidden page, not slow rendering
const WARM_UP_MS = 2000; // shaders are compiled
const GAIN_MIN = 0.07; // share of the frame time that a drop must save

/** Chooses a level by frame times. */
export class AutomaticQuality {
  level = 0;
  private startMs = NaN;
  private lastMs = NaN;
  private windowMs = 0;
  private frames = 0;
  private slow = 0;
  private fast = 0;
  private fastNeeded = FAST_WINDOWS;
  private beforeDropMs = 0; // mean frame time before the last drop, until its gain is known; 0: known
  private raised = false; // the last change was a raise
  private held = false; // lower levels do not help

  constructor(private readonly levels = QUALITY_LEVELS.length) {}

  /** Call once per rendered frame; returns whether the level changed. */
  frame(nowMs: number): boolean {
    if (Number.isNaN(this.startMs)) this.startMs = nowMs;
    const elapsed = nowMs - this.lastMs;
    this.lastMs = nowMs;
    if (!(elapsed <= GAP_MS) || nowMs - this.startMs < WARM_UP_MS) {
      this.windowMs = this.frames = 0;
      return false;
    }
    this.windowMs += elapsed;
    this.frames++;
    if (this.windowMs < WINDOW_MS) return false;
    const meanMs = this.windowMs / this.frames;
    this.windowMs = this.frames = 0;
    return this.judge(meanMs);
  }

  private judge(meanMs: number): boolean {
    if (this.beforeDropMs > 0) {
      const gained = meanMs < (1 - GAIN_MIN) * this.beforeDropMs;
      this.beforeDropMs = 0;
      if (!gained) {
        // The display or the processor limits the frame rate.
        this.held = true;
        return this.change(-1);
      }
    }
    this.slow = meanMs > SLOW_MS ? this.slow + 1 : 0;
    this.fast = meanMs < FAST_MS ? this.fast + 1 : 0;
    if (this.slow === 0) this.held = false;
    if (this.slow >= SLOW_WINDOWS && !this.held && this.level + 1 < this.levels) {
      if (this.raised) this.fastNeeded = Math.min(FAST_WINDOWS_MAX, 4 * this.fastNeeded);
      this.beforeDropMs = meanMs;
      return this.change(1);
    }
    if (this.fast >= this.fastNeeded && this.level > 0) return this.change(-1);
    return false;
  }

  private change(by: number): boolean {
    this.level += by;
    this.raised = by < 0;
    this.slow = this.fast = 0;
    return true;
  }
}
