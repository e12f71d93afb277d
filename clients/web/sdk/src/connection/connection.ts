// The play stream over a WebSocket: hello, acks, batches of inputs, pings, and coming back after a loss. No view in it.

import { create, fromBinary, toBinary, type MessageInitShape } from '@bufbuild/protobuf';
import { ClockSync, nowUs } from '../clock/clock.js';
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
import { InterestCells } from '../snapshot/interest_cells.js';
import type { AreaOfInterest } from './area_of_interest.js';
import { FrameBuffer, type PoseFrame } from '../interpolation/frame_buffer.js';
import { InputClock } from '../clock/input_clock.js';
import { InputQueue } from './input_queue.js';
import { LargeShapes } from './large_shapes.js';
import { RenderClock } from '../clock/render_clock.js';
import { renderedTime } from '../interpolation/rendered_time.js';
import { decodeChannels } from '../snapshot/channels.js';
import { ControlledStateDecoder, type ControlledEntity } from './word_changes.js';
import {
  AckSchema,
  ClientMessageSchema,
  InputCode,
  InterestSchema,
  NoticeCode,
  ServerMessageSchema,
  type Entity,
  type Events as WorldEvents,
  type InputResult,
  type InputSchema,
  type Notice,
  type EntityUpdate,
  type ServerMessage,
  type Snapshot,
  type Welcome,
  type WorldStats,
} from '../gen/jostle/v1/play_pb.js';

const PROTOCOL = 1;
const BATCH_MS = 1000 / 30;
const PING_MS = 1000;
const INPUTS_PER_BATCH = 32;
const RECONNECT_DELAYS_MS = [250, 500, 1000, 2000, 5000];
const SERVER_TIMEOUT_MS = 5000; // a server says something every second at least: after this it is gone
const STABLE_CONNECTION_MS = 5000; // who was in a world for so long comes back without a pause
const CLOSE_POLICY_VIOLATION = 1008; // the close code of a refusal that asking again will not change

export type Input = MessageInitShape<typeof InputSchema>;
export type State = 'connecting' | 'playing' | 'waiting' | 'stopped';

export interface Events {
  state(state: State, why: string): void;
  entityList(entities: ReadonlyMap<number, Entity>): void;
  stats(stats: WorldStats): void;
  /** What happened in one tick; only while `setEventsEnabled`. */
  worldEvents(events: WorldEvents): void;
  inputRejected(result: InputResult): void;
  /** What the server has to say to the person. */
  notice(text: string): void;
}

/** Who foresees what inputs do (prediction/prediction_controller.ts). */
export interface PredictionListener {
  begin(welcome: Welcome): void;
  entityAdded(entity: Entity): void;
  entityRemoved(entity: number): void;
  /** What this client drives, before the frame of its tick; undefined: that is not known any more. */
  controlledEntity(thing: ControlledEntity | undefined): void;
  frame(frame: PoseFrame): void;
  result(result: InputResult): void;
  /** An input that will be sent with that number; one of the same number as the last comes in its place. Tick 0: the next one. */
  input(sequence: number, tick: number, input: Input): void;
}

/** What a WebSocket is to us; tests bring their own. */
export interface Socket {
  binaryType: string;
  onopen: (() => void) | null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  send(bytes: Uint8Array): void;
  close(): void;
}

export const openSocket = (url: string) => new WebSocket(url) as unknown as Socket;

export class Connection {
  readonly clock = new ClockSync();
  readonly frames = new FrameBuffer();
  readonly renderClock = new RenderClock();
  readonly inputClock = new InputClock();
  readonly entities = new Map<number, Entity>();
  welcome: Welcome | undefined;
  bytesReceived = 0;
  snapshots = 0;
  decodeErrors = 0;
  ageMs = 0;
  world = '';
  state: State = 'stopped';

  private readonly largeShapes = new LargeShapes();
  private readonly controlledEntity = new ControlledStateDecoder();
  private eventsEnabled = false;
  private socket: Socket | undefined;
  private spec: QuantSpec = { unitsPerMeter: 512, rotationComponent: 511 };
  private codec = 1; // of snapshots
  private readonly cells = new InterestCells();
  private focus = { x: 0, z: 0 };
  private readonly inputs = new InputQueue<Input>();
  private resumeToken = new Uint8Array(0); // empty: it has no place that it could come back to
  resumed = 0; // connections in which it was the client that it was before
  private needKeyframe = false;
  private ackDue = false;
  private lastAck = 0;
  private decodedAt = 0;
  private lastPing = 0;
  private attempt = 0;
  private timer: ReturnType<typeof setInterval> | undefined;
  private retry: ReturnType<typeof setTimeout> | undefined;
  private lastHeard = 0;
  private playingSince = 0;
  private lastNotice: Notice | undefined;
  private predictionListener: PredictionListener | undefined;
  private lastBatch = 0;

