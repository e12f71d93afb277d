// Whose motion the viewer foresees, and when it does not: what it drives, else the body that a hand holds or a push hits, until it rests.
// What the predictor gets wrong again and again is left to the server, and what hangs on joints (parts of ragdolls): clients are not told
// what these do.

import type { PredictionListener, Input } from '../connection/connection.js';
import type { FrameBuffer, PoseFrame } from '../interpolation/frame_buffer.js';
import { InputCode, type Entity, type InputResult, type Welcome } from '../gen/jostle/v1/play_pb.js';
import type { ControlledEntity } from '../connection/word_changes.js';
import { MOTION } from './motion.js';
import type { RenderedScene, Predictor, PredictorStats } from './predictor.js';

const CORRECTION_THRESHOLD_M = 0.05; // a frame that differs by more was foreseen wrongly
const ERROR_DECAY_RATE = 1 / 30; // of what frames before said, by each
const CORRECTION_RATE_MAX = 0.5;
const QUIET_FRAMES = 60; // after the last input

/** How often the followed one was compared with what the server says, and how far off it was. */
function compared(stats: PredictorStats, driving: boolean): { times: number; errorM: number } {
  return driving ? { times: stats.controlUpdates, errorM: stats.lastControlErrorM } : { times: stats.frames, errorM: stats.lastErrorM };
}

export class PredictionController implements PredictionListener {
  /** 0: nobody. */
  followed = 0;
  private held = false;
  private driving = 0; // 0: nothing
  private motion: number | undefined; // the kind of channel that says how bodies move
  private correctionRate = 0; // share of frames
  private frames = 0; // compared so far
  private sinceInput = 0;
  private readonly serverControlled = new Set<number>(); // to the server
  private readonly pendingTicks = new Map<number, number>(); // of inputs that the server did not answer yet: their ticks
  /** Inputs that the server applied later than they were meant to be, and such that were foreseen. */
  late = 0;
  sent = 0;

  constructor(
    private readonly predictor: Predictor,
    private readonly buffer: FrameBuffer,
    /** The predictor failed: this foresees nothing any more. */
    private readonly failed: (error: unknown) => void,
  ) {}

  begin({ tickHz, gravity, channels, substeps }: Welcome): void {
    const motion = channels.findIndex(({ name }) => name === MOTION);
    this.motion = motion < 0 ? undefined : motion;
    this.followed = 0;
    this.held = false;
    this.driving = 0;
    this.serverControlled.clear();
    this.pendingTicks.clear();
    this.try(() => this.predictor.begin(tickHz, gravity ?? { x: 0, y: 0, z: 0 }, substeps));
  }

  entityAdded(entity: Entity): void {
    this.try(() => this.predictor.addBody(entity));
  }

  entityRemoved(entity: number): void {
    this.try(() => this.predictor.removeBody(entity));
    if (entity === this.driving) this.driving = 0;
    if (entity === this.followed) this.follow(0);
  }

  controlledEntity(thing: ControlledEntity | undefined): void {
    this.try(() => this.predictor.drive(thing));
  }

  input(sequence: number, tick: number, input: Input): void {
    const kind = input.kind;
    if (kind?.case === 'possess') {
      this.driving = kind.value.entity ?? 0;
      this.follow(this.driving);
    } else if (this.driving !== 0) {
      // What is driven is foreseen, whatever else is pushed.
    } else if (kind?.case === 'grab') this.follow(kind.value.entity ?? 0);
    else if (kind?.case === 'impulse' && !this.held) this.follow(kind.value.entity ?? 0);
    if (kind?.case === 'grab' || kind?.case === 'release') this.held = kind.case === 'grab';
    this.sinceInput = 0;
    if (tick === 0) return;
    if (!this.pendingTicks.has(sequence)) this.sent++;
    this.pendingTicks.set(sequence, tick);
    this.try(() => this.predictor.addInput(sequence, tick, input));
  }

  result({ sequence, tick, code }: InputResult): void {
    if (tick > (this.pendingTicks.get(sequence) ?? tick)) this.late++;
    this.pendingTicks.delete(sequence);
    this.try(() => this.predictor.onResult(sequence, tick, code === InputCode.APPLIED));
  }

  frame(frame: PoseFrame): void {
    if (this.followed === 0) return;
    this.try(() => this.predictor.onFrame(frame, this.motion));
    this.updateCorrectionRate(this.predictor.stats);
    const rests = frame.entities.find(({ id }) => id === this.followed)?.atRest ?? true;
    if (++this.sinceInput > QUIET_FRAMES && !this.held && this.driving === 0 && rests) this.follow(0);
  }

  /** The picture of now: at that place of the input clock, in ticks. */
  draw(scene: RenderedScene, position: number, nowUs: number): void {
    this.try(() => this.predictor.draw(scene, position, nowUs));
  }

  get stats(): PredictorStats {
    return this.predictor.stats;
  }

  private follow(entity: number): void {
    if (entity === this.followed || this.serverControlled.has(entity)) return;
    this.followed = entity;
    this.correctionRate = 0;
    this.try(() => {
      this.predictor.follow(entity);
      if (entity === 0) return;
      this.frames = compared(this.predictor.stats, this.driving !== 0).times;
      // Two, for velocities.
      for (const frame of this.buffer.newestTwo) this.predictor.onFrame(frame, this.motion);
    });
  }

  private updateCorrectionRate(stats: PredictorStats): void {
    const { times, errorM } = compared(stats, this.driving !== 0);
    if (times === this.frames) return;
    this.frames = times;
    this.correctionRate += ERROR_DECAY_RATE * ((errorM > CORRECTION_THRESHOLD_M ? 1 : 0) - this.correctionRate);
    if (this.correctionRate < CORRECTION_RATE_MAX) return;
    const entity = this.followed;
    this.follow(0);
    this.serverControlled.add(entity);
  }

  private broken = false;
  private try(what: () => void): void {
    if (this.broken) return;
    try {
      what();
    } catch (error) {
      this.broken = true;
      this.followed = 0;
      this.failed(error);
    }
  }
}
