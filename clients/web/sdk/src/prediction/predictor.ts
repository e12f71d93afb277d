// Foresees what the inputs of this client do, with the server's own solver as WebAssembly (predictor.wasm, built by
// scripts/build-predictor of clients/cpp/prediction). It is the C++ client's Predictor: what it does, and how it is put right, is in
// clients/cpp/prediction/include/jostle/client/predictor.h, its calls in clients/cpp/prediction/wasm/predictor_api.h.

import type { PoseFrame } from '../interpolation/frame_buffer.js';
import { POSE_FLOATS } from '../interpolation/frame_buffer.js';
import type { Input } from '../connection/connection.js';
import type { Entity } from '../gen/jostle/v1/play_pb.js';
import { BodyType, type Locks } from '../gen/jostle/v1/scene_pb.js';
import type { ControlledEntity } from '../connection/word_changes.js';
import { encodeShapes } from './shape_encoding.js';

/** The module cannot be loaded, or has failed and is of no use any more. */
export class PredictorError extends Error {}

type Pointer = number;

/** What predictor.wasm exports. */
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
const NOT_SUPPORTED = 58; // of WASI's errors
const FRAME_NUMBERS = 9;
const DRAWN_NUMBERS = 8;
const MOTION_NUMBERS = 7;
const NO_CONTROLLED_ENTITY: ControlledEntity = { entity: 0, tick: 0, module: '', words: new Uint32Array(0) };

/** AxisLocks of the solver. */
function lockBits(locks: Locks | undefined): number {
  if (!locks) return 0;
  const { x, y, z, turnX, turnY, turnZ } = locks;
  return [x, y, z, turnX, turnY, turnZ].reduce((bits, locked, k) => bits | (locked ? 1 << k : 0), 0);
}

/** What the C++ library asks of a system: the time, and nothing else that it would get. */
function system(module: WebAssembly.Module, memory: () => WebAssembly.Memory): WebAssembly.ModuleImports {
  const api: WebAssembly.ModuleImports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) if (from === WASI) api[name] = () => NOT_SUPPORTED;
  api['clock_time_get'] = (_clock: number, _precision: bigint, at: number) => {
    new DataView(memory().buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
    return 0;
  };
  api['proc_exit'] = (code: number) => {
    throw new PredictorError(`the predictor ended itself with ${code}`);
  };
  return api;
}

/** Instantiates a compiled module; `asked` is told whose shapes are wanted. */
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

/** From the bytes of predictor.wasm, or from the answer that brings them. */
export async function compile(source: BufferSource | Promise<Response>): Promise<WebAssembly.Module> {
  try {
    if (!(source instanceof Promise)) return await WebAssembly.compile(source);
    const answer = await source;
    if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
    return await WebAssembly.compile(await answer.arrayBuffer());
  } catch (error) {
    throw new PredictorError(`predictor.wasm cannot be loaded: ${error instanceof Error ? error.message : error}`);
  }
}

export interface PredictorStats {
  readonly frames: number; // that were compared
  readonly corrections: number; // of them: that were not what was foreseen
  readonly steps: number; // that were taken, again or not
  readonly lastErrorM: number; // greatest of the last frame, before it was corrected
  readonly bodies: number; // that are foreseen
  readonly unusable: number; // bodies whose shapes the solver cannot have
  readonly controlUpdates: number; // times that what is driven was compared
  readonly controlCorrections: number; // of them: that were not what was foreseen
  readonly lastControlErrorM: number; // of the last one
}

/** Poses of a picture, which are replaced where they are foreseen (RenderedPoses). */
export interface RenderedScene {
  readonly poses: Float64Array;
  /** -1: it is not in the picture. */
  indexOf(entity: number): number;
}

const TYPES: Partial<Record<BodyType, number>> = { [BodyType.KINEMATIC]: 1, [BodyType.DYNAMIC]: 2 };

export class Predictor {
  private readonly entities = new Map<number, Entity>();
  private api!: PredictorExports;
  private self: Pointer = 0;

  private constructor() {}

  static async create(module: WebAssembly.Module): Promise<Predictor> {
    const made = new Predictor();
    try {
      made.api = await instantiate(module, (entity) => made.sendShapes(entity));
      made.self = made.api.create();
    } catch (error) {
      throw new PredictorError(`predictor.wasm cannot be started: ${error instanceof Error ? error.message : error}`);
    }
    return made;
  }