  constructor(
    private readonly url: string,
    private readonly events: Events,
    private readonly open: (url: string) => Socket = openSocket,
    private readonly token = '',
    private readonly kinds: Iterable<string> = [], // of channels that somebody here understands
    private readonly areaOfInterest: AreaOfInterest | undefined = undefined, // absent: it is told of all of the world
  ) {}

  /** Leaves the present world, if any, and joins another by id or name. */
  join(world: string): void {
    this.stop();
    this.world = world;
    this.attempt = 0;
    this.connect();
  }

  /** Whether the server is to tell what happens. It is asked when one joins, so a change leaves and comes back. */
  setEventsEnabled(wanted: boolean): void {
    if (this.eventsEnabled === wanted) return;
    this.eventsEnabled = wanted;
    if (this.state === 'playing' || this.state === 'connecting') this.join(this.world);
  }

  stop(): void {
    if (this.state === 'playing') this.sendMessage({ case: 'leave', value: {} });
    this.resumeToken = new Uint8Array(0);
    clearTimeout(this.retry);
    this.dropSocket();
    this.setState('stopped', '');
  }

  /** Asks again at once, while waiting for the next attempt. */
  retryNow(): void {
    if (this.state !== 'waiting') return;
    clearTimeout(this.retry);
    this.connect();
  }

  /** From now on inputs name the tick that they are meant for (InputClock), and this is told of all that it needs to foresee them. */
  enablePrediction(predictionListener: PredictionListener): void {
    this.predictionListener = predictionListener;
    if (!this.welcome) return;
    predictionListener.begin(this.welcome);
    for (const entity of this.entities.values()) predictionListener.entityAdded(entity);
    predictionListener.controlledEntity(this.controlledEntity.newest);
  }

  send(given: Input): void {
    if (this.state !== 'playing') return;
    const now = nowUs();
    const tick = this.predictionListener && this.inputClock.ready ? this.inputClock.tick(now) : 0;
    const input = this.withViewTime(tick > 0 ? { ...given, tick } : given);
    // Dragging makes many targets; of a tick only the newest that has not been sent matters.
    const last = this.inputs.last;
    if (input.kind?.case === 'drag' && last?.kind?.case === 'drag' && last.tick === input.tick) this.inputs.replaceLast(input);
    else this.inputs.push(input);
    this.predictionListener?.input(this.inputs.newest, tick, input);
    // What waits for its batch needs a longer lead.
    if (tick > 0 && now - this.lastBatch >= BATCH_MS * 1000) this.sendInputs(now);
  }

  /** What the last picture shows; absent before the first frame. */
  renderedTime() {
    return renderedTime(this.frames.newest, this.renderClock.renderTimeUs, this.welcome?.tickHz ?? 0);
  }

  /** An aim that names no moment gets that of the picture, so that the server judges it by what was seen. */
  private withViewTime(input: Input): Input {
    const { kind } = input;
    if (kind?.case !== 'impulse' && kind?.case !== 'grab' && kind?.case !== 'explode') return input;
    const { aim } = kind.value;
    if (!aim || aim.viewTime) return input;
    const value = { ...kind.value, aim: { ...aim, viewTime: this.renderedTime() } };
    return { ...input, kind: { case: kind.case, value } } as Input;
  }

