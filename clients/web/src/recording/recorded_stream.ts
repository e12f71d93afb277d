// A recording as a stream: what a connection gets instead of a server's socket, so that everything behind it is as with a server. It
// has a time of its own, which can stand, go faster and be set; messages are handed over a little before they are shown. To go back, or
// far ahead, it begins anew as a server would: the Welcome, who is there, a keyframe, and what follows.

import { fromBinary, create, toBinary } from '@bufbuild/protobuf';
import type { Socket } from '../connection';
import { ClientMessageSchema, ServerMessageSchema } from '../gen/jostle/v1/play_pb';
import type { Recording } from './recording';

const LEAD_US = 200_000;
const WALK_US = 1e6; // so far ahead is played through
const LONGEST_PICTURE_US = 250_000; // who did not draw for longer did not watch

export class RecordedStream implements Socket {
  binaryType = '';
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;

  playing = true;
  /** Times the real one. */
  speed = 1;
  private renderTimeUs: number; // on the server's clock
  private readonly firstUs: number;
  private readonly lastUs: number;
  private drawnUs = 0;
  private next = 0; // message to be handed over
  private greeted = false;
  private wantedUs: number | undefined;

  constructor(readonly recording: Recording) {
    this.firstUs = this.renderTimeUs = recording.dueUs(recording.firstTick);
    this.lastUs = recording.dueUs(recording.lastTick);
  }

  /** As WebSockets open: by and by. */
  open(): this {
    this.greeted = false;
    queueMicrotask(() => this.onopen?.());
    return this;
  }

  send(bytes: Uint8Array): void {
    const { message } = fromBinary(ClientMessageSchema, bytes);
    if (message.case === 'hello') {
      this.greeted = true;
      this.wantedUs ??= this.renderTimeUs;
    } else if (message.case === 'ping') {
      const { clientTimeUs } = message.value;
      const pong = create(ServerMessageSchema, { message: { case: 'pong', value: { clientTimeUs, serverTimeUs: BigInt(Math.round(this.renderTimeUs)) } } });
      this.give(toBinary(ServerMessageSchema, pong));
    }
  }

  close(): void {
    this.greeted = false;
  }

  // --- its time ---

  /** The tick that is shown. */
  get tick(): number {
    const { welcome, firstTick, lastTick } = this.recording;
    const passed = Math.round(((this.renderTimeUs - this.firstUs) * welcome.tickHz) / 1e6);
    return Math.min(lastTick, firstTick + passed);
  }
  get seconds(): number {
    return (this.renderTimeUs - this.firstUs) / 1e6;
  }
  get length(): number {
    return (this.lastUs - this.firstUs) / 1e6;
  }

  /** Shows that many seconds after its beginning, with the next picture. */
  seek(seconds: number): void {
    this.wantedUs = Math.min(this.lastUs, Math.max(this.firstUs, this.firstUs + seconds * 1e6));
  }

  play(): void {
    if (this.renderTimeUs >= this.lastUs) this.seek(0);
    this.playing = true;
  }

  /** A picture is drawn, at nowUs on our clock: what it shows, on the server's clock. */
  advance(nowUs: number): number {
    const passed = Math.min(LONGEST_PICTURE_US, Math.max(0, nowUs - this.drawnUs));
    this.drawnUs = nowUs;
    if (!this.greeted) return this.renderTimeUs;
    if (this.wantedUs !== undefined) {
      const ahead = this.wantedUs - this.renderTimeUs;
      this.renderTimeUs = this.wantedUs;
      this.wantedUs = undefined;
      if (this.next === 0 || ahead < 0 || ahead > WALK_US) this.begin();
    } else if (this.playing) {
      this.renderTimeUs = Math.min(this.lastUs, this.renderTimeUs + passed * this.speed);
      if (this.renderTimeUs >= this.lastUs) this.playing = false;
    }
    this.handOver();
    return this.renderTimeUs;
  }

  private begin(): void {
    const { messages } = this.recording;
    let first = this.recording.keyframeBefore(this.recording.firstTick);
    for (let i = first; i < messages.length; i++) if (messages[i]!.keyframe && messages[i]!.dueUs <= this.renderTimeUs) first = i;
    this.give(messages[0]!.bytes);
    for (let i = 1; i < first; i++) if (messages[i]!.standing) this.give(messages[i]!.bytes);
    this.next = first;
  }

  private handOver(): void {
    const { messages } = this.recording;
    for (; this.next < messages.length && messages[this.next]!.dueUs <= this.renderTimeUs + LEAD_US; this.next++) this.give(messages[this.next]!.bytes);
  }

  private give(bytes: Uint8Array): void {
    this.onmessage?.({ data: bytes.slice().buffer as ArrayBuffer });
  }
}
