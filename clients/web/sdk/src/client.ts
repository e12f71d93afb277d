// The client of the public API: one connection to one world, with smooth poses, inputs and optional
// prediction.

import { nowUs } from './clock/clock_sync.js';
import { Connection, type AreaOfInterest, type Precision, type ConnectionListener, type ConnectionState, type Input, type Socket } from './connection/connection.js';
import type { ListedJoint } from './connection/joint_list.js';
import type { MessageInitShape } from '@bufbuild/protobuf';
import type { AttributeTarget, AttributeValue, WorldData } from './connection/world_data.js';
import { AttributeVisibility, type CloneInputSchema, type CreateJointInputSchema, type EditInputSchema, type Entity, type RoomInputSchema } from './gen/jostle/v1/play_pb.js';
import type { PointObjectView } from './interpolation/point_objects.js';
import { RenderedPoses } from './interpolation/rendered_poses.js';
import { MOTION_CHANNEL } from './snapshot/channels.js';
import type { PredictionController } from './prediction/prediction_controller.js';

/** A command about a room in the form of proto RoomInput. */
export type RoomCommand = MessageInitShape<typeof RoomInputSchema>;

/** The joint of Client.createJoint() in the form of proto CreateJointInput. */
export type NewJoint = MessageInitShape<typeof CreateJointInputSchema>;

/** The changes of Client.edit() in the form of proto EditInput; absent fields stay unchanged. */
export type BodyEdit = Omit<MessageInitShape<typeof EditInputSchema>, '$typeName' | 'entity'>;

/** Options of Client.clone() in the form of proto CloneInput. */
export type CloneOptions = Omit<MessageInitShape<typeof CloneInputSchema>, '$typeName' | 'entity'>;

/** A vector in the world: m, m/s or N s. */
export interface Vector {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export interface ConnectOptions {
  /** WebSocket URL of the play stream, such as `ws://127.0.0.1:8080/play`. */
  readonly url: string;
  /** Id or name of a world; default: the server's first world. */
  readonly world?: string;
  /** Bearer token of the user; default: none. */
  readonly token?: string;
  /** Join code of a private room; default: none. */
  readonly joinCode?: string;
  /** Kinds of module channels to receive, at most 64 (PoseFrame.channels); default: none. */
  readonly channels?: readonly string[];
  /** The part of the world to receive; default: the whole world. */
  readonly areaOfInterest?: AreaOfInterest;
  /** Precision of the poses for this client; default: that of the world. */
  readonly precision?: Precision;
  /** Whether to receive joints (Client.joints); default: false. */
  readonly joints?: boolean;
  /** Whether to receive events (ConnectionListener.worldEvents); default: false. */
  readonly events?: boolean;
  /** Display name, at most 32 bytes; default: "browser". */
  readonly name?: string;
  /** 0xRRGGBB, of the player; default: none. */
  readonly color?: number;
  /** Whether to receive the player list (Client.data); default: false. */
  readonly players?: boolean;
  /** Whether to receive attributes (Client.data); default: false. */
  readonly attributes?: boolean;
  /** Whether to receive the settings of the room (Client.data); default: false. */
  readonly room?: boolean;
  /** Topics of user messages to receive (ConnectionListener.userMessage), at most 64; "*": all; default: none. */
  readonly topics?: readonly string[];
  /**
   * Predicts the effects of own inputs; default: false. Pass the bytes of predictor.wasm where `fetch`
   * cannot read the package, as in Node: `await readFile(predictorUrl)` with `predictorUrl` of
   * `@jostle/client/prediction`.
   */
  readonly prediction?: boolean | BufferSource;
  /** Callbacks; all are optional. */
  readonly listener?: Partial<ConnectionListener>;
  /** ms until connect() gives up; default: 10 000. */
  readonly timeoutMs?: number;
  /**
   * Opens the socket; default: a WebSocket. For tests, simulated networks, recordings and runtimes
   * without WebSocket.
   */
  readonly openSocket?: (url: string) => Socket;
}

/** The server is unreachable, or it rejected the client. */
export class ConnectError extends Error {}

const TIMEOUT_MS = 10_000;

const bytesOf = (data: string | Uint8Array) => (typeof data === 'string' ? new TextEncoder().encode(data) : new Uint8Array(data));

function targetMessage(target: AttributeTarget) {
  return target.kind === 'world' ? { case: 'world' as const, value: true } : { case: target.kind, value: target.id };
}

function valueMessage(value: AttributeValue | undefined) {
  switch (typeof value) {
    case 'boolean':
      return { case: 'boolean' as const, value };
    case 'bigint':
      return { case: 'integer' as const, value };
    case 'number':
      return { case: 'number' as const, value };
    case 'string':
      return { case: 'text' as const, value };
    case 'object':
      return { case: 'vector' as const, value };
    default:
      return { case: undefined };
  }
}

/**
 * Joins a world. Resolves once the server has accepted the client; poses are available from the first
 * frame on. Rejects with ConnectError if the server rejects the client or does not respond in time, and
 * with PredictorError if prediction is requested but predictor.wasm cannot be loaded.
 */
export async function connect(options: ConnectOptions): Promise<Client> {
  const { prediction = false, timeoutMs = TIMEOUT_MS } = options;
  const client = new Client(options);
  if (prediction !== false) await client.loadPrediction(prediction === true ? undefined : prediction);
  await client.join(options.world ?? '', timeoutMs);
  return client;
}

export class Client {
  /** The underlying connection, for its statistics, clocks and frames. */
  readonly connection: Connection;
  private readonly listener: Partial<ConnectionListener>;
  private readonly poses = new RenderedPoses();
  private prediction: PredictionController | undefined;
  private onState: ((state: ConnectionState, reason: string) => void) | undefined;

