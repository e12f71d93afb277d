// The play stream over a WebSocket: hello, acks, input batches, pings and reconnecting. It renders
// nothing.

import { clone, create, fromBinary, toBinary, type MessageInitShape } from '@bufbuild/protobuf';
import { ClockSync, nowUs } from '../clock/clock_sync.js';
import { baselineFrames } from '../snapshot/baseline_frames.js';
import {
  DecodeError,
  NEWEST_CODEC,
  decodeFrame,
  frameCrc,
  isValidSpec,
  type Baselines,
  type QuantSpec,
  type QuantizedFrame,
} from '../snapshot/decode_frame.js';
import { decodeEntityList } from '../snapshot/entity_list.js';
import { InterestCells } from '../snapshot/interest_cells.js';
import { FrameBuffer, type PoseFrame } from '../interpolation/frame_buffer.js';
import { PointObjects } from '../interpolation/point_objects.js';
import { InputClock } from '../clock/input_clock.js';
import { InputQueue } from './input_queue.js';
import { JointList } from './joint_list.js';
import { LargeShapes } from './large_shapes.js';
import { RenderClock } from '../clock/render_clock.js';
import { renderedTime } from '../interpolation/rendered_time.js';
import { decodeChannels } from '../snapshot/channels.js';
import { ControlledStateDecoder, type ControlledEntity } from './word_changes.js';
import { WorldData } from './world_data.js';
import {
  AckSchema,
  ClientMessageSchema,
  EntitySchema,
  InputCode,
  InterestSchema,
  NoticeCode,
  ServerMessageSchema,
  type Entity,
  type Events as WorldEvents,
  type InputResult,
  type InputSchema,
  type Notice,
  type PlayerEvent,
  type EntityUpdate,
  type JointUpdate,
  type ServerMessage,
  type Snapshot,
  type UserMessage,
  type Welcome,
  type WorldStats,
} from '../gen/jostle/v1/play_pb.js';

/** The part of a world that a client subscribes to (proto Interest). */
export interface AreaOfInterest {
  /** m, horizontally around the focus, from 1; 0: the whole world. */
  readonly radius: number;
  /** Bandwidth limit in kbit/s, from 16; 0: no limit. */
  readonly maxKbps: number;
}

/** The greatest error of decoded poses (proto Precision). The server rounds down to 1, 2 or 5 times a power of ten. */
export interface Precision {
  /** m, 0.0001 to 1. */
  readonly position: number;
  /** rad, 0.0002 to 0.5. */
  readonly rotation: number;
  /** Coarser beyond half of the radius of interest, 1 to 1000; default: 1. */
  readonly farFactor?: number;
}

const PROTOCOL = 1;
const BATCH_MS = 1000 / 30;
const PING_MS = 1000;
const INPUTS_PER_BATCH = 32;
const RECONNECT_DELAYS_MS = [250, 500, 1000, 2000, 5000];
const SERVER_TIMEOUT_MS = 5000; // the server sends at least once per second; after this silence the connection is lost
const STABLE_CONNECTION_MS = 5000; // a connection that lasted this long resets the reconnect delay
const CLOSE_POLICY_VIOLATION = 1008; // WebSocket close code of a rejection that a retry would not change

/** An input in the form of proto Input, with all fields optional. */
export type Input = MessageInitShape<typeof InputSchema>;
/** waiting: for the next attempt to reconnect. stopped: by stop(), or rejected by the server. */
export type ConnectionState = 'connecting' | 'playing' | 'waiting' | 'stopped';

/** Callbacks of a connection. */
export interface ConnectionListener {
  /** The state changed; `reason` is empty unless the connection was lost or rejected. */
  state(state: ConnectionState, reason: string): void;
  /** Entities were added or removed. */
  entityList(entities: ReadonlyMap<number, Entity>): void;
  /** Statistics of the world, about twice per second. */
  stats(stats: WorldStats): void;
  /** Events of one tick; only while enabled by setEventsEnabled(). */
  worldEvents(events: WorldEvents): void;
  /** The server rejected an input; InputResult.message has the reason. */
  inputRejected(result: InputResult): void;
  /** A message from the server for the user. */
  notice(text: string): void;
  /** Joints were added or removed; only with ConnectionOptions.joints. */
  joints?(joints: JointList['joints']): void;
  /** A user message of a topic that the client subscribed to, in order. */
  userMessage?(message: UserMessage): void;
  /** A player joined, left, was renamed and so on; Connection.data is up to date. */
  playerEvent?(event: PlayerEvent): void;
  /** Players, attributes or the settings of the room changed. */
  dataChanged?(data: WorldData): void;
}

