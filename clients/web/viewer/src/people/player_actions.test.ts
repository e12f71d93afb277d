import { create } from '@bufbuild/protobuf';
import { PlayerRole } from '@jostle/client/gen/play_pb';
import { RoomUpdateSchema } from '@jostle/client/gen/room_pb';
import { expect, it } from 'vitest';
import { RoomRules } from '../room/room_rules';
import { actionsFor } from './player_actions';

const room = (permissions: Record<string, string> = {}) => create(RoomUpdateSchema, { settings: { permissions } });
const offered = (ownRole: PlayerRole, role: PlayerRole, of = room() as ReturnType<typeof room> | undefined) => actionsFor({ rules: new RoomRules(of, ownRole), ownRole, role, hidden: false });
const allowed = (...args: Parameters<typeof offered>) => offered(...args).map(({ action }) => action);

it('offers moderation only of lower roles, and only in rooms', () => {
  expect(actionsFor({ rules: new RoomRules(undefined, PlayerRole.OWNER), ownRole: PlayerRole.OWNER, role: PlayerRole.PLAYER, hidden: false }).map(({ action }) => action)).toEqual(['follow', 'hide', 'report']);
  expect(allowed(PlayerRole.SPECTATOR, PlayerRole.PLAYER)).toEqual(['follow', 'hide', 'report']);
  expect(allowed(PlayerRole.PLAYER, PlayerRole.PLAYER)).toEqual(['follow', 'hide', 'report', 'vote']);
  expect(allowed(PlayerRole.BUILDER, PlayerRole.PLAYER)).toEqual(['follow', 'hide', 'report', 'vote', 'mute', 'unmute']);
  expect(allowed(PlayerRole.BUILDER, PlayerRole.BUILDER)).not.toContain('mute');
  expect(allowed(PlayerRole.OWNER, PlayerRole.BUILDER).slice(-5)).toEqual(['clean_up', 'kick', 'ban', 'player', 'owner']);
});

it('follows the permissions that the room replaces', () => {
  const replaced = room({ 'builder.kick': 'any', 'builder.mute': 'none', 'builder.set_role': 'any', 'builder.clean_up': 'any' });
  const actions = offered(PlayerRole.BUILDER, PlayerRole.PLAYER, replaced);
  expect(actions.filter(({ refusal }) => refusal === '').map(({ action }) => action)).toEqual(['follow', 'hide', 'report', 'vote', 'clean_up', 'kick']);
  expect(actions.find(({ action }) => action === 'mute')?.refusal).toBe('room.permissions: builder.mute is none; the role builder may not mute');
});

it('offers to end an own mute', () => {
  expect(actionsFor({ rules: new RoomRules(undefined, PlayerRole.PLAYER), ownRole: PlayerRole.PLAYER, role: PlayerRole.PLAYER, hidden: true })[1]).toEqual({ action: 'show', refusal: '' });
});