  /** Use connect(). */
  constructor(options: ConnectOptions) {
    const { url, token, joinCode, channels = [], areaOfInterest, precision, joints = false, events = false, prediction = false, listener = {} } = options;
    this.listener = listener;
    const channelKinds = prediction === false ? channels : [...channels, MOTION_CHANNEL];
    const forward: ConnectionListener = {
      state: (state, reason) => {
        this.onState?.(state, reason);
        listener.state?.(state, reason);
      },
      entityList: (entities) => listener.entityList?.(entities),
      stats: (stats) => listener.stats?.(stats),
      worldEvents: (worldEvents) => listener.worldEvents?.(worldEvents),
      inputRejected: (result) => listener.inputRejected?.(result),
      notice: (text) => listener.notice?.(text),
      joints: (list) => listener.joints?.(list),
      userMessage: (message) => listener.userMessage?.(message),
      playerEvent: (event) => listener.playerEvent?.(event),
      dataChanged: (data) => listener.dataChanged?.(data),
    };
    const { name, color, players, attributes, room, topics } = options;
    this.connection = new Connection({
      url, listener: forward, openSocket: options.openSocket, token, joinCode, channelKinds, areaOfInterest, precision, joints, name, color, players, attributes, room, topics,
    });
    this.connection.setEventsEnabled(events);
  }

  /** Called by connect(). */
  async loadPrediction(module: BufferSource | undefined): Promise<void> {
    const { loadPrediction } = await import('./prediction/index.js');
    const failed = (error: unknown) => {
      this.prediction = undefined;
      this.listener.notice?.(`prediction is disabled: ${error instanceof Error ? error.message : String(error)}`);
    };
    this.prediction = await loadPrediction(this.connection.frames, failed, module);
    this.connection.enablePrediction(this.prediction);
  }