/**
 * Receives what prediction needs: entities, frames, inputs and results
 * (prediction/prediction_controller.ts).
 */
export interface PredictionListener {
  begin(welcome: Welcome): void;
  entityAdded(entity: Entity): void;
  entityRemoved(entity: number): void;
  /** State of the controlled entity, before the frame of its tick; undefined: no longer known. */
  controlledEntity(state: ControlledEntity | undefined): void;
  frame(frame: PoseFrame): void;
  result(result: InputResult): void;
  /**
   * An input that will be sent as `sequence`; the same number again replaces the last input. Tick 0:
   * the next tick.
   */
  input(sequence: number, tick: number, input: Input): void;
}

/** The subset of WebSocket that a connection uses; tests and recordings implement it. */
export interface Socket {
  binaryType: string;
  onopen: (() => void) | null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  send(bytes: Uint8Array): void;
  close(): void;
}

/** Opens a WebSocket. */
export const openSocket = (url: string) => new WebSocket(url) as unknown as Socket;

export interface ConnectionOptions {
  /** WebSocket URL of the play stream. */
  readonly url: string;
  readonly listener: ConnectionListener;
  /** Default: a WebSocket. */
  readonly openSocket?: ((url: string) => Socket) | undefined;
  /** Bearer token of the user; default: none. */
  readonly token?: string | undefined;
  /** Join code of a private room; default: none. */
  readonly joinCode?: string | undefined;
  /** Channel kinds to subscribe to; default: none. */
  readonly channelKinds?: readonly string[] | undefined;
  /** Default: the whole world. */
  readonly areaOfInterest?: AreaOfInterest | undefined;
  /** Default: the precision of the world. */
  readonly precision?: Precision | undefined;
  /** Receives the joints of the world; default: false. */
  readonly joints?: boolean | undefined;
  /** Display name, at most 32 bytes; default: "browser". */
  readonly name?: string | undefined;
  /** 0xRRGGBB, of the player; default: none. */
  readonly color?: number | undefined;
  /** Subscribes to the player list (Connection.data); default: false. */
  readonly players?: boolean | undefined;
  /** Subscribes to attributes (Connection.data); default: false. */
  readonly attributes?: boolean | undefined;
  /** Subscribes to the settings of the room (Connection.data); default: false. */
  readonly room?: boolean | undefined;
  /** Topics of user messages to subscribe to, at most 64; "*": all; default: none. */
  readonly topics?: readonly string[] | undefined;
}

const identityOf = (name = 'browser', color?: number) => ({ name, ...(color === undefined ? {} : { color }) });

/** A play stream that reconnects. join() starts it, stop() ends it. */
export class Connection {
  readonly clock = new ClockSync();
  readonly frames = new FrameBuffer();
  /** Point objects of the channel kinds that the client named. */
  readonly points = new PointObjects();
  readonly renderClock = new RenderClock();
  readonly inputClock = new InputClock();
  readonly entities = new Map<number, Entity>();
  /** Joints of the world, if requested. */
  readonly joints = new JointList();
  /** Players and attributes that the client subscribed to. */
  readonly data = new WorldData();
  welcome: Welcome | undefined; // undefined: before the first connection
  bytesReceived = 0;
  snapshots = 0; // decoded
  decodeErrors = 0; // each causes a request for a keyframe
  ageMs = 0; // of the newest frame when it arrived
  world = ''; // id or name that was joined
  state: ConnectionState = 'stopped';
  resumed = 0; // number of resumed connections

