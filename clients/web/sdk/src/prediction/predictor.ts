// Predicts the effects of this client's inputs with the server's own solver, compiled to WebAssembly
// (predictor.wasm, built by scripts/build-predictor from clients/cpp/prediction). The counterpart of
// Predictor in the C++ client library: clients/cpp/prediction/include/jostle/client/predictor.h
// describes the algorithm, and clients/cpp/prediction/wasm/predictor_api.h the exported functions.

import type { PoseFrame } from '../interpolation/frame_buffer.js';
import { POSE_FLOATS } from '../interpolation/frame_buffer.js';
import type { Input } from '../connection/connection.js';
import type { Entity } from '../gen/jostle/v1/play_pb.js';
import { BodyType, type Locks } from '../gen/jostle/v1/scene_pb.js';
import type { ControlledEntity } from '../connection/word_changes.js';
import { encodeShapes } from './shape_encoding.js';

/** The module cannot be loaded, or it failed and cannot be used any more. */
export class PredictorError extends Error {}

type Pointer = number;

/** The exports of predictor.wasm. */
export interface PredictorExports {
  readonly memory: WebAssembly.Memory;
  _initialize?(): void;
  create(): Pointer;
  destroy(p: Pointer): void;
  buffer(p: Pointer, count: number): Pointer;
  begin(p: Pointer, tickHz: number, x: number, y: number, z: number, substeps: number): void;
  add_body(p: Pointer, entity: number, type: number, mass: number): void;
  set_body(p: Pointer, entity: number, linearDamping: number, angularDamping: number, gravityScale: number, locks: number, movedBy: number): void;
  remove_body(p: Pointer, entity: number): void;
  set_shapes(p: Pointer, entity: number, count: number): number;
  follow(p: Pointer, entity: number): void;
  push(p: Pointer, sequence: number, tick: number, entity: number, x: number, y: number, z: number): void;
  push_at(p: Pointer, sequence: number, tick: number, entity: number, x: number, y: number, z: number, px: number, py: number, pz: number): void;
  grab(p: Pointer, sequence: number, tick: number, entity: number, x: number, y: number, z: number): void;
  drag(p: Pointer, sequence: number, tick: number, x: number, y: number, z: number): void;
  release(p: Pointer, sequence: number, tick: number): void;
  steer(p: Pointer, sequence: number, tick: number, axes: number, buttons: number): void;
  result(p: Pointer, sequence: number, tick: number, applied: number): void;
  velocities(p: Pointer, bodies: number): number;
  control(p: Pointer, entity: number, tick: number, letters: number, words: number): number;
  frame(p: Pointer, number: number, bodies: number): number;
  predicted(p: Pointer): number;
  sample(p: Pointer, position: number, nowUs: number, bodies: number): number;
  stat(p: Pointer, which: number): number;
}

const WASI = 'wasi_snapshot_preview1';
const NOT_SUPPORTED = 58; // WASI errno notsup
const FRAME_VALUES = 9;
const POSE_VALUES = 8;
const VELOCITY_VALUES = 7;
const NO_CONTROLLED_ENTITY: ControlledEntity = { entity: 0, tick: 0, module: '', words: new Uint32Array(0) };

/** AxisLocks of the solver. */
function lockBits(locks: Locks | undefined): number {
  if (!locks) return 0;
  const { x, y, z, turnX, turnY, turnZ } = locks;
  return [x, y, z, turnX, turnY, turnZ].reduce((bits, locked, k) => bits | (locked ? 1 << k : 0), 0);
}

/** The system calls of the C++ library; only the clock is supported. */
function system(module: WebAssembly.Module, memory: () => WebAssembly.Memory): WebAssembly.ModuleImports {
  const api: WebAssembly.ModuleImports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) if (from === WASI) api[name] = () => NOT_SUPPORTED;
  api['clock_time_get'] = (_clock: number, _precision: bigint, at: number) => {
    new DataView(memory().buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
    return 0;
  };
  api['proc_exit'] = (code: number) => {
    throw new PredictorError(`the predictor exited with code ${code}`);
  };
  return api;
}

/**
 * Instantiates a compiled module. `onShapesRequested` is called when it needs the shapes of an entity.
 */
