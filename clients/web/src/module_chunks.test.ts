import { describe, expect, it } from 'vitest';
import { DecodeError } from './decode_frame';
import { changeChunks, NO_CHUNKS } from './module_chunks';

const chunk = (tag: string, ...data: number[]) => ({ tag, data: new Uint8Array(data) });

describe('chunks of modules', () => {
  it('are those of the base but for what changed and what ended', () => {
    const first = changeChunks(NO_CHUNKS, [chunk('craft', 1), chunk('crane', 2, 3)]);
    const second = changeChunks(first, [chunk('craft', 4), chunk('crane')]);
    expect([...second]).toEqual([['craft', new Uint8Array([4])]]);
    expect([...first.keys()]).toEqual(['craft', 'crane']);
    expect(changeChunks(second, [])).toBe(second);
    expect(changeChunks(second, [chunk('nobody')]).size).toBe(1);
  });

  it('do not hold on to the message that they came in', () => {
    const message = new Uint8Array(1000);
    const chunks = changeChunks(NO_CHUNKS, [{ tag: 'craft', data: message.subarray(10, 12) }]);
    expect(chunks.get('craft')!.buffer.byteLength).toBe(2);
  });

  it('are 64 at most', () => {
    const many = Array.from({ length: 64 }, (_, k) => chunk(`m${k}`, 1));
    const full = changeChunks(NO_CHUNKS, many);
    expect(full.size).toBe(64);
    expect(() => changeChunks(full, [chunk('another', 1)])).toThrow(DecodeError);
    expect(changeChunks(full, [chunk('another', 1), chunk('m7')]).size).toBe(64);
  });
});