  private readonly largeShapes = new LargeShapes();
  private readonly controlledEntity = new ControlledStateDecoder();
  private eventsEnabled = false;
  private socket: Socket | undefined;
  private spec: QuantSpec = { unitsPerMeter: 512, rotationComponent: 511 };
  private codec = 1; // snapshot codec
  private readonly cells = new InterestCells();
  private focus = { x: 0, z: 0 };
  private readonly inputs = new InputQueue<Input>();
  private resumeToken = new Uint8Array(0); // empty: no session to resume
  private lastUserMessage = 0; // number, in this session; 0: none
  private needKeyframe = false;
  private ackDue = false;
  private lastAck = 0;
  private decodedAt = 0;
  private lastPing = 0;
  private attempt = 0;
  private timer: ReturnType<typeof setInterval> | undefined;
  private retry: ReturnType<typeof setTimeout> | undefined;
  private lastReceivedUs = 0;
  private playingSince = 0;
  private lastNotice: Notice | undefined;
  private predictionListener: PredictionListener | undefined;
  private lastBatch = 0;
  private sendsSoon = false;

  readonly url: string;
  private readonly listener: ConnectionListener;
  private readonly openSocket: (url: string) => Socket;
  private readonly token: string;
  private joinCode: string;
  private readonly channelKinds: readonly string[];
  private readonly areaOfInterest: AreaOfInterest | undefined;
  private readonly precision: Precision | undefined;
  private readonly wantsJoints: boolean;
  private identity: { readonly name: string; readonly color?: number };
  private readonly subscriptions: { readonly players: boolean; readonly attributes: boolean; readonly room: boolean; readonly topics: string[] };

  constructor(options: ConnectionOptions) {
    this.url = options.url;
    this.listener = options.listener;
    this.openSocket = options.openSocket ?? openSocket;
    this.token = options.token ?? '';
    this.joinCode = options.joinCode ?? '';
    this.channelKinds = options.channelKinds ?? [];
    this.areaOfInterest = options.areaOfInterest;
    this.precision = options.precision;
    this.wantsJoints = options.joints ?? false;
    this.identity = identityOf(options.name, options.color);
    this.subscriptions = { players: options.players ?? false, attributes: options.attributes ?? false, room: options.room ?? false, topics: [...(options.topics ?? [])] };
  }

  /**
   * Leaves the current world, if any, and joins a world by id or name; empty: the server's first world.
   * `joinCode`: of a private room; default: the last one.
   */
  join(world: string, joinCode = this.joinCode): void {
    this.stop();
    this.world = world;
    this.joinCode = joinCode;
    this.attempt = 0;
    this.connect();
  }

  /**
   * Changes the display name, at most 32 bytes, and the color 0xRRGGBB of the player. The name also changes in the
   * current world; the color is that of the next world.
   */
  setIdentity(name: string, color?: number): void {
    const renamed = name !== this.identity.name;
    this.identity = identityOf(name, color);
    if (renamed) this.send({ kind: { case: 'rename', value: { name } } });
  }

  /** Subscribes to events. The subscription is part of Hello, so a change rejoins the world. */
  setEventsEnabled(enabled: boolean): void {
    if (this.eventsEnabled === enabled) return;
    this.eventsEnabled = enabled;
    if (this.state === 'playing' || this.state === 'connecting') this.join(this.world);
  }

  /** Leaves the world and ends the session. */
  stop(): void {
    if (this.state === 'playing') this.sendMessage({ case: 'leave', value: {} });
    this.resumeToken = new Uint8Array(0);
    clearTimeout(this.retry);
    this.dropSocket();
    this.setState('stopped', '');
  }

  /** Connects immediately instead of waiting for the next attempt. */
  retryNow(): void {
    if (this.state !== 'waiting') return;
    clearTimeout(this.retry);
    this.connect();
  }

  /**
   * From now on, inputs carry the tick that they are meant for (InputClock), and the listener receives
   * what prediction needs.
   */
  enablePrediction(predictionListener: PredictionListener): void {
    this.predictionListener = predictionListener;
    if (!this.welcome) return;
    predictionListener.begin(this.welcome);
    for (const entity of this.entities.values()) predictionListener.entityAdded(entity);
    predictionListener.controlledEntity(this.controlledEntity.newest);
  }