export async function instantiate(module: WebAssembly.Module, onShapesRequested: (entity: number) => void): Promise<PredictorExports> {
  let api: PredictorExports | undefined;
  const imports = {
    [WASI]: system(module, () => api!.memory),
    jostle: { request_shapes: (_predictor: Pointer, entity: number) => onShapesRequested(entity) },
  };
  api = (await WebAssembly.instantiate(module, imports)).exports as unknown as PredictorExports;
  api._initialize?.();
  return api;
}

/** Compiles the bytes of predictor.wasm, or of the response that has them. Throws PredictorError. */
export async function compile(source: BufferSource | Promise<Response>): Promise<WebAssembly.Module> {
  try {
    if (!(source instanceof Promise)) return await WebAssembly.compile(source);
    const response = await source;
    if (!response.ok) throw new Error(`HTTP status ${response.status}`);
    return await WebAssembly.compile(await response.arrayBuffer());
  } catch (error) {
    throw new PredictorError(`predictor.wasm cannot be loaded: ${error instanceof Error ? error.message : error}`);
  }
}

export interface PredictorStats {
  readonly frames: number; // compared frames
  readonly corrections: number; // frames that differed from the prediction
  readonly steps: number; // simulated steps, repeated ones included
  readonly lastErrorM: number; // largest error of the last frame, before its correction
  readonly bodies: number; // predicted bodies
  readonly unusable: number; // bodies with shapes that the solver does not support
  readonly controlUpdates: number; // compared states of the controlled entity
  readonly controlCorrections: number; // states that differed from the prediction
  readonly lastControlErrorM: number; // error of the last state
}

/** Poses of a rendered frame, in which predicted poses are replaced (RenderedPoses). */
export interface RenderedScene {
  readonly poses: Float64Array;
  /** -1: not in the rendered frame. */
  indexOf(entity: number): number;
}

const TYPES: Partial<Record<BodyType, number>> = { [BodyType.KINEMATIC]: 1, [BodyType.DYNAMIC]: 2 };

export class Predictor {
  private readonly entities = new Map<number, Entity>();
  private api!: PredictorExports;
  private self: Pointer = 0;

  private constructor() {}

  static async create(module: WebAssembly.Module): Promise<Predictor> {
    const predictor = new Predictor();
    try {
      predictor.api = await instantiate(module, (entity) => predictor.sendShapes(entity));
      predictor.self = predictor.api.create();
    } catch (error) {
      throw new PredictorError(`predictor.wasm cannot be started: ${error instanceof Error ? error.message : error}`);
    }
    return predictor;
  }

  /** Starts a stream and resets the predictor. Gravity in m/s^2; `substeps` per tick, 0: 8. */
  begin(tickHz: number, gravity: { readonly x: number; readonly y: number; readonly z: number }, substeps = 0): void {
    this.entities.clear();
    this.api.begin(this.self, tickHz, gravity.x, gravity.y, gravity.z, substeps);
  }

  addBody(entity: Entity): void {
    this.entities.set(entity.id, entity);
    this.api.add_body(this.self, entity.id, TYPES[entity.type] ?? 0, entity.mass);
    const { id, linearDamping, angularDamping, gravityScale = 1, locks, controllable, jointed } = entity;
    this.api.set_body(this.self, id, linearDamping, angularDamping, gravityScale, lockBits(locks), (controllable ? 1 : 0) + (jointed ? 2 : 0));
  }

  removeBody(entity: number): void {
    this.entities.delete(entity);
    this.api.remove_body(this.self, entity);
  }

  /** Selects the body to predict; 0: none. */
  follow(entity: number): void {
    this.api.follow(this.self, entity);
  }

  /** An input for a tick. Inputs other than impulses, grabs, drags and controls are ignored. */
  addInput(sequence: number, tick: number, { kind }: Input): void {
    const { api, self } = this;
    switch (kind?.case) {
      case 'impulse': {
        const { entity = 0, impulse: i, point: p } = kind.value;
        const [x, y, z] = [i?.x ?? 0, i?.y ?? 0, i?.z ?? 0];
        if (p) return api.push_at(self, sequence, tick, entity, x, y, z, p.x ?? 0, p.y ?? 0, p.z ?? 0);
        return api.push(self, sequence, tick, entity, x, y, z);
      }
      case 'grab': {
        const { entity = 0, point: p } = kind.value;
        return api.grab(self, sequence, tick, entity, p?.x ?? 0, p?.y ?? 0, p?.z ?? 0);
      }
      case 'drag': {
        const { target: t } = kind.value;
        return api.drag(self, sequence, tick, t?.x ?? 0, t?.y ?? 0, t?.z ?? 0);
      }
      case 'release':
        return api.release(self, sequence, tick);
      case 'control': {
        const { axes = [], buttons = 0 } = kind.value;
        this.buffer(axes.length).set(axes.map((thousandths) => thousandths / 1000));
        return api.steer(self, sequence, tick, axes.length, buttons);
      }
      case 'possess': // releases the controlled entity
        return api.steer(self, sequence, tick, 0, 0);
    }
  }

