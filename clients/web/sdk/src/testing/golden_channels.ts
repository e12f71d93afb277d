// Reads the golden channels for tests.

import { readFileSync } from 'node:fs';
import { expect } from 'vitest';
import type { Channel } from '../snapshot/channels.js';

/**
 * proto/golden/channels.jchn; tests/proto/snapshot/channel_motion.h has the layout. Baselines are list
 * indices from 1.
 */
export function goldenChannels() {
  const bytes = readFileSync(new URL('../../../../../proto/golden/channels.jchn', import.meta.url));
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 4;
  const u32 = () => view.getUint32((at += 4) - 4, true);
  expect(bytes.subarray(0, 4).toString()).toBe('JCHN');
  expect(u32()).toBe(1);
  const frames = Array.from({ length: u32() }, () => {
    const [baseline, crc, count, size] = [u32(), u32(), u32(), u32()];
    const channels = Array.from({ length: count }, (): Channel => {
      const [kind, entity, length] = [u32(), u32(), u32()];
      return { kind, entity, values: Int32Array.from({ length }, () => view.getInt32((at += 4) - 4, true)) };
    });
    const packed = new Uint8Array(bytes.subarray(at, (at += size)));
    return { baseline, crc, channels, packed };
  });
  expect(at).toBe(bytes.length);
  return frames;
}
