// Same cases as tests/proto/snapshot/word_changes_test.cpp.

import { create } from '@bufbuild/protobuf';
import { expect, it } from 'vitest';
import { ControlledEntityStateSchema } from '../gen/jostle/v1/play_pb.js';
import { ControlledStateDecoder, applyChanges } from './word_changes.js';

const bytes = (...all: number[]) => Uint8Array.of(...all);

it('applies changes to the previous words', () => {
  const previous = Uint32Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10);
  const now = applyChanges(previous, 10, bytes(4, 1), bytes(0xfc, 0xfd, 0xfe, 0xff, 0, 0, 0, 0));
  expect([...now!]).toEqual([1, 2, 0xfffefdfc, 4, 5, 6, 7, 8, 0, 10]);
  expect([...applyChanges(previous, 3, bytes(), bytes())!]).toEqual([1, 2, 3]);
});

it('rejects inconsistent changes', () => {
  const previous = Uint32Array.of(1, 2, 3);
  expect(applyChanges(previous, 3, bytes(1), bytes())).toBeUndefined();
  expect(applyChanges(previous, 3, bytes(1), bytes(1, 2, 3, 4, 5, 6, 7, 8))).toBeUndefined();
  expect(applyChanges(previous, 3, bytes(8), bytes(1, 2, 3, 4))).toBeUndefined();
  expect(applyChanges(previous, 1e6, bytes(), bytes())).toBeUndefined();
});

it('requires a complete controlled entity state first', () => {
  const decoder = new ControlledStateDecoder();
  const changes = create(ControlledEntityStateSchema, { entity: 5, tick: 7, module: 'vehicle', words: 2, changedMask: bytes(2), values: bytes(9, 0, 0, 0) });
  decoder.apply(changes);
  expect(decoder.newest).toBeUndefined();
  decoder.apply(create(ControlledEntityStateSchema, { ...changes, tick: 3, keyframe: true, changedMask: bytes(1), values: bytes(8, 0, 0, 0) }));
  decoder.apply(changes);
  expect(decoder.newest).toEqual({ entity: 5, tick: 7, module: 'vehicle', words: Uint32Array.of(8, 9) });
  decoder.apply(create(ControlledEntityStateSchema, { ...changes, entity: 6 }));
  expect(decoder.newest, 'another entity, without a keyframe').toBeUndefined();
});
