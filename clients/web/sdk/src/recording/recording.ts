// A recording of jostle-record, as the list of messages that a server sent (proto/WIRE.md,
// "Recordings"). It is read and checked when it is opened. Damaged records are skipped, with the
// snapshots that cannot be decoded without them. Bytes are untrusted.

import { fromBinary } from '@bufbuild/protobuf';
import { crc32 } from '../snapshot/crc32.js';
import { ServerMessageSchema, type ServerMessage, type Snapshot, type Welcome } from '../gen/jostle/v1/play_pb.js';

/** The file is not a recording that can be played. */
export class RecordingError extends Error {}

export interface RecordedMessage {
  /** The encoded ServerMessage. */
  readonly bytes: Uint8Array;
  /** Frame of a snapshot; 0: another message. */
  readonly frame: number;
  /**
   * When the tick of a snapshot was due, on the server's clock; of other messages, that of the previous
   * snapshot.
   */
  readonly dueUs: number;
  /** A snapshot without baselines. */
  readonly keyframe: boolean;
  /** Valid for all later frames: an entity update or a chunk of a large shape. */
  readonly persistent: boolean;
}

/** Bytes that were skipped because no record can be read there. */
export interface DamagedRange {
  readonly byte: number;
  readonly length: number;
  /** The first error in it: "byte 6000: CRC mismatch: the record is damaged". */
  readonly reason: string;
  /** Intact snapshots after it that were skipped, up to the next keyframe. */
  readonly snapshotsSkipped: number;
}

const HEADER_BYTES = 16;
const RECORD_HEADER_BYTES = 16;
const CRC_FROM = 8;
const MESSAGE_BYTES_MAX = 2 ** 26;
const RESYNC_BYTES_MAX = 2 ** 26; // bounds what a crafted file can make a search read
const VERSION = 1;

const recordingError = (byte: number, what: string) => new RecordingError(`byte ${byte}: ${what}`);
const startsWith = (bytes: Uint8Array, word: string) => [...word].every((letter, i) => bytes[i] === letter.charCodeAt(0));

export class Recording {
  readonly messages: readonly RecordedMessage[]; // the first is the Welcome
  readonly welcome: Welcome;
  readonly firstTick: number; // first tick that can be rendered
  readonly lastTick: number;
  /** Why reading stopped before the end of the file; empty: it was read to its end. */
  readonly truncationReason: string;
  /** Damage that was skipped, in the order of the file. */
  readonly damage: readonly DamagedRange[];

