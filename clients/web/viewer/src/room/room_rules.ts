// Permissions of a client in its world: the table of a room, with the entries that the room replaces
// (docs/guides/operator/rooms.md). The server decides; the viewer disables the actions that it would refuse.

import { PlayerRole } from '@jostle/client/gen/play_pb';
import type { RoomUpdate } from '@jostle/client/gen/room_pb';

export const ROLES = ['spectator', 'player', 'builder', 'owner'] as const;
export type Role = (typeof ROLES)[number];
export const REACHES = ['none', 'own', 'unowned', 'any'] as const;
export type Reach = (typeof REACHES)[number];

/** Labels, and the reach of each role in a room that replaces nothing. */
export const ACTIONS = {
  spawn: ['Spawn bodies', 'none any any any'],
  drag: ['Drag', 'none unowned any any'],
  push: ['Push', 'none unowned any any'],
  explode: ['Explode', 'none any any any'],
  delete: ['Delete', 'none own unowned any'],
  joints: ['Joints and cuts', 'none unowned any any'],
  control: ['Drive', 'none any any any'],
  edit: ['Edit and freeze', 'none own unowned any'],
  clone: ['Clone', 'none unowned any any'],
  message: ['Chat', 'any any any any'],
  vote: ['Vote', 'none any any any'],
  clean_up: ['Delete all bodies of a player', 'none own own any'],
  mute: ['Mute', 'none none any any'],
  kick: ['Kick', 'none none none any'],
  ban: ['Ban', 'none none none any'],
  set_role: ['Give roles', 'none none none any'],
  protect: ['Protect areas', 'none none any any'],
  pause: ['Pause and step', 'none none any any'],
  speed: ['Slow motion', 'none none any any'],
  rewind: ['Rewind', 'none none none any'],
  reset: ['Reset', 'none none none any'],
  settings: ['Change settings', 'none none none any'],
} as const;
export type Action = keyof typeof ACTIONS;
export const ACTION_NAMES = Object.keys(ACTIONS) as Action[];

/** The owner of the target of an action. */
export type TargetOwner = 'self' | 'scene' | 'other';

const ALLOWED: Record<Reach, readonly TargetOwner[]> = { none: [], own: ['self'], unowned: ['self', 'scene'], any: ['self', 'scene', 'other'] };
const TARGETS: Record<TargetOwner, string> = { self: 'an entity of its own', scene: 'an entity of the scene', other: 'an entity of another client' };
const NEEDS_ROOM: readonly Action[] = ['pause', 'speed', 'rewind', 'reset', 'vote', 'mute', 'kick', 'ban', 'set_role', 'protect', 'clean_up', 'settings'];
/** Without a room, clients do these only with their own entities. */
const OWN_WITHOUT_ROOM: readonly Action[] = ['edit', 'delete'];

export function defaultReach(role: Role, action: Action): Reach {
  return ACTIONS[action][1].split(' ')[ROLES.indexOf(role)] as Reach;
}

/** Until the server lists the client, the viewer disables nothing. */
export function roleName(role: PlayerRole): Role {
  return role === PlayerRole.UNSPECIFIED ? 'player' : (ROLES[role - PlayerRole.SPECTATOR] ?? 'spectator');
}

export class RoomRules {
  readonly role: Role;

  constructor(
    /** Undefined: the world is no room. */
    readonly room: RoomUpdate | undefined,
    playerRole: PlayerRole,
  ) {
    this.role = roleName(playerRole);
  }

  /** Of the own role, in a room. */
  reach(action: Action): Reach {
    const replaced = this.room?.settings?.permissions[`${this.role}.${action}`];
    return REACHES.find((reach) => reach === replaced) ?? defaultReach(this.role, action);
  }

  /** The rule that refuses the action, in the words of the server; empty: it is allowed. */
  refusal(action: Action, owner?: TargetOwner): string {
    const { role } = this;
    if (!this.room) {
      if (NEEDS_ROOM.includes(action)) return 'The world is no room: only administrators of the server may do this.';
      if (OWN_WITHOUT_ROOM.includes(action) && owner !== undefined && owner !== 'self') return 'The world is no room: you can change only bodies that you own.';
      return role === 'spectator' && action !== 'message' ? 'Spectators only watch.' : '';
    }
    const reach = this.reach(action);
    if (reach === 'none') return `room.permissions: ${role}.${action} is none; the role ${role} may not ${action}`;
    if (owner === undefined || ALLOWED[reach].includes(owner)) return '';
    return `room.permissions: ${role}.${action} is ${reach}; the role ${role} may not ${action} ${TARGETS[owner]}`;
  }

  may(action: Action, owner?: TargetOwner): boolean {
    return this.refusal(action, owner) === '';
  }

  /** Whether the room, and not the default, decides about the action. */
  isReplaced(action: Action): boolean {
    return this.room !== undefined && this.reach(action) !== defaultReach(this.role, action);
  }
}
