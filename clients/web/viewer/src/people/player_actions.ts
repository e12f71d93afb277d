// The actions of a user on another player: local ones, and those that the default permissions of rooms allow.
// The server decides; a room may have other permissions (docs/guides/operator/rooms.md).

import { PlayerRole } from '@jostle/client/gen/play_pb';

export type PlayerAction = 'follow' | 'hide' | 'show' | 'report' | 'vote' | 'mute' | 'unmute' | 'clean_up' | 'kick' | 'ban' | 'player' | 'builder' | 'owner';

export const ACTION_LABELS: Record<PlayerAction, string> = {
  follow: 'Follow',
  hide: 'Mute for me',
  show: 'Unmute for me',
  report: 'Report …',
  vote: 'Vote to kick',
  mute: 'Mute for all, 5 minutes',
  unmute: 'End the mute for all',
  clean_up: 'Delete bodies',
  kick: 'Kick',
  ban: 'Ban for 24 hours …',
  player: 'Make player',
  builder: 'Make builder',
  owner: 'Make owner …',
};

export const ROLE_NAMES: Record<number, string> = {
  [PlayerRole.SPECTATOR]: 'spectator',
  [PlayerRole.PLAYER]: 'player',
  [PlayerRole.BUILDER]: 'builder',
  [PlayerRole.OWNER]: 'owner',
};

export interface ActionContext {
  readonly isRoom: boolean;
  readonly ownRole: PlayerRole;
  readonly role: PlayerRole;
  readonly hidden: boolean;
}

export function actionsFor({ isRoom, ownRole, role, hidden }: ActionContext): PlayerAction[] {
  const actions: PlayerAction[] = ['follow', hidden ? 'show' : 'hide', 'report'];
  if (!isRoom) return actions;
  if (ownRole >= PlayerRole.PLAYER) actions.push('vote');
  if (ownRole <= role) return actions;
  if (ownRole >= PlayerRole.BUILDER) actions.push('mute', 'unmute');
  if (ownRole >= PlayerRole.OWNER) {
    actions.push('clean_up', 'kick', 'ban', role === PlayerRole.BUILDER ? 'player' : 'builder', 'owner');
  }
  return actions;
}
