import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { decodeFrame, frameCrc, type EntityState, type QuantizedFrame } from './decode_frame.js';

const folder = new URL('../../../../../proto/golden/', import.meta.url);

/** WIRE.md, "Golden frames". */
function readGolden(name: string) {
  const bytes = readFileSync(new URL(name, folder));
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 4;
  const u32 = () => view.getUint32((at += 4) - 4, true);
  expect(bytes.subarray(0, 4).toString()).toBe('JGLD');
  const codec = u32();
  expect(codec).toBe(name.startsWith('range_') ? 2 : 1);
  const spec = { unitsPerMeter: u32(), rotationComponent: u32() };
  const frames = Array.from({ length: u32() }, () => {
    const [frame, baseline, baseline2, baseline3, crc, count, size] = [u32(), u32(), u32(), u32(), u32(), u32(), u32()];
    const entities: EntityState[] = [];
    for (let i = 0; i < count!; i++, at += 24)
      entities.push({
        id: view.getUint32(at, true),
        position: [view.getInt32(at + 4, true), view.getInt32(at + 8, true), view.getInt32(at + 12, true)],
        largest: view.getUint8(at + 16),
        rotation: [view.getInt16(at + 17, true), view.getInt16(at + 19, true), view.getInt16(at + 21, true)],
        atRest: view.getUint8(at + 23) === 1,
      });
    const packed = new Uint8Array(bytes.subarray(at, (at += size!)));
    return { frame: frame!, baselines: [baseline!, baseline2!, baseline3!], crc: crc!, entities, packed };
  });
  expect(at).toBe(bytes.length);
  return { codec, spec, frames };
}

const names = readdirSync(folder).filter((name) => name.endsWith('.bin'));

describe('golden frames', () => {
  it('are complete', () => expect(names.length).toBe(14));

  it.each(names)('%s decodes to the frame encoded by C++', (name) => {
    const { codec, spec, frames } = readGolden(name);
    const decoded = new Map<number, QuantizedFrame>();
    for (const golden of frames) {
      const [baseline, baseline2, baseline3] = golden.baselines.map((number) => decoded.get(number));
      const frame = decodeFrame(golden.frame, golden.packed, { baseline, baseline2, baseline3 }, spec, 1000, codec);
      expect(frame.entities).toEqual(golden.entities);
      expect(frameCrc(frame)).toBe(golden.crc);
      decoded.set(frame.frame, frame);
    }
  });
});

it.each([0, 16384, 2 ** 32 - 1])('rejects a quantization with M = %d', (rotationComponent) => {
  const decode = () => decodeFrame(1, new Uint8Array(1), {}, { unitsPerMeter: 512, rotationComponent });
  expect(decode).toThrow('quantization out of range');
});

describe.each(['restless.bin', 'range_restless.bin'])('damaged bytes of %s', (name) => {
  it('are rejected or have another CRC, with no more entities than the limit', () => {
    const { codec, spec, frames } = readGolden(name);
    const golden = frames[0]!;
    let rejected = 0;
    let same = 0;
    for (let bit = 0; bit < golden.packed.length * 8; bit++) {
      const damaged = golden.packed.slice();
      damaged[bit >> 3]! ^= 1 << (bit & 7);
      try {
        const frame = decodeFrame(golden.frame, damaged, {}, spec, 100, codec);
        expect(frame.entities.length).toBeLessThanOrEqual(100);
        if (frameCrc(frame) === golden.crc) same++;
      } catch (error) {
        expect(String(error)).toMatch(/at (bit|byte) \d+/);
        rejected++;
      }
    }
    expect(rejected).toBeGreaterThan(20);
    expect(same).toBeLessThan(codec === 1 ? 1 : 8); // the last byte of a range coder has unused bits
  });
});
