import { describe, expect, it } from 'vitest';
import { ValueReader } from './value_reader';

describe('ValueReader', () => {
  it('reads values in order until none are left', () => {
    const reader = new ValueReader(new Int32Array([-7, 255, 0, 0x3fc00000]));
    expect(reader.left).toBe(4);
    expect(reader.value()).toBe(-7);
    expect(reader.quantized(-1, 1, 8)).toBe(1);
    expect(reader.quantized(-8, 8, 16)).toBe(-8);
    expect(reader.f32()).toBe(1.5);
    expect([reader.left, reader.failed]).toEqual([0, false]);
  });

  it('fails past the end, on out-of-range values and on non-finite floats', () => {
    const readers: [number[], (reader: ValueReader) => number, number][] = [
      [[], (reader) => reader.value(), 0],
      [[], (reader) => reader.f32(), 0],
      [[256], (reader) => reader.quantized(-3, 3, 8), -3],
      [[-1], (reader) => reader.quantized(-3, 3, 8), -3],
      [[0x7f800000], (reader) => reader.f32(), 0], // infinite
      [[0x7fc00000], (reader) => reader.f32(), 0],
    ];
    for (const [values, read, instead] of readers) {
      const reader = new ValueReader(new Int32Array(values));
      expect(read(reader)).toBe(instead);
      expect(reader.failed).toBe(true);
    }
  });
});
