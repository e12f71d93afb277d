import { describe, expect, it } from 'vitest';
import { decodeChannels, NO_CHANNELS, type Channels } from './channels.js';
import { DecodeError } from './decode_frame.js';
import { goldenChannels } from '../testing/golden_channels.js';

describe('channels', () => {
  it('of the golden file decode to what C++ encoded', () => {
    const decoded: Channels[] = [];
    for (const { base, crc, channels, packed } of goldenChannels()) {
      decoded.push(decodeChannels(packed, crc, base === 0 ? NO_CHANNELS : decoded[base - 1]!));
      expect(decoded.at(-1)).toEqual(channels);
    }
    expect(decoded.length).toBe(16);
  });

  it('are those of the base, the very objects, where nothing changed', () => {
    const golden = goldenChannels();
    const { packed, crc, base } = golden.find((frame) => frame.base !== 0 && golden[frame.base - 1]!.base === 0)!;
    const first = decodeChannels(golden[base - 1]!.packed, golden[base - 1]!.crc, NO_CHANNELS);
    expect(decodeChannels(new Uint8Array(), 0, first)).toBe(first);
    const next = decodeChannels(packed, crc, first);
    expect(next.some((channel) => first.includes(channel))).toBe(true);
  });

  it('are refused when a bit is wrong or bytes are missing, never read as something else', () => {
    const { packed, crc } = goldenChannels()[0]!;
    for (let bit = 0; bit < packed.length * 8; bit++) {
      const bad = packed.slice();
      bad[bit >> 3]! ^= 1 << (bit & 7);
      expect(() => decodeChannels(bad, crc, NO_CHANNELS)).toThrow(DecodeError);
    }
    for (let size = 1; size < packed.length; size++) expect(() => decodeChannels(packed.subarray(0, size), crc, NO_CHANNELS)).toThrow(DecodeError);
  });
});
