import { create } from '@bufbuild/protobuf';
import { PlayerRole } from '@jostle/client/gen/play_pb';
import { RoomUpdateSchema } from '@jostle/client/gen/room_pb';
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { ACTION_NAMES, ACTIONS, defaultReach, ROLES, RoomRules } from './room_rules';

const room = (permissions: Record<string, string> = {}) => create(RoomUpdateSchema, { settings: { permissions } });

it('has the table of the server', () => {
  const page = readFileSync(new URL('../../../../../docs/guides/operator/rooms.md', import.meta.url), 'utf8');
  const rows = [...page.matchAll(/^\| `([a-z_]+)`[^|]*\| (none|own|unowned|any) \| (\w+) \| (\w+) \| (\w+) \|$/gm)];
  expect(rows.map(([, action]) => action).sort()).toEqual([...ACTION_NAMES].sort());
  for (const [, action, ...reaches] of rows) expect(ACTIONS[action as keyof typeof ACTIONS][1], action).toBe(reaches.join(' '));
});

it('explains which rule refuses', () => {
  const rules = new RoomRules(room({ 'player.explode': 'none', 'player.drag': 'own' }), PlayerRole.PLAYER);
  expect(rules.refusal('explode')).toBe('room.permissions: player.explode is none; the role player may not explode');
  expect(rules.refusal('drag', 'scene')).toBe('room.permissions: player.drag is own; the role player may not drag an entity of the scene');
  expect([rules.refusal('drag'), rules.refusal('drag', 'self'), rules.refusal('spawn')]).toEqual(['', '', '']);
  expect([rules.isReplaced('explode'), rules.isReplaced('kick')]).toEqual([true, false]);
});

it('replaced entries allow more as well', () => {
  expect(new RoomRules(room(), PlayerRole.BUILDER).may('kick')).toBe(false);
  expect(new RoomRules(room({ 'builder.kick': 'any' }), PlayerRole.BUILDER).may('kick')).toBe(true);
  expect(new RoomRules(room({ 'builder.kick': 'sometimes' }), PlayerRole.BUILDER).may('kick')).toBe(false);
});

it('a world that is no room has no roles', () => {
  const rules = new RoomRules(undefined, PlayerRole.PLAYER);
  expect(ACTION_NAMES.filter((action) => rules.may(action))).toEqual(['spawn', 'drag', 'push', 'explode', 'delete', 'joints', 'control', 'edit', 'clone', 'message']);
  expect([rules.may('edit', 'self'), rules.may('edit', 'scene')]).toEqual([true, false]);
  expect(new RoomRules(undefined, PlayerRole.SPECTATOR).may('spawn')).toBe(false);
});

it('every role has a reach for every action', () => {
  for (const role of ROLES) for (const action of ACTION_NAMES) expect(['none', 'own', 'unowned', 'any']).toContain(defaultReach(role, action));
});