  /** Called by connect(). */
  async join(world: string, timeoutMs: number): Promise<void> {
    let timer: ReturnType<typeof setTimeout> | undefined;
    try {
      await new Promise<void>((resolve, reject) => {
        let lastReason = 'the server does not respond';
        timer = setTimeout(() => reject(new ConnectError(`${this.connection.url}: ${lastReason}`)), timeoutMs);
        this.onState = (state, reason) => {
          lastReason = reason || lastReason;
          if (state === 'playing') resolve();
          if (state === 'stopped' && reason) reject(new ConnectError(`${this.connection.url}: ${reason}`));
        };
        this.connection.join(world);
      });
    } catch (error) {
      this.close();
      throw error;
    } finally {
      clearTimeout(timer);
      this.onState = undefined;
    }
  }

  get state(): ConnectionState {
    return this.connection.state;
  }

  /** The id that the server assigned; Entity.owner has it for own bodies. */
  get clientId(): number {
    return this.connection.welcome?.clientId ?? 0;
  }

  /** All entities of the world by id: shapes, names, masses and owners. Poses are separate: sample(). */
  get entities(): ReadonlyMap<number, Entity> {
    return this.connection.entities;
  }

  /** Joints of the world by id, if ConnectOptions.joints is set. */
  get joints(): ReadonlyMap<number, ListedJoint> {
    return this.connection.joints.joints;
  }

  /**
   * Point objects by id, with their positions as of the last sample(): ropes, cloth, particles and
   * heights of the channel kinds in ConnectOptions.channels.
   */
  get points(): ReadonlyMap<number, PointObjectView> {
    return this.connection.points.objects;
  }

  /**
   * Computes the poses to render now: interpolated between frames, slightly in the past, and predicted
   * for own inputs. Call it once per rendered frame. Returns the same object every time, valid until
   * the next call: `count` entities with ascending `ids`, and seven numbers per entity in `poses`:
   * position in m, rotation as a quaternion x y z w.
   */
  sample(localUs = nowUs()): RenderedPoses {
    const renderTimeUs = this.connection.renderClock.advance(localUs);
    this.poses.update(this.connection.frames, renderTimeUs, localUs);
    this.connection.samplePoints();
    this.prediction?.applyTo(this.poses, this.connection.inputClock.position(localUs), localUs);
    return this.poses;
  }

  /**
   * Pose of an entity as of the last sample(): px py pz in m, qx qy qz qw; undefined: not in that
   * frame.
   */
  poseOf(entity: number): Float64Array | undefined {
    return this.poses.poseOf(entity);
  }

  /**
   * Sends an input. The server applies it in the next tick, or in the tick that prediction sets.
   * Rejected inputs are reported to ConnectionListener.inputRejected. Does nothing while the client is
   * not connected.
   */
  send(kind: NonNullable<Input['kind']>): void {
    this.connection.send({ kind });
  }

  /**
   * Applies an impulse in N s to a body; `point`: where, in the world, default: the center of mass. The
   * server limits the velocity change to 20 m/s.
   */
  applyImpulse(entity: number, impulse: Vector, point?: Vector): void {
    this.send({ case: 'impulse', value: point ? { entity, impulse, point } : { entity, impulse } });
  }

  /**
   * Attaches a spring to a point of a body, in the world; drag() moves its other end. A client grabs
   * one thing at a time.
   */
  grab(entity: number, point: Vector): void {
    this.send({ case: 'grab', value: { entity, point } });
  }

  /** The same for the point of a rope or cloth (PointObject.id) that is nearest to `point`. */
  grabPoint(object: number, point: Vector): void {
    this.send({ case: 'grab', value: { object, point } });
  }

  /** Cuts a rope or tears a cloth (PointObject.id) at its inner point nearest to `point`, in the world. */
  cut(object: number, point: Vector): void {
    this.send({ case: 'cut', value: { object, point } });
  }

  /** Moves the target of the grabbed point, in the world. */
  drag(target: Vector): void {
    this.send({ case: 'drag', value: { target } });
  }

  /** Releases what the client has grabbed. */
  release(): void {
    this.send({ case: 'release', value: {} });
  }

