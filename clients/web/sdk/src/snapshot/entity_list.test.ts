import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { decodeEntityList } from './entity_list.js';

/** proto/golden/entities.jent; tests/proto/snapshot/golden_entities.h has the layout. */
function goldenEntityLists() {
  const bytes = readFileSync(new URL('../../../../../proto/golden/entities.jent', import.meta.url));
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 4;
  const u32 = () => view.getUint32((at += 4) - 4, true);
  expect(bytes.subarray(0, 4).toString()).toBe('JENT');
  expect(u32()).toBe(1);
  const lists = Array.from({ length: u32() }, () => {
    const [prototypes, count, size] = [u32(), u32(), u32()];
    const entities = Array.from({ length: count }, () => ({ id: u32(), prototype: u32() }));
    const packed = new Uint8Array(bytes.subarray(at, (at += size)));
    return { prototypes, entities, packed };
  });
  expect(at).toBe(bytes.length);
  return lists;
}

test('decodes the golden lists of the C++ encoder', () => {
  const lists = goldenEntityLists();
  expect(lists.length).toBe(4);
  for (const { prototypes, entities, packed } of lists) expect(decodeEntityList(packed, prototypes)).toEqual(entities);
});

test('refuses malformed bytes with the position', () => {
  const { prototypes, packed } = goldenEntityLists()[1]!;
  expect(() => decodeEntityList(packed.subarray(0, packed.length - 1), prototypes)).toThrow(/truncated data \(at bit/);
  expect(() => decodeEntityList(new Uint8Array([...packed, 0]), prototypes)).toThrow(/at the end/);
  expect(() => decodeEntityList(packed, 0)).toThrow(/0 prototypes; there must be 1 to 65536/);
  expect(() => decodeEntityList(new Uint8Array(), 1)).toThrow(/truncated/);
});
