// A recording as a socket: a connection reads it instead of a server, so that live worlds and
// recordings share one code path. It has its own time, which can be paused, scaled and set. Messages
// are delivered shortly before they are rendered. To seek backwards or far ahead, it restarts as a
// server would: Welcome, entity updates, a keyframe and the later messages.

import { fromBinary, create, toBinary } from '@bufbuild/protobuf';
import type { Socket } from '../connection/connection.js';
import { ClientMessageSchema, ServerMessageSchema } from '../gen/jostle/v1/play_pb.js';
import type { Recording } from './recording.js';

const LEAD_TIME_US = 200_000;
const REPLAY_AHEAD_MAX_US = 1e6; // longer forward seeks restart at a keyframe
const FRAME_TIME_MAX_US = 250_000; // a longer gap between rendered frames does not advance the time further

export class RecordedStream implements Socket {
  binaryType = '';
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;

  playing = true;
  /** Playback speed; 1 is real time. */
  speed = 1;
  private renderTimeUs: number; // on the server's clock
  private readonly firstUs: number;
  private readonly lastUs: number;
  private lastFrameUs = 0;
  private next = 0; // index of the next message to deliver
  private welcomed = false;
  private seekUs: number | undefined;

  constructor(readonly recording: Recording) {
    this.firstUs = this.renderTimeUs = recording.dueUs(recording.firstTick);
    this.lastUs = recording.dueUs(recording.lastTick);
  }

  /** Opens asynchronously, as WebSockets do. */
  open(): this {
    this.welcomed = false;
    queueMicrotask(() => this.onopen?.());
    return this;
  }

  send(bytes: Uint8Array): void {
    const { message } = fromBinary(ClientMessageSchema, bytes);
    if (message.case === 'hello') {
      this.welcomed = true;
      this.seekUs ??= this.renderTimeUs;
    } else if (message.case === 'ping') {
      const { clientTimeUs } = message.value;
      const pong = create(ServerMessageSchema, { message: { case: 'pong', value: { clientTimeUs, serverTimeUs: BigInt(Math.round(this.renderTimeUs)) } } });
      this.deliver(toBinary(ServerMessageSchema, pong));
    }
  }

  close(): void {
    this.welcomed = false;
  }

  // --- time ---

  /** The rendered tick. */
  get tick(): number {
    const { welcome, firstTick, lastTick } = this.recording;
    const elapsed = Math.round(((this.renderTimeUs - this.firstUs) * welcome.tickHz) / 1e6);
    return Math.min(lastTick, firstTick + elapsed);
  }
  get seconds(): number {
    return (this.renderTimeUs - this.firstUs) / 1e6;
  }
  get length(): number {
    return (this.lastUs - this.firstUs) / 1e6;
  }

  /** Seeks to a time in seconds from the start; takes effect with the next rendered frame. */
  seek(seconds: number): void {
    this.seekUs = Math.min(this.lastUs, Math.max(this.firstUs, this.firstUs + seconds * 1e6));
  }

  play(): void {
    if (this.renderTimeUs >= this.lastUs) this.seek(0);
    this.playing = true;
  }

  /**
   * Call once per rendered frame; returns the rendered time on the server's clock. `nowUs`: local
   * clock.
   */
  advance(nowUs: number): number {
    const elapsed = Math.min(FRAME_TIME_MAX_US, Math.max(0, nowUs - this.lastFrameUs));
    this.lastFrameUs = nowUs;
    if (!this.welcomed) return this.renderTimeUs;
    if (this.seekUs !== undefined) {
      const offsetUs = this.seekUs - this.renderTimeUs;
      this.renderTimeUs = this.seekUs;
      this.seekUs = undefined;
      if (this.next === 0 || offsetUs < 0 || offsetUs > REPLAY_AHEAD_MAX_US) this.begin();
    } else if (this.playing) {
      this.renderTimeUs = Math.min(this.lastUs, this.renderTimeUs + elapsed * this.speed);
      if (this.renderTimeUs >= this.lastUs) this.playing = false;
    }
    this.deliverMessages();
    return this.renderTimeUs;
  }

  private begin(): void {
    const { messages } = this.recording;
    let first = this.recording.keyframeBefore(this.recording.firstTick);
    for (let i = first; i < messages.length; i++) if (messages[i]!.keyframe && messages[i]!.dueUs <= this.renderTimeUs) first = i;
    this.deliver(messages[0]!.bytes);
    for (let i = 1; i < first; i++) if (messages[i]!.persistent) this.deliver(messages[i]!.bytes);
    this.next = first;
  }

  private deliverMessages(): void {
    const { messages } = this.recording;
    for (; this.next < messages.length && messages[this.next]!.dueUs <= this.renderTimeUs + LEAD_TIME_US; this.next++) this.deliver(messages[this.next]!.bytes);
  }

  private deliver(bytes: Uint8Array): void {
    this.onmessage?.({ data: bytes.slice().buffer as ArrayBuffer });
  }
}
