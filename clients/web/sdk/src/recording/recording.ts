// A recording, which jostle-record wrote, as a list of what a server sent (proto/WIRE.md, "Recordings"). All of it is read and checked
// when it is opened, up to the first record that is not whole: so one that was cut off is read as far as it goes. Bytes are foreign.

import { fromBinary } from '@bufbuild/protobuf';
import { crc32 } from '../snapshot/crc32.js';
import { ServerMessageSchema, type ServerMessage, type Snapshot, type Welcome } from '../gen/jostle/v1/play_pb.js';

/** It is no recording that can be played. */
export class RecordingError extends Error {}

export interface RecordedMessage {
  /** The message as it came. */
  readonly bytes: Uint8Array;
  /** Of a snapshot; 0: it is none. */
  readonly frame: number;
  /** Of a snapshot: when its tick was due, on the server's clock. Of others: of the snapshot before. */
  readonly dueUs: number;
  /** A snapshot that names no frame before it. */
  readonly keyframe: boolean;
  /** It counts from there on: a roster, or a part of a large shape. */
  readonly persistent: boolean;
}

const HEADER_BYTES = 16;
const RECORD_HEADER_BYTES = 16; // of a record, before its message
const CRC_FROM = 8;
const MESSAGE_BYTES_MAX = 2 ** 26;
const VERSION = 1;

const recordingError = (byte: number, what: string) => new RecordingError(`byte ${byte}: ${what}`);
const startsWith = (bytes: Uint8Array, word: string) => [...word].every((letter, i) => bytes[i] === letter.charCodeAt(0));

export class Recording {
  readonly messages: readonly RecordedMessage[]; // the first is the Welcome
  readonly welcome: Welcome;
  readonly firstTick: number; // that can be shown
  readonly lastTick: number;
  /** Why it ends where it does; empty: it is whole. */
  readonly truncationReason: string;

  constructor(bytes: Uint8Array) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    if (bytes.length < HEADER_BYTES || !startsWith(bytes, 'JREC'))
      throw recordingError(0, 'it is no recording, which begins with the letters JREC; jostle-record makes one');
    const version = view.getUint32(4, true);
    if (version !== VERSION) throw recordingError(4, `it is a recording of version ${version}; this page plays version ${VERSION}`);
    const messages: RecordedMessage[] = [];
    let truncationReason = '';
    let dueUs = 0;
    let welcome: Welcome | undefined;
    // No message is empty: where the length is 0 the index begins, and all that it says has been seen by then.
    for (let at = HEADER_BYTES; at < bytes.length && (bytes.length - at < 4 || view.getUint32(at, true) !== 0); ) {
      const read = readRecord(bytes, view, at);
      if (typeof read === 'string') {
        truncationReason = `byte ${at}: ${read}`;
        break;
      }
      const { message, length } = read;
      if (!welcome) {
        if (message.case !== 'welcome') throw recordingError(at, 'its first message is no Welcome; without one nothing after it can be understood');
        welcome = message.value;
        if (welcome.cells) throw recordingError(at, 'it tells of parts of a world, which cannot be played');
        if (!(welcome.tickHz > 0)) throw recordingError(at, `its world has ${welcome.tickHz} ticks a second`);
      }
      const snapshot: Snapshot | undefined = message.case === 'snapshot' ? message.value : undefined;
      if (snapshot) dueUs = Number(welcome.epochUs) + Math.round((snapshot.frame * 1e6) / welcome.tickHz) + Number(snapshot.lateUs);
      messages.push({
        bytes: bytes.subarray(at + RECORD_HEADER_BYTES, at + RECORD_HEADER_BYTES + length),
        frame: snapshot?.frame ?? 0,
        dueUs,
        keyframe: snapshot?.baselines === 0,
        persistent: message.case === 'entityUpdate' || message.case === 'geometry',
      });
      at += RECORD_HEADER_BYTES + length;
    }
    const first = messages.find(({ keyframe }) => keyframe);
    if (!welcome || !first) throw new RecordingError(`nothing was recorded that could be shown${truncationReason && `: ${truncationReason}`}`);
    this.messages = messages;
    this.welcome = welcome;
    this.truncationReason = truncationReason;
    this.firstTick = first.frame;
    this.lastTick = Math.max(...tail(messages));
  }

  /** Where to begin to show a tick: the last keyframe that is not later, or the first one; an index of messages. */
  keyframeBefore(tick: number): number {
    let found = -1;
    for (let i = 0; i < this.messages.length; i++) {
      const { keyframe, frame } = this.messages[i]!;
      if (keyframe && (found < 0 || frame <= tick)) found = i;
    }
    return found;
  }

  /** When the tick was due, on the server's clock: of the last snapshot that is not later. */
  dueUs(tick: number): number {
    let due = this.messages[this.keyframeBefore(tick)]!.dueUs;
    for (const message of this.messages) if (message.frame > 0 && message.frame <= tick) due = Math.max(due, message.dueUs);
    return due;
  }
}

/** Frames of the last snapshots. */
function tail(messages: readonly RecordedMessage[]): number[] {
  return messages.filter(({ frame }) => frame > 0).slice(-2).map(({ frame }) => frame);
}

/** Words: why it is none. */
function readRecord(bytes: Uint8Array, view: DataView, at: number): { message: ServerMessage['message']; length: number } | string {
  if (bytes.length - at < RECORD_HEADER_BYTES) return 'the file ends within the head of a record: it was cut off there';
  const length = view.getUint32(at, true);
  if (length > MESSAGE_BYTES_MAX) return `a message of ${length} bytes, where 1 to ${MESSAGE_BYTES_MAX} can be: it is damaged`;
  const end = at + RECORD_HEADER_BYTES + length;
  if (end > bytes.length) return `a message of ${length} bytes, of which the file has ${bytes.length - at - RECORD_HEADER_BYTES}: it was truncationReason off there`;
  if (crc32(bytes.subarray(at + CRC_FROM, end)) !== view.getUint32(at + 4, true)) return 'the CRC of the record does not match: it is damaged';
  try {
    return { message: fromBinary(ServerMessageSchema, bytes.subarray(at + RECORD_HEADER_BYTES, end)).message, length };
  } catch {
    return 'the record is no ServerMessage';
  }
}
