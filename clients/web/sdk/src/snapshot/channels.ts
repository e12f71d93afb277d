// What modules of the world tell: lists of whole numbers by kind and entity, frame by frame (proto/WIRE.md, "Channels").

import { BitReader, bitWidth, zigZagDecode } from './bit_reader.js';
import { crc32 } from './crc32.js';
import { DecodeError } from './decode_frame.js';

export interface Channel {
  readonly kind: number; // a place in Welcome.channels
  readonly entity: number; // 0: the module itself
  readonly values: Int32Array;
}

/** In rising order of kind and entity. Frames share those that did not change. */
export type Channels = readonly Channel[];

export const NO_CHANNELS: Channels = [];

const KINDS_MAX = 64;
const CHANNELS_MAX = 4096;
const VALUES_MAX = 16 * 1024; // of a channel
const FRAME_VALUES_MAX = 256 * 1024;
const ENDED_SIZE = 0xffffffff; // in what the CRC covers

const enum Change {
  Values = 0,
  Length = 1,
  Ended = 2,
}

const before = (a: Channel, b: { kind: number; entity: number }) => a.kind < b.kind || (a.kind === b.kind && a.entity < b.entity);

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

function readValues(bits: BitReader, count: number, base?: Int32Array): Int32Array {
  const values = new Int32Array(count);
  if (base) values.set(base.subarray(0, count));
  let widths = 16; // four times their mean
  for (let k = 0; k < count; ) {
    k += bits.expGolomb(0);
    if (k > count) throw new DecodeError('channels: a run of equal values goes past the end');
    if (k === count) break;
    const size = bits.expGolomb(widths < 8 ? 0 : (widths >> 2) - 2);
    if (size >= 0xffffffff) throw new DecodeError('channels: a difference beyond 32 bits');
    widths += bitWidth(size) - (widths >> 2);
    values[k] = values[k]! + zigZagDecode(size + 1); // wraps around
    k++;
    if (bits.pastEnd) throw new DecodeError('channels: the bytes end early');
  }
  return values;
}

function readChange(bits: BitReader, name: string, base?: Channel): Int32Array | undefined {
  const change = bits.bits(2);
  if (change > Change.Ended) throw new DecodeError(`channels: ${name} changes in a way that is not known`);
  if (change !== Change.Length && !base) throw new DecodeError(`channels: ${name} changed, but was not there`);
  if (change === Change.Ended) return undefined;
  const count = change === Change.Length ? bits.expGolomb(3) : base!.values.length;
  if (count > VALUES_MAX) throw new DecodeError(`channels: ${name} has more than ${VALUES_MAX} values`);
  return readValues(bits, count, base?.values);
}

function checkSizes(channels: Channels): void {
  const values = channels.reduce((sum, channel) => sum + channel.values.length, 0);
  if (channels.length > CHANNELS_MAX) throw new DecodeError(`channels: more than ${CHANNELS_MAX} of them`);
  if (values > FRAME_VALUES_MAX) throw new DecodeError(`channels: more than ${FRAME_VALUES_MAX} values`);
}

/** The channels of a frame, from those of its base. Foreign: throws DecodeError. */
export function decodeChannels(bytes: Uint8Array, crc: number, base: Channels): Channels {
  if (bytes.length === 0) return base;
  const bits = new BitReader(bytes);
  const count = bits.expGolomb(1) + 1;
  const channels: Channel[] = [];
  const digest = new Digest();
  let [kind, nextEntity, b] = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    const further = bits.expGolomb(0);
    const entity = bits.expGolomb(2) + (further === 0 ? nextEntity : 0);
    kind += further;
    if (kind >= KINDS_MAX || entity > 0xffffffff) throw new DecodeError('channels: a kind or an entity out of range');
    nextEntity = entity + 1;
    while (b < base.length && before(base[b]!, { kind, entity })) channels.push(base[b++]!);
    const known = b < base.length && base[b]!.kind === kind && base[b]!.entity === entity ? base[b++] : undefined;
    const values = readChange(bits, `kind ${kind} of entity ${entity}`, known);
    digest.add(kind, entity, values);
    if (values) channels.push({ kind, entity, values });
    if (bits.pastEnd) throw new DecodeError('channels: the bytes end early');
    if (i % 256 === 255) checkSizes(channels);
  }
  while (b < base.length) channels.push(base[b++]!);
  if (!bits.atCleanEnd()) throw new DecodeError('channels: there are bytes after the end');
  checkSizes(channels);
  if (digest.crc() !== crc) throw new DecodeError('channels: the CRC does not match');
  return channels;
}
