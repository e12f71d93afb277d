// Module channels: lists of integers by kind and entity, delta-encoded per frame (proto/WIRE.md,
// "Channels").

import { BitReader, bitWidth, zigZagDecode } from './bit_reader.js';
import { crc32 } from './crc32.js';
import { DecodeError } from './decode_frame.js';

export interface Channel {
  readonly kind: number; // index in Welcome.channels
  readonly entity: number; // 0: the module itself
  readonly values: Int32Array;
}

/** In ascending order of kind and entity. Frames share the channels that did not change. */
export type Channels = readonly Channel[];

export const NO_CHANNELS: Channels = [];

/** Channel kind with the velocities of bodies (proto/WIRE.md, "Channels"). Prediction needs it. */
export const MOTION_CHANNEL = 'jostle.motion';

const KINDS_MAX = 64;
const CHANNELS_MAX = 4096;
const VALUES_MAX = 16 * 1024; // per channel
const FRAME_VALUES_MAX = 256 * 1024;
const ENDED_SIZE = 0xffffffff; // size of an ended channel in the CRC input

const enum Change {
  Values = 0,
  Length = 1,
  Ended = 2,
}

const precedes = (a: Channel, b: { kind: number; entity: number }) => a.kind < b.kind || (a.kind === b.kind && a.entity < b.entity);

class Digest {
  private numbers: number[] = [];

  add(kind: number, entity: number, values?: Int32Array): void {
    this.numbers.push(kind, entity, values ? values.length : ENDED_SIZE);
    if (values) for (const value of values) this.numbers.push(value);
  }
  crc(): number {
    const bytes = new DataView(new ArrayBuffer(this.numbers.length * 4));
    this.numbers.forEach((number, k) => bytes.setUint32(4 * k, number >>> 0, true));
    return crc32(new Uint8Array(bytes.buffer));
  }
}

function readValues(bits: BitReader, count: number, baseline?: Int32Array): Int32Array {
  const values = new Int32Array(count);
  if (baseline) values.set(baseline.subarray(0, count));
  let widths = 16; // four times the mean bit width of the differences
  for (let k = 0; k < count; ) {
    k += bits.expGolomb(0);
    if (k > count) throw new DecodeError('channels: run of equal values exceeds the channel');
    if (k === count) break;
    const size = bits.expGolomb(widths < 8 ? 0 : (widths >> 2) - 2);
    if (size >= 0xffffffff) throw new DecodeError('channels: difference exceeds 32 bits');
    widths += bitWidth(size) - (widths >> 2);
    values[k] = values[k]! + zigZagDecode(size + 1); // wraps around at 32 bits
    k++;
    if (bits.pastEnd) throw new DecodeError('channels: truncated data');
  }
  return values;
}

function readChange(bits: BitReader, name: string, baseline?: Channel): Int32Array | undefined {
  const change = bits.bits(2);
  if (change > Change.Ended) throw new DecodeError(`channels: ${name}: unknown change ${change}`);
  if (change !== Change.Length && !baseline) throw new DecodeError(`channels: ${name} changed but is not in the baseline`);
  if (change === Change.Ended) return undefined;
  const count = change === Change.Length ? bits.expGolomb(3) : baseline!.values.length;
  if (count > VALUES_MAX) throw new DecodeError(`channels: ${name} has more than ${VALUES_MAX} values`);
  return readValues(bits, count, baseline?.values);
}

function checkSizes(channels: Channels): void {
  const values = channels.reduce((sum, channel) => sum + channel.values.length, 0);
  if (channels.length > CHANNELS_MAX) throw new DecodeError(`channels: more than ${CHANNELS_MAX} channels`);
  if (values > FRAME_VALUES_MAX) throw new DecodeError(`channels: more than ${FRAME_VALUES_MAX} values`);
}

/**
 * The channels of a frame, decoded against those of its baseline. Throws DecodeError for malformed
 * bytes.
 */
export function decodeChannels(bytes: Uint8Array, crc: number, baseline: Channels): Channels {
  if (bytes.length === 0) return baseline;
  const bits = new BitReader(bytes);
  const count = bits.expGolomb(1) + 1;
  const channels: Channel[] = [];
  const digest = new Digest();
  let [kind, nextEntity, b] = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    const kindStep = bits.expGolomb(0);
    const entity = bits.expGolomb(2) + (kindStep === 0 ? nextEntity : 0);
    kind += kindStep;
    if (kind >= KINDS_MAX || entity > 0xffffffff) throw new DecodeError('channels: kind or entity out of range');
    nextEntity = entity + 1;
    while (b < baseline.length && precedes(baseline[b]!, { kind, entity })) channels.push(baseline[b++]!);
    const known = b < baseline.length && baseline[b]!.kind === kind && baseline[b]!.entity === entity ? baseline[b++] : undefined;
    const values = readChange(bits, `kind ${kind} of entity ${entity}`, known);
    digest.add(kind, entity, values);
    if (values) channels.push({ kind, entity, values });
    if (bits.pastEnd) throw new DecodeError('channels: truncated data');
    if (i % 256 === 255) checkSizes(channels);
  }
  while (b < baseline.length) channels.push(baseline[b++]!);
  if (!bits.atCleanEnd()) throw new DecodeError('channels: unexpected bytes after the end');
  checkSizes(channels);
  if (digest.crc() !== crc) throw new DecodeError('channels: CRC mismatch');
  return channels;
}
