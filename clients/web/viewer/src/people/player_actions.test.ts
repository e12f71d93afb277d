import { PlayerRole } from '@jostle/client/gen/play_pb';
import { expect, it } from 'vitest';
import { actionsFor } from './player_actions';

const of = (ownRole: PlayerRole, role: PlayerRole, isRoom = true) => actionsFor({ isRoom, ownRole, role, hidden: false });

it('offers moderation only of lower roles, and only in rooms', () => {
  expect(of(PlayerRole.OWNER, PlayerRole.PLAYER, false)).toEqual(['follow', 'hide', 'report']);
  expect(of(PlayerRole.SPECTATOR, PlayerRole.PLAYER)).toEqual(['follow', 'hide', 'report']);
  expect(of(PlayerRole.PLAYER, PlayerRole.PLAYER)).toEqual(['follow', 'hide', 'report', 'vote']);
  expect(of(PlayerRole.BUILDER, PlayerRole.PLAYER)).toEqual(['follow', 'hide', 'report', 'vote', 'mute', 'unmute']);
  expect(of(PlayerRole.BUILDER, PlayerRole.BUILDER)).not.toContain('mute');
  expect(of(PlayerRole.OWNER, PlayerRole.BUILDER).slice(-5)).toEqual(['clean_up', 'kick', 'ban', 'player', 'owner']);
});

it('offers to end an own mute', () => {
  expect(actionsFor({ isRoom: false, ownRole: PlayerRole.PLAYER, role: PlayerRole.PLAYER, hidden: true })).toEqual(['follow', 'show', 'report']);
});
