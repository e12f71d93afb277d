import { describe, expect, it } from 'vitest';
import { decodeChannels, NO_CHANNELS, type Channels } from './channels.js';
import { DecodeError } from './decode_frame.js';
import { goldenChannels } from '../testing/golden_channels.js';

describe('channels', () => {
  it('in the golden file decode to the values encoded by C++', () => {
    const decoded: Channels[] = [];
    for (const { baseline, crc, channels, packed } of goldenChannels()) {
      decoded.push(decodeChannels(packed, crc, baseline === 0 ? NO_CHANNELS : decoded[baseline - 1]!));
      expect(decoded.at(-1)).toEqual(channels);
    }
    expect(decoded.length).toBe(16);
  });

  it('are shared with the baseline when unchanged', () => {
    const golden = goldenChannels();
    const { packed, crc, baseline } = golden.find((frame) => frame.baseline !== 0 && golden[frame.baseline - 1]!.baseline === 0)!;
    const first = decodeChannels(golden[baseline - 1]!.packed, golden[baseline - 1]!.crc, NO_CHANNELS);
    expect(decodeChannels(new Uint8Array(), 0, first)).toBe(first);
    const next = decodeChannels(packed, crc, first);
    expect(next.some((channel) => first.includes(channel))).toBe(true);
  });

  it('are rejected when bits are flipped or bytes are missing', () => {
    const { packed, crc } = goldenChannels()[0]!;
    for (let bit = 0; bit < packed.length * 8; bit++) {
      const damaged = packed.slice();
      damaged[bit >> 3]! ^= 1 << (bit & 7);
      expect(() => decodeChannels(damaged, crc, NO_CHANNELS)).toThrow(DecodeError);
    }
    for (let size = 1; size < packed.length; size++) expect(() => decodeChannels(packed.subarray(0, size), crc, NO_CHANNELS)).toThrow(DecodeError);
  });
});
