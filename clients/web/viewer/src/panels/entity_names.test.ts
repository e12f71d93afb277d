import { create } from '@bufbuild/protobuf';
import { expect, it } from 'vitest';
import { EntitySchema } from '@jostle/client/gen/play_pb';
import { describePick, entityName } from './entity_names';

const field = { kind: { case: 'heightField' as const, value: {} } };
const ball = { kind: { case: 'sphere' as const, value: { radius: 1 } } };

it('uses the entity name, or else the kind of its first shape', () => {
  expect(entityName(create(EntitySchema, { name: 'goal', shapes: [ball] }), 3)).toBe('goal');
  expect(entityName(create(EntitySchema, { shapes: [ball] }), 3)).toBe('ball 3');
  expect(entityName(undefined, 3)).toBe('body 3');
});

it('describes a pick by name, id, hit shape and distance', () => {
  const hill = create(EntitySchema, { name: 'hill', shapes: [ball, field] });
  expect(describePick(hill, { entity: 12, shape: 1, distance: 14.239 })).toBe('hill · id 12 · height field · 14.2 m away');
  expect(describePick(undefined, { entity: 5, shape: 0, distance: 1.5 })).toBe('no name · id 5 · shape · 1.50 m away');
});