  constructor(bytes: Uint8Array) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    if (bytes.length < HEADER_BYTES || !startsWith(bytes, 'JREC'))
      throw recordingError(0, 'not a recording: must start with "JREC"; create one with jostle-record');
    const version = view.getUint32(4, true);
    if (version !== VERSION) throw recordingError(4, `unsupported version ${version}; supported: ${VERSION}`);
    const messages: RecordedMessage[] = [];
    const damage: { byte: number; length: number; reason: string; snapshotsSkipped: number }[] = [];
    let truncationReason = '';
    let needKeyframe = false; // since the last damage
    let dueUs = 0;
    let welcome: Welcome | undefined;
    // Messages are not empty: a length of 0 starts the index, which only repeats what was read before.
    for (let at = HEADER_BYTES; at < bytes.length && (bytes.length - at < 4 || view.getUint32(at, true) !== 0); ) {
      const read = readRecord(bytes, view, at);
      if (typeof read === 'string') {
        const reason = `byte ${at}: ${read}`;
        const next = welcome && nextIntact(bytes, view, at);
        if (!next) {
          truncationReason = reason;
          break;
        }
        damage.push({ byte: at, length: next - at, reason, snapshotsSkipped: 0 });
        needKeyframe = true;
        at = next;
        continue;
      }
      const { message, length } = read;
      if (!welcome) {
        if (message.case !== 'welcome') throw recordingError(at, 'the first message is not a Welcome');
        welcome = message.value;
        if (welcome.cells) throw recordingError(at, 'recordings of an area of interest cannot be played');
        if (!(welcome.tickHz > 0)) throw recordingError(at, `invalid tick rate ${welcome.tickHz} Hz`);
      }
      const snapshot: Snapshot | undefined = message.case === 'snapshot' ? message.value : undefined;
      if (snapshot) dueUs = Number(welcome.epochUs) + Math.round((snapshot.frame * 1e6) / welcome.tickHz) + Number(snapshot.lateUs);
      at += RECORD_HEADER_BYTES + length;
      const keyframe = snapshot?.baselines === 0;
      if (keyframe) needKeyframe = false;
      if (snapshot && needKeyframe) {
        damage.at(-1)!.snapshotsSkipped++;
        continue;
      }
      messages.push({
        bytes: bytes.subarray(at - length, at),
        frame: snapshot?.frame ?? 0,
        dueUs,
        keyframe,
        persistent: message.case === 'entityUpdate' || message.case === 'geometry',
      });
    }
    const first = messages.find(({ keyframe }) => keyframe);
    if (!welcome || !first) throw new RecordingError(`the recording has no keyframe${truncationReason && `: ${truncationReason}`}`);
    this.messages = messages;
    this.welcome = welcome;
    this.truncationReason = truncationReason;
    this.damage = damage;
    this.firstTick = first.frame;
    this.lastTick = Math.max(...tail(messages));
  }

  /**
   * Index of the message from which to render a tick: the last keyframe at or before it, or else the
   * first keyframe.
   */
  keyframeBefore(tick: number): number {
    let found = -1;
    for (let i = 0; i < this.messages.length; i++) {
      const { keyframe, frame } = this.messages[i]!;
      if (keyframe && (found < 0 || frame <= tick)) found = i;
    }
    return found;
  }

  /** When the tick was due, on the server's clock: of the last snapshot at or before it. */
  dueUs(tick: number): number {
    let due = this.messages[this.keyframeBefore(tick)]!.dueUs;
    for (const message of this.messages) if (message.frame > 0 && message.frame <= tick) due = Math.max(due, message.dueUs);
    return due;
  }
}

/** Frames of the last two snapshots. */
function tail(messages: readonly RecordedMessage[]): number[] {
  return messages.filter(({ frame }) => frame > 0).slice(-2).map(({ frame }) => frame);
}

/** A string is the reason why the record cannot be read. */
function readRecord(bytes: Uint8Array, view: DataView, at: number): { message: ServerMessage['message']; length: number } | string {
  if (bytes.length - at < RECORD_HEADER_BYTES) return 'truncated record header';
  const length = view.getUint32(at, true);
  if (length > MESSAGE_BYTES_MAX) return `invalid message length ${length}; must be 1 to ${MESSAGE_BYTES_MAX} bytes`;
  const end = at + RECORD_HEADER_BYTES + length;
  if (end > bytes.length) return `truncated message: ${bytes.length - at - RECORD_HEADER_BYTES} of ${length} bytes`;
  if (crc32(bytes.subarray(at + CRC_FROM, end)) !== view.getUint32(at + 4, true)) return 'CRC mismatch: the record is damaged';
  try {
    return { message: fromBinary(ServerMessageSchema, bytes.subarray(at + RECORD_HEADER_BYTES, end)).message, length };
  } catch {
    return 'the record is not a ServerMessage';
  }
}

/**
 * Where the next intact record begins; undefined: there is none. Tries each byte; random bytes rarely
 * have a plausible length.
 */
function nextIntact(bytes: Uint8Array, view: DataView, from: number): number | undefined {
  let bytesLeft = RESYNC_BYTES_MAX;
  for (let at = from + 1; at + RECORD_HEADER_BYTES < bytes.length; at++) {
    const length = view.getUint32(at, true);
    if (length === 0 || length > MESSAGE_BYTES_MAX || length > bytes.length - at - RECORD_HEADER_BYTES) continue;
    if (length > bytesLeft) return undefined;
    bytesLeft -= length;
    if (typeof readRecord(bytes, view, at) !== 'string') return at;
  }
  return undefined;
}