  /** A stream begins: everything is forgotten. */
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

  /** Whose motion is foreseen; 0: nobody's. */
  follow(entity: number): void {
    this.api.follow(this.self, entity);
  }

  /** An input of that number that is meant for that tick; what is none of a hand or a push does nothing. */
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
        this.room(axes.length).set(axes.map((thousandths) => thousandths / 1000));
        return api.steer(self, sequence, tick, axes.length, buttons);
      }
      case 'possess': // lets go of what was driven
        return api.steer(self, sequence, tick, 0, 0);
    }
  }

  /** What became of one. */
  onResult(sequence: number, tick: number, applied: boolean): void {
    this.api.result(this.self, sequence, tick, applied ? 1 : 0);
  }

  /** What is driven, before the frame of its tick; undefined: nothing that is known. */
  drive(thing: ControlledEntity | undefined): void {
    const { entity, tick, module, words } = thing ?? NO_CONTROLLED_ENTITY;
    const numbers = this.room(module.length + words.length);
    for (let k = 0; k < module.length; k++) numbers[k] = module.charCodeAt(k);
    numbers.set(words, module.length);
    this.api.control(this.self, entity, tick, module.length, words.length);
  }

  /** `motion`: the number of the kind MOTION (motion.ts), where that is told. */
  onFrame({ frame, entities, poses, channels }: PoseFrame, motion?: number): void {
    const motions = channels.filter(({ kind, values }) => kind === motion && values.length === MOTION_NUMBERS - 1);
    const moves = this.room(motions.length * MOTION_NUMBERS);
    motions.forEach(({ entity, values }, i) => {
      moves[i * MOTION_NUMBERS] = entity;
      moves.set(values, i * MOTION_NUMBERS + 1);
    });
    this.api.velocities(this.self, motions.length);
    const numbers = this.room(entities.length * FRAME_NUMBERS);
    for (let i = 0; i < entities.length; i++) {
      const { id, atRest } = entities[i]!;
      const to = i * FRAME_NUMBERS;
      numbers[to] = id;
      for (let k = 0; k < POSE_FLOATS; k++) numbers[to + 1 + k] = poses[i * POSE_FLOATS + k]!;
      numbers[to + 8] = atRest ? 1 : 0;
    }
    this.api.frame(this.self, frame, entities.length);
  }

  /** Puts what is foreseen into the picture of now: at that place of the input clock, in ticks. How many bodies that are. */
  draw(scene: RenderedScene, position: number, nowUs: number): number {
    const { api, self } = this;
    const wanted = this.room(api.predicted(self)).slice();
    const numbers = this.room(wanted.length * DRAWN_NUMBERS);
    let count = 0;
    for (const id of wanted) {
      const i = scene.indexOf(id);
      if (i < 0) continue;
      const to = count++ * DRAWN_NUMBERS;
      numbers[to] = id;
      for (let k = 0; k < POSE_FLOATS; k++) numbers[to + 1 + k] = scene.poses[i * POSE_FLOATS + k]!;
    }
    if (api.sample(self, position, nowUs, count) !== count) return 0;
    const answer = this.room(wanted.length * DRAWN_NUMBERS);
    for (let n = 0; n < count; n++) {
      const from = n * DRAWN_NUMBERS;
      const i = scene.indexOf(answer[from]!);
      for (let k = 0; k < POSE_FLOATS; k++) scene.poses[i * POSE_FLOATS + k] = answer[from + 1 + k]!;
    }
    return count;
  }

  get stats(): PredictorStats {
    const figure = (which: number) => this.api.stat(this.self, which);
    return { frames: figure(0), corrections: figure(1), steps: figure(2), lastErrorM: figure(3), bodies: figure(4), unusable: figure(5), controlUpdates: figure(6), controlCorrections: figure(7), lastControlErrorM: figure(8) };
  }

  /** The predictor's list of numbers. Good until the next call: its memory may move. */
  private room(count: number): Float64Array {
    const at = this.api.buffer(this.self, count);
    if (at === 0 && count > 0) throw new PredictorError(`the predictor has no room for ${count} numbers`);
    return new Float64Array(this.api.memory.buffer, at, count);
  }

  private sendShapes(id: number): void {
    const numbers = encodeShapes(this.entities.get(id)?.shapes ?? []);
    if (!numbers) return;
    this.room(numbers.length).set(numbers);
    this.api.set_shapes(this.self, id, numbers.length);
  }
}
