import { create } from '@bufbuild/protobuf';
import { RoomSettingsSchema } from '@jostle/client/gen/room_pb';
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { defaultQuota, fieldOfProblem, fieldsOf, reachIn, replacedCount, setQuota, setReach, settingsOf, type Quota } from './room_form';

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

it('has the quotas of the server', () => {
  const page = readFileSync(new URL('../../../../../docs/guides/operator/rooms.md', import.meta.url), 'utf8');
  const rows = [...page.matchAll(/^\| `([a-z_]+)` \| ([0-9,]+) \| ([0-9,]+) \|/gm)];
  expect(rows.map(([, quota]) => quota)).toEqual(['bodies', 'joints', 'energy_per_second', 'explosions_per_minute']);
  const number = (text: string) => Number(text.replaceAll(',', ''));
  for (const [, quota, player, builder] of rows)
    expect([defaultQuota('player', quota as Quota), defaultQuota('builder', quota as Quota)], quota).toEqual([number(player!), number(builder!)]);
});