  private setState(state: State, why: string): void {
    this.state = state;
    this.events.state(state, why);
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
    this.lastHeard = nowUs();
    const socket = this.open(this.url);
    this.socket = socket;
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      const { world, token, eventsEnabled: events } = this;
      const channels = [...this.kinds];
      const hello = { protocol: PROTOCOL, world, name: 'browser', events, token, channels, codec: NEWEST_CODEC,
        maxKbps: this.areaOfInterest?.maxKbps ?? 0,
        ...(this.areaOfInterest ? { interest: this.interest(this.areaOfInterest) } : {}),
        resumable: true,
        ...(this.resumeToken.length > 0 ? { resume: { token: this.resumeToken, frame: this.frames.newest?.frame ?? 0 } } : {}),
      };
      this.sendMessage({ case: 'hello', value: hello });
    };
    socket.onmessage = (event) => this.receive(new Uint8Array(event.data));
    socket.onclose = (event) => this.closed(event.code, event.reason);
    this.timer = setInterval(() => this.pump(), BATCH_MS);
  }

  /** The server ended it, or nobody is there. */
  private closed(code: number, reason: string): void {
    const notice = this.lastNotice;
    const last = notice?.code === NoticeCode.DRAINING ? reason || notice.message : notice?.message || reason;
    const why = last || (this.playingSince > 0 ? 'the connection was lost' : 'the server does not answer');
    // A world that is gone, or that would not have us, will not change its mind.
    const forGood =
      notice?.code === NoticeCode.WORLD_CLOSED ||
      (notice?.code === NoticeCode.REFUSED && code === CLOSE_POLICY_VIOLATION && this.playingSince === 0);
    if (forGood) {
      this.dropSocket();
      this.setState('stopped', why);
    } else {
      this.reconnect(why);
    }
  }

  /** Something is wrong with what it knows. */
  private startNewSession(why: string): void {
    this.resumeToken = new Uint8Array(0);
    this.reconnect(why);
  }

  private reconnect(why: string): void {
    this.dropSocket();
    if (this.playingSince > 0 && nowUs() - this.playingSince > STABLE_CONNECTION_MS * 1000) this.attempt = 0;
    const pause = RECONNECT_DELAYS_MS[Math.min(this.attempt++, RECONNECT_DELAYS_MS.length - 1)]!;
    this.setState('waiting', why);
    this.retry = setTimeout(() => this.connect(), pause);
  }

  private sendMessage(message: MessageInitShape<typeof ClientMessageSchema>['message']): void {
    this.socket?.send(toBinary(ClientMessageSchema, create(ClientMessageSchema, { message: message! })));
  }

  private receive(bytes: Uint8Array): void {
    this.bytesReceived += bytes.length;
    this.lastHeard = nowUs();
    let message: ServerMessage['message'];
    try {
      message = fromBinary(ServerMessageSchema, bytes).message;
    } catch {
      return this.startNewSession('the server sent what this viewer cannot read');
    }
    switch (message.case) {
      case 'welcome':
        return this.onWelcome(message.value);
      case 'geometry':
        if (!this.largeShapes.add(message.value)) this.startNewSession('the server sent a shape that this viewer cannot read');
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
    // The others end the stream, and are shown as what ended it.
    if (notice.code === NoticeCode.RATE_LIMIT || notice.code === NoticeCode.DRAINING)
      this.events.notice(notice.message);
    if (notice.code !== NoticeCode.RATE_LIMIT) this.lastNotice = notice;
  }

  private onWelcome(welcome: Welcome): void {
    this.welcome = welcome;
    const { unitsPerMeter, rotationComponent } = welcome.quant ?? { unitsPerMeter: 512, rotationComponent: 511 };
    this.spec = { unitsPerMeter, rotationComponent };
    this.codec = welcome.codec || 1;
    if (!isValidSpec(this.spec) || this.codec > NEWEST_CODEC) {
      this.dropSocket();
      return this.setState('stopped', 'the server sends positions in a form that this viewer cannot read');
    }
    this.resumeToken = new Uint8Array(welcome.resumeToken);
    if (welcome.resumed) this.inputs.resumeAfter(welcome.lastSequence);
    else this.inputs.startNewSession();
    this.resumed += welcome.resumed ? 1 : 0;
    if (!welcome.statePreserved) {
      this.clearWorld(welcome);
      this.predictionListener?.begin(welcome);
    }
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
    this.controlledEntity.forget();
  }

  private onEntityList(change: EntityUpdate): void {
    for (const id of change.removed) {
      this.entities.delete(id);
      this.predictionListener?.entityRemoved(id);
    }
    for (const entity of change.added) {
      this.largeShapes.fillIn(entity);
      this.entities.set(entity.id, entity);
      this.predictionListener?.entityAdded(entity);
    }
    this.events.entityList(this.entities);
  }

  private onSnapshot(s: Snapshot): void {
    this.ackDue = true;
    // Before its frame, so that late inputs are where the server had them.
    for (const result of s.clientUpdate?.results ?? []) this.predictionListener?.result(result);
    if (s.controlledEntity) {
      this.controlledEntity.apply(s.controlledEntity);
      this.predictionListener?.controlledEntity(this.controlledEntity.newest);
    }
    this.decode(s);
    // These stand by themselves, whatever became of the poses.
    for (const result of s.clientUpdate?.results ?? [])
      if (this.inputs.onResult(result.sequence) && result.code !== InputCode.APPLIED) this.events.inputRejected(result);
    if (s.stats) this.events.stats(s.stats);
    for (const tick of s.events) this.events.worldEvents(tick);
    // An ack that waited long for the next batch would make the way look long.
    if (this.inputs.length === 0) this.sendAckIfDue();
  }

  private decode(s: Snapshot): void {
    try {
      const baselines = baselineFrames(s.frame, s.baselines);
      const [base, baseline2, baseline3] = baselines.map((number) => {
        const frame = this.frames.find(number);
        if (number !== 0 && !frame) throw new DecodeError(`base frame ${number} is not known`);
        return frame;
      });
      const frame = this.welcome?.cells ? this.decodeCells(s) : this.decodeWholeFrame(s, { base, baseline2, baseline3 });
      const serverUs = this.dueUs(s.frame, s.lateUs);
      const channels = decodeChannels(s.channels, s.channelsCrc, this.frames.channelsOf(baselines[0]));
      if (s.unchangedTicks > 0) this.frames.hold(this.dueUs(baselines[0] + s.unchangedTicks, s.lateUs));
      const blends = this.welcome?.cells ? this.cells.blends(s.frame) : undefined;
      const told = this.frames.add(frame, serverUs, this.spec, channels, blends, 1e6 / (this.welcome?.tickHz || 60));
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
      this.predictionListener?.frame(told);
    } catch (error) {
      if (!(error instanceof DecodeError)) throw error;
      if (!this.needKeyframe) this.decodeErrors++;
      this.needKeyframe = true;
    }
  }

  private decodeWholeFrame(s: Snapshot, baselines: Baselines): QuantizedFrame {
    const frame = decodeFrame(s.frame, s.packed, baselines, this.spec, undefined, this.codec);
    if (frameCrc(frame) !== s.crc) throw new DecodeError(`frame ${s.frame}: the CRC does not match`);
    return frame;
  }

  /** The cells that are in sight. */
  private decodeCells(s: Snapshot): QuantizedFrame {
    this.cells.apply(s.cells, s.cellsLeft, this.spec, this.codec, s.frame);
    const viewTime = this.cells.frame(s.frame);
    // Who was removed may still be in a cell that comes late.
    return { frame: viewTime.frame, entities: viewTime.entities.filter((e) => this.entities.has(e.id)) };
  }

  /** What it wants to be told of from now on; only while `sight` is given. */
  setInterestFocus(x: number, z: number): void {
    if (!this.areaOfInterest || Math.hypot(x - this.focus.x, z - this.focus.z) < Math.max(2, this.areaOfInterest.radius / 16)) return;
    this.focus = { x, z };
    if (this.state === 'playing') this.sendMessage({ case: 'interest', value: this.interest(this.areaOfInterest) });
  }

  private interest(areaOfInterest: AreaOfInterest) {
    return create(InterestSchema, { focus: { ...this.focus, y: 0 }, radius: areaOfInterest.radius });
  }

  /** When a tick was due, on the server's clock. */
  private dueUs(frame: number, lateUs: bigint): number {
    return Number(this.welcome!.epochUs) + Math.round((frame * 1e6) / this.welcome!.tickHz) + Number(lateUs);
  }

  private ack() {
    this.ackDue = false;
    this.lastAck = nowUs();
    return create(AckSchema, {
      frame: this.frames.newest?.frame ?? 0,
      needKeyframe: this.needKeyframe,
      ackDelayMs: this.decodedAt === 0 ? 0 : Math.floor((this.lastAck - this.decodedAt) / 1000),
    });
  }

  private sendAckIfDue(): void {
    if (!this.ackDue) return;
    const dueUs = this.lastAck + (this.welcome?.ackIntervalMs ?? 0) * 1000;
    if (this.needKeyframe || nowUs() >= dueUs) this.sendMessage({ case: 'ack', value: this.ack() });
  }

  /** Thirty times a second: what is to be said, and whether anybody is still there. */
  private pump(): void {
    const now = nowUs();
    if (now - this.lastHeard > SERVER_TIMEOUT_MS * 1000) return this.reconnect('the server does not answer');
    if (this.state !== 'playing') return;
    if (now - this.lastPing >= PING_MS * 1000) {
      this.lastPing = now;
      this.sendMessage({ case: 'ping', value: { clientTimeUs: BigInt(Math.round(now)) } });
    }
    if (this.inputs.length > 0) this.sendInputs(now);
    else this.sendAckIfDue();
  }

  private sendInputs(now: number): void {
    const { firstSequence, inputs } = this.inputs.take(INPUTS_PER_BATCH);
    this.lastBatch = now;
    this.inputClock.sent(this.inputs.lastSent);
    const clientTimeUs = Math.floor(now) % 2 ** 32;
    this.sendMessage({ case: 'input', value: { firstSequence, inputs, ack: this.ack(), clientTimeUs } });
  }
}