  /**
   * Sends an input; does nothing unless the state is `playing`. Returns its sequence number, which
   * InputResult.sequence repeats; 0: not sent.
   */
  send(original: Input): number {
    if (this.state !== 'playing') return 0;
    const now = nowUs();
    const tick = this.predictionListener && this.inputClock.ready ? this.inputClock.tick(now) : 0;
    const input = this.withViewTime(tick > 0 ? { ...original, tick } : original);
    // Dragging produces many targets; only the newest unsent target of a tick matters.
    const last = this.inputs.last;
    if (input.kind?.case === 'drag' && last?.kind?.case === 'drag' && last.tick === input.tick) this.inputs.replaceLast(input);
    else this.inputs.push(input);
    const sequence = this.inputs.newest;
    this.predictionListener?.input(sequence, tick, input);
    // Waiting for the next batch would need a larger input lead. Several inputs of one tick share a batch.
    if (tick > 0 && now - this.lastBatch >= this.inputClock.halfTickUs) this.sendInputs(now);
    else if (tick === 0) this.sendSoon(now);
    return sequence;
  }

  /** Sends the inputs of this task at once, unless the last batch was sent a short time ago. */
  private sendSoon(now: number): void {
    if (this.sendsSoon || now - this.lastBatch < BATCH_MS * 1000) return;
    this.sendsSoon = true;
    queueMicrotask(() => {
      this.sendsSoon = false;
      if (this.state === 'playing' && this.inputs.length > 0) this.sendInputs(nowUs());
    });
  }

  /** Computes the positions of the point objects at the rendered time, on the server's clock. */
  samplePoints(renderTimeUs = this.renderClock.renderTimeUs): void {
    const { newest } = this.frames;
    const tickHz = this.welcome?.tickHz ?? 0;
    if (!newest || tickHz === 0) return;
    this.points.sample(newest.frame + ((renderTimeUs - newest.serverUs) * tickHz) / 1e6, tickHz);
  }

  /** Server tick of the last rendered frame; undefined before the first frame. */
  renderedTime() {
    return renderedTime(this.frames.newest, this.renderClock.renderTimeUs, this.welcome?.tickHz ?? 0);
  }

  /**
   * Adds the rendered time to an aim without view time, so that the server evaluates it against what
   * was on screen.
   */
  private withViewTime(input: Input): Input {
    const { kind } = input;
    if (kind?.case !== 'impulse' && kind?.case !== 'grab' && kind?.case !== 'explode') return input;
    const { aim } = kind.value;
    if (!aim || aim.viewTime) return input;
    const value = { ...kind.value, aim: { ...aim, viewTime: this.renderedTime() } };
    return { ...input, kind: { case: kind.case, value } } as Input;
  }

  private setState(state: ConnectionState, reason: string): void {
    this.state = state;
    this.listener.state(state, reason);
  }

  private dropSocket(): void {
    clearInterval(this.timer);
    if (!this.socket) return;
    this.socket.onclose = this.socket.onmessage = this.socket.onopen = null;
    this.socket.close();
    this.socket = undefined;
  }

