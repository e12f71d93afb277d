// Decides which body is predicted: the controlled entity, or else the grabbed or pushed body until it
// rests. Bodies with repeated corrections are left to the server. So are jointed bodies such as
// ragdolls, because clients do not know joints.

import type { PredictionListener, Input } from '../connection/connection.js';
import type { FrameBuffer, PoseFrame } from '../interpolation/frame_buffer.js';
import { InputCode, type Entity, type InputResult, type Welcome } from '../gen/jostle/v1/play_pb.js';
import type { ControlledEntity } from '../connection/word_changes.js';
import { MOTION_CHANNEL } from '../snapshot/channels.js';
import type { RenderedScene, Predictor, PredictorStats } from './predictor.js';

const CORRECTION_THRESHOLD_M = 0.05; // a frame with a larger error counts as a correction
const ERROR_DECAY_RATE = 1 / 30; // weight of each frame in the correction rate
const CORRECTION_RATE_MAX = 0.5;
const QUIET_FRAMES = 60; // after the last input

/** Number of comparisons of the followed body with the server, and the last error. */
function compared(stats: PredictorStats, controlled: boolean): { count: number; errorM: number } {
  return controlled ? { count: stats.controlUpdates, errorM: stats.lastControlErrorM } : { count: stats.frames, errorM: stats.lastErrorM };
}

export class PredictionController implements PredictionListener {
  /** 0: none. */
  followed = 0;
  private grabbed = false;
  private controlled = 0; // 0: none
  private velocityKind: number | undefined; // index of the velocity channel in Welcome.channels
  private correctionRate = 0; // fraction of frames
  private frames = 0; // compared so far
  private framesSinceInput = 0;
  private readonly serverControlled = new Set<number>(); // entities that are not predicted any more
  private readonly pendingTicks = new Map<number, number>(); // of inputs without a result, by sequence
  /** Number of inputs that the server applied later than meant, and of inputs that were predicted. */
  late = 0;
  sent = 0;

  constructor(
    private readonly predictor: Predictor,
    private readonly buffer: FrameBuffer,
    /** Called once if the predictor fails; nothing is predicted afterwards. */
    private readonly failed: (error: unknown) => void,
  ) {}

  begin({ tickHz, gravity, channels, substeps }: Welcome): void {
    const velocityKind = channels.findIndex(({ name }) => name === MOTION_CHANNEL);
    this.velocityKind = velocityKind < 0 ? undefined : velocityKind;
    this.followed = 0;
    this.grabbed = false;
    this.controlled = 0;
    this.serverControlled.clear();
    this.pendingTicks.clear();
    this.guard(() => this.predictor.begin(tickHz, gravity ?? { x: 0, y: 0, z: 0 }, substeps));
  }

  entityAdded(entity: Entity): void {
    this.guard(() => this.predictor.addBody(entity));
  }

  entityRemoved(entity: number): void {
    this.guard(() => this.predictor.removeBody(entity));
    if (entity === this.controlled) this.controlled = 0;
    if (entity === this.followed) this.follow(0);
  }

  controlledEntity(state: ControlledEntity | undefined): void {
    this.guard(() => this.predictor.setControlled(state));
  }

  input(sequence: number, tick: number, input: Input): void {
    const kind = input.kind;
    if (kind?.case === 'possess') {
      this.controlled = kind.value.entity ?? 0;
      this.follow(this.controlled);
    } else if (this.controlled !== 0) {
      // The controlled entity stays followed, even if other bodies are pushed.
    } else if (kind?.case === 'grab') this.follow(kind.value.entity ?? 0);
    else if (kind?.case === 'impulse' && !this.grabbed) this.follow(kind.value.entity ?? 0);
    if (kind?.case === 'grab' || kind?.case === 'release') this.grabbed = kind.case === 'grab';
    this.framesSinceInput = 0;
    if (tick === 0) return;
    if (!this.pendingTicks.has(sequence)) this.sent++;
    this.pendingTicks.set(sequence, tick);
    this.guard(() => this.predictor.addInput(sequence, tick, input));
  }

  result({ sequence, tick, code }: InputResult): void {
    if (tick > (this.pendingTicks.get(sequence) ?? tick)) this.late++;
    this.pendingTicks.delete(sequence);
    this.guard(() => this.predictor.onResult(sequence, tick, code === InputCode.APPLIED));
  }

  frame(frame: PoseFrame): void {
    if (this.followed === 0) return;
    this.guard(() => this.predictor.onFrame(frame, this.velocityKind));
    this.updateCorrectionRate(this.predictor.stats);
    const resting = frame.entities.find(({ id }) => id === this.followed)?.atRest ?? true;
    if (++this.framesSinceInput > QUIET_FRAMES && !this.grabbed && this.controlled === 0 && resting) this.follow(0);
  }

  /** Replaces the predicted poses of a rendered frame; `position`: of the input clock, in ticks. */
  applyTo(scene: RenderedScene, position: number, nowUs: number): void {
    this.guard(() => this.predictor.applyTo(scene, position, nowUs));
  }

  get stats(): PredictorStats {
    return this.predictor.stats;
  }

  private follow(entity: number): void {
    if (entity === this.followed || this.serverControlled.has(entity)) return;
    this.followed = entity;
    this.correctionRate = 0;
    this.guard(() => {
      this.predictor.follow(entity);
      if (entity === 0) return;
      this.frames = compared(this.predictor.stats, this.controlled !== 0).count;
      // Two frames, to estimate velocities.
      for (const frame of this.buffer.newestTwo) this.predictor.onFrame(frame, this.velocityKind);
    });
  }

  private updateCorrectionRate(stats: PredictorStats): void {
    const { count, errorM } = compared(stats, this.controlled !== 0);
    if (count === this.frames) return;
    this.frames = count;
    this.correctionRate += ERROR_DECAY_RATE * ((errorM > CORRECTION_THRESHOLD_M ? 1 : 0) - this.correctionRate);
    if (this.correctionRate < CORRECTION_RATE_MAX) return;
    const entity = this.followed;
    this.follow(0);
    this.serverControlled.add(entity);
  }

  private disabled = false;
  private guard(action: () => void): void {
    if (this.disabled) return;
    try {
      action();
    } catch (error) {
      this.disabled = true;
      this.followed = 0;
      this.failed(error);
    }
  }
}
