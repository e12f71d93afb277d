import { create } from '@bufbuild/protobuf';
import { RoomSettingsSchema } from '@jostle/client/gen/room_pb';
import { expect, it } from 'vitest';
import { fieldOfProblem, fieldsOf, reachIn, replacedCount, setQuota, setReach, settingsOf } from './room_form';

const settings = create(RoomSettingsSchema, { title: 'Night race', tags: ['race', 'cars'], capacity: 6, joinCode: 'sesame', initialRole: 'player', permissions: { 'player.explode': 'none' }, areas: [{ name: 'start' }] });

it('an unchanged form gives the same settings', () => {
  const written = create(RoomSettingsSchema, settingsOf(fieldsOf(settings), settings.areas));
  expect(written).toEqual(settings);
});

it('a public room has no join code', () => {
  expect(settingsOf({ ...fieldsOf(settings), isPrivate: false }, []).joinCode).toBe('');
  expect(settingsOf({ ...fieldsOf(settings), tags: ' a, b  c ' }, []).tags).toEqual(['a', 'b', 'c']);
});

it('permissions and quotas contain only what differs from the default', () => {
  const { permissions, quotas } = fieldsOf(settings);
  expect([reachIn(permissions, 'player', 'explode'), reachIn(permissions, 'builder', 'explode')]).toEqual(['none', 'any']);
  expect(replacedCount(permissions, 'player')).toBe(1);
  setReach(permissions, 'player', 'explode', 'any');
  setReach(permissions, 'builder', 'kick', 'any');
  setQuota(quotas, 'player', 'bodies', 5);
  setQuota(quotas, 'builder', 'energy_per_second', 1e6);
  expect([permissions, quotas]).toEqual([{ 'builder.kick': 'any' }, { 'player.bodies': 5 }]);
});

it('finds the field of a problem', () => {
  expect(fieldOfProblem('room.title has 70 bytes; at most 64 are allowed')).toBe('title');
  expect(fieldOfProblem('room.join_code contains control characters')).toBe('joinCode');
  expect(fieldOfProblem('room.permissions: player.settings is none; the role player may not settings')).toBe('permissions');
  expect(fieldOfProblem('too many inputs')).toBeUndefined();
});