  private connect(): void {
    this.setState('connecting', '');
    this.lastNotice = undefined;
    this.playingSince = 0;
    this.lastReceivedUs = nowUs();
    const socket = this.openSocket(this.url);
    this.socket = socket;
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      const { world, token, joinCode, eventsEnabled: events } = this;
      const channels = [...this.channelKinds];
      const hello = { protocol: PROTOCOL, world, ...this.identity, ...this.subscriptions, events, token, joinCode, channels, codec: NEWEST_CODEC,
        maxKbps: this.areaOfInterest?.maxKbps ?? 0,
        packedEntities: true,
        joints: this.wantsJoints,
        ...(this.areaOfInterest ? { interest: this.interest(this.areaOfInterest) } : {}),
        ...(this.precision ? { precision: { farFactor: 1, ...this.precision } } : {}),
        resumable: true,
        ...(this.resumeToken.length > 0 ? { resume: { token: this.resumeToken, frame: this.frames.newest?.frame ?? 0, message: this.lastUserMessage } } : {}),
      };
      this.sendMessage({ case: 'hello', value: hello });
    };
    socket.onmessage = (event) => this.receive(new Uint8Array(event.data));
    socket.onclose = (event) => this.closed(event.code, event.reason);
    this.timer = setInterval(() => this.pump(), BATCH_MS);
  }

  /** The server closed the connection or is unreachable. */
  private closed(code: number, reason: string): void {
    const notice = this.lastNotice;
    const last = notice?.code === NoticeCode.DRAINING ? reason || notice.message : notice?.message || reason;
    const explanation = last || (this.playingSince > 0 ? 'the connection was lost' : 'the server does not respond');
    // A closed world, or one that rejected the client, will not accept a retry.
    const permanent =
      notice?.code === NoticeCode.WORLD_CLOSED ||
      (notice?.code === NoticeCode.REFUSED && code === CLOSE_POLICY_VIOLATION && this.playingSince === 0);
    if (permanent) {
      this.dropSocket();
      this.setState('stopped', explanation);
    } else {
      this.reconnect(explanation);
    }
  }

  /** Drops the session because its state is inconsistent. */
  private startNewSession(reason: string): void {
    this.resumeToken = new Uint8Array(0);
    this.reconnect(reason);
  }

  private reconnect(reason: string): void {
    this.dropSocket();
    if (this.playingSince > 0 && nowUs() - this.playingSince > STABLE_CONNECTION_MS * 1000) this.attempt = 0;
    const delayMs = RECONNECT_DELAYS_MS[Math.min(this.attempt++, RECONNECT_DELAYS_MS.length - 1)]!;
    this.setState('waiting', reason);
    this.retry = setTimeout(() => this.connect(), delayMs);
  }

  private sendMessage(message: MessageInitShape<typeof ClientMessageSchema>['message']): void {
    this.socket?.send(toBinary(ClientMessageSchema, create(ClientMessageSchema, { message: message! })));
  }

  private receive(bytes: Uint8Array): void {
    this.bytesReceived += bytes.length;
    this.lastReceivedUs = nowUs();
    let message: ServerMessage['message'];
    try {
      message = fromBinary(ServerMessageSchema, bytes).message;
    } catch {
      return this.startNewSession('the server sent a malformed message');
    }
    switch (message.case) {
      case 'welcome':
        return this.onWelcome(message.value);
      case 'geometry':
        if (!this.largeShapes.add(message.value)) this.startNewSession('the server sent a malformed shape');
        return;
      case 'entityUpdate':
        return this.onEntityList(message.value);
      case 'snapshot':
        return this.onSnapshot(message.value);
      case 'pong':
        return this.clock.add(Number(message.value.clientTimeUs), Number(message.value.serverTimeUs), nowUs());
      case 'notice':
        return this.onNotice(message.value);
    }
  }

  private onNotice(notice: Notice): void {
    // Other notices end the stream and become the reason of the state change.
    if (notice.code === NoticeCode.RATE_LIMIT || notice.code === NoticeCode.DRAINING)
      this.listener.notice(notice.message);
    if (notice.code !== NoticeCode.RATE_LIMIT) this.lastNotice = notice;
  }

  private onWelcome(welcome: Welcome): void {
    this.welcome = welcome;
    const { unitsPerMeter, rotationComponent } = welcome.quant ?? { unitsPerMeter: 512, rotationComponent: 511 };
    this.spec = { unitsPerMeter, rotationComponent };
    this.codec = welcome.codec || 1;
    if (!isValidSpec(this.spec) || this.codec > NEWEST_CODEC) {
      this.dropSocket();
      return this.setState('stopped', 'the server uses an unsupported snapshot codec or quantization');
    }
    this.resumeToken = new Uint8Array(welcome.resumeToken);
    if (welcome.resumed) this.inputs.resumeAfter(welcome.lastSequence);
    else {
      this.inputs.startNewSession();
      this.lastUserMessage = 0;
    }
    this.resumed += welcome.resumed ? 1 : 0;
    if (!welcome.statePreserved) {
      this.clearWorld(welcome);
      this.predictionListener?.begin(welcome);
    }
    this.points.begin(welcome.channels.map(({ divisor }) => divisor)); // a resumed stream sends them again
    this.needKeyframe = this.ackDue = false;
    this.lastAck = this.decodedAt = 0;
    this.lastPing = 0;
    this.playingSince = nowUs();
    this.setState('playing', '');
    this.pump();
  }

  private clearWorld(welcome: Welcome): void {
    this.frames.clear();
    this.cells.clear();
    this.renderClock.reset();
    this.inputClock.begin(welcome.tickHz);
    this.clock.reset();
    this.entities.clear();
    this.largeShapes.clear();
    this.data.clear();
    this.controlledEntity.reset();
    this.joints.clear();
    if (this.wantsJoints) this.listener.joints?.(this.joints.joints);
  }

  private onEntityList(change: EntityUpdate): void {
    for (const id of change.removed) {
      this.entities.delete(id);
      this.predictionListener?.entityRemoved(id);
    }
    for (const entity of this.addedEntities(change)) {
      this.largeShapes.resolve(entity);
      this.entities.set(entity.id, entity);
      this.predictionListener?.entityAdded(entity);
    }
    this.listener.entityList(this.entities);
  }

  /** The added entities; packed ones are copies of their prototypes. */
  private addedEntities(change: EntityUpdate): readonly Entity[] {
    if (change.packed.length === 0) return change.added;
    try {
      const listed = decodeEntityList(change.packed, change.prototypes.length);
      return [...change.added, ...listed.map(({ id, prototype }) => {
        const entity = clone(EntitySchema, change.prototypes[prototype]!);
        entity.id = id;
        return entity;
      })];
    } catch (error) {
      if (!(error instanceof DecodeError)) throw error;
      this.decodeErrors++;
      return change.added;
    }
  }

  private onSnapshot(s: Snapshot): void {
    this.ackDue = true;
    // Before the frame, so that the predictor moves late inputs to the ticks of the server.
    for (const result of s.clientUpdate?.results ?? []) this.predictionListener?.result(result);
    if (s.controlledEntity) {
      this.controlledEntity.apply(s.controlledEntity);
      this.predictionListener?.controlledEntity(this.controlledEntity.newest);
    }
    this.decode(s);
    if (!this.points.apply(s)) this.decodeErrors++;
    if (s.joints) this.onJoints(s.joints);
    // These are valid even if the poses could not be decoded.
    for (const result of s.clientUpdate?.results ?? [])
      if (this.inputs.onResult(result.sequence) && result.code !== InputCode.APPLIED) this.listener.inputRejected(result);
    if (s.stats) this.listener.stats(s.stats);
    for (const tick of s.events) this.listener.worldEvents(tick);
    this.onData(s);
    // An ack that waits for the next batch would inflate the measured latency.
    if (this.inputs.length === 0) this.sendAckIfDue();
  }

  private onJoints(update: JointUpdate): void {
    if (this.joints.apply(update) !== undefined) this.decodeErrors++;
    else this.listener.joints?.(this.joints.joints);
  }

  private onData(s: Snapshot): void {
    this.data.apply(s);
    for (const { events } of s.players) for (const event of events) this.listener.playerEvent?.(event);
    if (s.players.length > 0 || s.attributes.length > 0 || s.room) this.listener.dataChanged?.(this.data);
    for (const message of s.messages) {
      this.lastUserMessage = message.number;
      this.listener.userMessage?.(message);
    }
  }

  private decode(s: Snapshot): void {
    try {
      const baselines = baselineFrames(s.frame, s.baselines);
      const [baseline, baseline2, baseline3] = baselines.map((number) => {
        const frame = this.frames.find(number);
        if (number !== 0 && !frame) throw new DecodeError(`baseline frame ${number} is unknown`);
        return frame;
      });
      const frame = this.welcome?.cells ? this.decodeCells(s) : this.decodeWholeFrame(s, { baseline, baseline2, baseline3 });
      const serverUs = this.dueUs(s.frame, s.lateUs);
      const channels = decodeChannels(s.channels, s.channelsCrc, this.frames.channelsOf(baselines[0]));
      if (s.unchangedTicks > 0) this.frames.hold(this.dueUs(baselines[0] + s.unchangedTicks, s.lateUs));
      const blends = this.welcome?.cells ? this.cells.blends(s.frame) : undefined;
      const poseFrame = this.frames.add(frame, serverUs, this.spec, channels, blends, 1e6 / (this.welcome?.tickHz || 60));
      this.needKeyframe = false;
      this.snapshots++;
      this.decodedAt = nowUs();
      const arrived = nowUs();
      this.renderClock.onFrame(serverUs, arrived, s.unchangedTicks > 0);
      if (this.clock.ready) {
        const agoUs = this.clock.serverUs(arrived) - serverUs;
        this.ageMs = agoUs / 1000;
        this.inputClock.onFrame(s.frame, agoUs, (1000 * this.clock.rttMs) / 2, arrived);
        this.inputClock.onMargin(s.clientUpdate?.inputSequence ?? 0, s.clientUpdate?.inputMarginUs ?? 0);
      }
      this.predictionListener?.frame(poseFrame);
    } catch (error) {
      if (!(error instanceof DecodeError)) throw error;
      if (!this.needKeyframe) this.decodeErrors++;
      this.needKeyframe = true;
    }
  }

  private decodeWholeFrame(s: Snapshot, baselines: Baselines): QuantizedFrame {
    const frame = decodeFrame(s.frame, s.packed, baselines, this.spec, undefined, this.codec);
    if (frameCrc(frame) !== s.crc) throw new DecodeError(`frame ${s.frame}: CRC mismatch`);
    return frame;
  }

  /** Merges the cells of the area of interest. */
  private decodeCells(s: Snapshot): QuantizedFrame {
    this.cells.apply(s.cells, s.cellsLeft, this.spec, this.codec, s.frame);
    const merged = this.cells.frame(s.frame);
    // A late cell may still contain a removed entity.
    return { frame: merged.frame, entities: merged.entities.filter((e) => this.entities.has(e.id)) };
  }

  /** Moves the center of the area of interest, in m. No effect without an area of interest. */
  setInterestFocus(x: number, z: number): void {
    if (!this.areaOfInterest || Math.hypot(x - this.focus.x, z - this.focus.z) < Math.max(2, this.areaOfInterest.radius / 16)) return;
    this.focus = { x, z };
    if (this.state === 'playing') this.sendMessage({ case: 'interest', value: this.interest(this.areaOfInterest) });
  }

  private interest(areaOfInterest: AreaOfInterest) {
    return create(InterestSchema, { focus: { ...this.focus, y: 0 }, radius: areaOfInterest.radius });
  }

  /** When the tick of a frame was due, in microseconds of the server's clock. */
  private dueUs(frame: number, lateUs: bigint): number {
    return Number(this.welcome!.epochUs) + Math.round((frame * 1e6) / this.welcome!.tickHz) + Number(lateUs);
  }

  private ack() {
    this.ackDue = false;
    this.lastAck = nowUs();
    return create(AckSchema, {
      frame: this.frames.newest?.frame ?? 0,
      needKeyframe: this.needKeyframe || this.points.needsKeyframe,
      ackDelayMs: this.decodedAt === 0 ? 0 : Math.floor((this.lastAck - this.decodedAt) / 1000),
    });
  }

  private sendAckIfDue(): void {
    if (!this.ackDue) return;
    const dueUs = this.lastAck + (this.welcome?.ackIntervalMs ?? 0) * 1000;
    if (this.needKeyframe || this.points.needsKeyframe || nowUs() >= dueUs) this.sendMessage({ case: 'ack', value: this.ack() });
  }

  /** Thirty times per second: sends what is due and detects a silent server. */
  private pump(): void {
    const now = nowUs();
    if (now - this.lastReceivedUs > SERVER_TIMEOUT_MS * 1000) return this.reconnect('the server does not respond');
    if (this.state !== 'playing') return;
    if (now - this.lastPing >= PING_MS * 1000) {
      this.lastPing = now;
      this.sendMessage({ case: 'ping', value: { clientTimeUs: BigInt(Math.round(now)) } });
    }
    if (this.inputs.length === 0) this.sendAckIfDue();
    else if (now - this.lastBatch >= BATCH_MS * 500) this.sendInputs(now);
  }

  private sendInputs(now: number): void {
    const { firstSequence, inputs } = this.inputs.take(INPUTS_PER_BATCH);
    this.lastBatch = now;
    this.inputClock.sent(this.inputs.lastSent);
    const clientTimeUs = Math.floor(now) % 2 ** 32;
    this.sendMessage({ case: 'input', value: { firstSequence, inputs, ack: this.ack(), clientTimeUs } });
  }
}
