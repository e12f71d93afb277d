// What tests/proto/snapshot/word_changes_test.cpp tells, in TypeScript.

import { create } from '@bufbuild/protobuf';
import { expect, it } from 'vitest';
import { ControlledEntityStateSchema } from '../gen/jostle/v1/play_pb.js';
import { ControlledStateDecoder, applyChanges } from './word_changes.js';

const bytes = (...all: number[]) => Uint8Array.of(...all);

it('makes a list of the one before and what changed', () => {
  const before = Uint32Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10);
  const now = applyChanges(before, 10, bytes(4, 1), bytes(0xfc, 0xfd, 0xfe, 0xff, 0, 0, 0, 0));
  expect([...now!]).toEqual([1, 2, 0xfffefdfc, 4, 5, 6, 7, 8, 0, 10]);
  expect([...applyChanges(before, 3, bytes(), bytes())!]).toEqual([1, 2, 3]);
});

it('refuses what does not belong together', () => {
  const before = Uint32Array.of(1, 2, 3);
  expect(applyChanges(before, 3, bytes(1), bytes())).toBeUndefined();
  expect(applyChanges(before, 3, bytes(1), bytes(1, 2, 3, 4, 5, 6, 7, 8))).toBeUndefined();
  expect(applyChanges(before, 3, bytes(8), bytes(1, 2, 3, 4))).toBeUndefined();
  expect(applyChanges(before, 1e6, bytes(), bytes())).toBeUndefined();
});

it('knows what is driven once it was told whole', () => {
  const driven = new ControlledStateDecoder();
  const part = create(ControlledEntityStateSchema, { entity: 5, tick: 7, module: 'vehicle', words: 2, changedMask: bytes(2), values: bytes(9, 0, 0, 0) });
  driven.apply(part);
  expect(driven.newest).toBeUndefined();
  driven.apply(create(ControlledEntityStateSchema, { ...part, tick: 3, keyframe: true, changedMask: bytes(1), values: bytes(8, 0, 0, 0) }));
  driven.apply(part);
  expect(driven.newest).toEqual({ entity: 5, tick: 7, module: 'vehicle', words: Uint32Array.of(8, 9) });
  driven.apply(create(ControlledEntityStateSchema, { ...part, entity: 6 }));
  expect(driven.newest, 'of another one, and not whole').toBeUndefined();
});