  /** The result of an input. */
  onResult(sequence: number, tick: number, applied: boolean): void {
    this.api.result(this.self, sequence, tick, applied ? 1 : 0);
  }

  /** State of the controlled entity, before the frame of its tick; undefined: none is known. */
  setControlled(state: ControlledEntity | undefined): void {
    const { entity, tick, module, words } = state ?? NO_CONTROLLED_ENTITY;
    const numbers = this.buffer(module.length + words.length);
    for (let k = 0; k < module.length; k++) numbers[k] = module.charCodeAt(k);
    numbers.set(words, module.length);
    this.api.control(this.self, entity, tick, module.length, words.length);
  }

  /** `velocityKind`: index of the velocity channel in Welcome.channels, if there is one. */
  onFrame({ frame, entities, poses, channels }: PoseFrame, velocityKind?: number): void {
    const velocities = channels.filter(({ kind, values }) => kind === velocityKind && values.length === VELOCITY_VALUES - 1);
    const velocityValues = this.buffer(velocities.length * VELOCITY_VALUES);
    velocities.forEach(({ entity, values }, i) => {
      velocityValues[i * VELOCITY_VALUES] = entity;
      velocityValues.set(values, i * VELOCITY_VALUES + 1);
    });
    this.api.velocities(this.self, velocities.length);
    const numbers = this.buffer(entities.length * FRAME_VALUES);
    for (let i = 0; i < entities.length; i++) {
      const { id, atRest } = entities[i]!;
      const to = i * FRAME_VALUES;
      numbers[to] = id;
      for (let k = 0; k < POSE_FLOATS; k++) numbers[to + 1 + k] = poses[i * POSE_FLOATS + k]!;
      numbers[to + 8] = atRest ? 1 : 0;
    }
    this.api.frame(this.self, frame, entities.length);
  }

  /**
   * Replaces the predicted poses of a rendered frame and returns their number; `position`: of the input
   * clock, in ticks.
   */
  applyTo(scene: RenderedScene, position: number, nowUs: number): number {
    const { api, self } = this;
    const ids = this.buffer(api.predicted(self)).slice();
    const numbers = this.buffer(ids.length * POSE_VALUES);
    let count = 0;
    for (const id of ids) {
      const i = scene.indexOf(id);
      if (i < 0) continue;
      const to = count++ * POSE_VALUES;
      numbers[to] = id;
      for (let k = 0; k < POSE_FLOATS; k++) numbers[to + 1 + k] = scene.poses[i * POSE_FLOATS + k]!;
    }
    if (api.sample(self, position, nowUs, count) !== count) return 0;
    const results = this.buffer(ids.length * POSE_VALUES);
    for (let n = 0; n < count; n++) {
      const from = n * POSE_VALUES;
      const i = scene.indexOf(results[from]!);
      for (let k = 0; k < POSE_FLOATS; k++) scene.poses[i * POSE_FLOATS + k] = results[from + 1 + k]!;
    }
    return count;
  }

  get stats(): PredictorStats {
    const stat = (which: number) => this.api.stat(this.self, which);
    return { frames: stat(0), corrections: stat(1), steps: stat(2), lastErrorM: stat(3), bodies: stat(4), unusable: stat(5), controlUpdates: stat(6), controlCorrections: stat(7), lastControlErrorM: stat(8) };
  }

  /** The module's number buffer. Valid until the next call, because the memory may move. */
  private buffer(count: number): Float64Array {
    const at = this.api.buffer(this.self, count);
    if (at === 0 && count > 0) throw new PredictorError(`the predictor cannot allocate ${count} numbers`);
    return new Float64Array(this.api.memory.buffer, at, count);
  }

  private sendShapes(id: number): void {
    const numbers = encodeShapes(this.entities.get(id)?.shapes ?? []);
    if (!numbers) return;
    this.buffer(numbers.length).set(numbers);
    this.api.set_shapes(this.self, id, numbers.length);
  }
}