  /**
   * Takes control of an entity with Entity.controllable that no other client controls; 0: releases
   * control.
   */
  takeControl(entity: number): void {
    this.send({ case: 'possess', value: { entity } });
  }

  /**
   * Input for the controlled entity until the next call: at most eight axes from -1 to 1, and a bit per
   * button. Modules define their meaning.
   */
  control(axes: readonly number[], buttons = 0): void {
    this.send({ case: 'control', value: { axes: axes.map((axis) => Math.round(1000 * axis)), buttons } });
  }

  /**
   * Sends a command about the room: moderation, roles, votes and protected areas. The role of this
   * client must permit it.
   */
  room(kind: NonNullable<RoomCommand['kind']>): void {
    this.send({ case: 'room', value: { kind } });
  }

  /**
   * Changes the pose, velocity, mass, density, friction, restitution, colour or gravity scale of a body,
   * or freezes it.
   */
  edit(entity: number, changes: BodyEdit): void {
    this.send({ case: 'edit', value: { ...changes, entity } });
  }

  /** Spawns a copy of a body, or with `jointed` of all bodies that joints connect to it. */
  clone(entity: number, options: CloneOptions): void {
    this.send({ case: 'clone', value: { ...options, entity } });
  }

  /** Joins two bodies, or a body and the world (entityA 0). InputResult.joint is the id of the joint. */
  createJoint(joint: NewJoint): void {
    this.send({ case: 'createJoint', value: joint });
  }

  /** Deletes a joint (ListedJoint.id). */
  deleteJoint(joint: number): void {
    this.send({ case: 'deleteJoint', value: { joint } });
  }

  /** Reverts the newest spawn, clone, deletion, edit or change of a joint by this client. */
  undo(): void {
    this.send({ case: 'undo', value: {} });
  }

  /** Steps a room that a member paused. */
  stepRoom(steps = 1): void {
    this.room({ case: 'step', value: { steps } });
  }

  /** Runs the room at a share of real time: 5 to 100 percent, a multiple of 5. */
  setRoomSpeed(percent: number): void {
    this.room({ case: 'speed', value: { percent } });
  }

  /** Continues the room from one of WorldStats.restorableTicks. */
  rewindRoom(tick: number): void {
    this.room({ case: 'rewind', value: { tick } });
  }

  /** Players, attributes and the room, for clients that subscribed to them. */
  get data(): WorldData {
    return this.connection.data;
  }

  /**
   * Sends a user message to all clients of the world, or to some of them. A text is sent as UTF-8.
   * `topic`: 1 to 32 of the characters a-z, 0-9, _ and dot.
   */
  sendMessage(topic: string, data: string | Uint8Array, to: readonly number[] = []): void {
    this.send({ case: 'sendMessage', value: { topic, data: bytesOf(data), to: [...to] } });
  }

  /** Sends a user message to the server alone. */
  sendToServer(topic: string, data: string | Uint8Array): void {
    this.send({ case: 'sendMessage', value: { topic, data: bytesOf(data), toServer: true } });
  }

  /**
   * Sets attributes of a target; undefined removes one. All are set or none. `visibility`: the clients
   * that receive them; default: all. `roles`: one bit per PlayerRole, with AttributeVisibility.ROLES.
   */
  setAttributes(
    target: AttributeTarget,
    values: Readonly<Record<string, AttributeValue | undefined>>,
    visibility = AttributeVisibility.EVERYONE,
    roles = 0,
  ): void {
    const attributes = Object.entries(values).map(([key, value]) => ({ key, value: valueMessage(value), visibility, roles }));
    this.send({ case: 'setAttributes', value: { set: { target: targetMessage(target), attributes } } });
  }

  /** Changes the display name, 1 to 32 bytes. */
  rename(name: string): void {
    this.send({ case: 'rename', value: { name } });
  }

  /** Leaves the world and closes the connection. */
  close(): void {
    this.connection.stop();
  }
}
