// The actions of a user on another player: local ones, and those of moderation that the rules of the room allow.
// An action that only a replaced permission refuses is listed with its rule.

import { PlayerRole } from '@jostle/client/gen/play_pb';
import type { Action, RoomRules } from '../room/room_rules';

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
  ban: 'Ban …',
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
  readonly rules: RoomRules;
  readonly ownRole: PlayerRole;
  readonly role: PlayerRole;
  readonly hidden: boolean;
}
export interface OfferedAction {
  readonly action: PlayerAction;
  /** The rule that refuses it; empty: it is allowed. */
  readonly refusal: string;
}

/** Which permission an action needs; the others are local. */
const NEEDED: Partial<Record<PlayerAction, Action>> = { vote: 'vote', mute: 'mute', unmute: 'mute', clean_up: 'clean_up', kick: 'kick', ban: 'ban', player: 'set_role', builder: 'set_role', owner: 'set_role' };

export function actionsFor({ rules, ownRole, role, hidden }: ActionContext): OfferedAction[] {
  const local: PlayerAction[] = ['follow', hidden ? 'show' : 'hide', 'report'];
  const offered: OfferedAction[] = local.map((action) => ({ action, refusal: '' }));
  if (!rules.room) return offered;
  const isHigher = ownRole > role;
  const others: PlayerAction[] = ['vote'];
  // A client acts only on clients with a lower role, and gives no role above its own.
  if (isHigher) others.push('mute', 'unmute', 'clean_up', 'kick', 'ban');
  if (isHigher && role === PlayerRole.BUILDER) others.push('player');
  if (isHigher && role < PlayerRole.BUILDER && ownRole > PlayerRole.BUILDER) others.push('builder');
  if (isHigher && ownRole === PlayerRole.OWNER) others.push('owner');
  for (const action of others) {
    const needed = NEEDED[action]!;
    const refusal = rules.refusal(needed, needed === 'clean_up' ? 'other' : undefined);
    if (refusal === '' || rules.isReplaced(needed)) offered.push({ action, refusal });
  }
  return offered;
}
