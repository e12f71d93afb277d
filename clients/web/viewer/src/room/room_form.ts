// The settings of a room as fields of a form, and back.

import type { RoomSettings } from '@jostle/client/gen/room_pb';
import { ACTION_NAMES, defaultReach, REACHES, ROLES, type Action, type Reach, type Role } from './room_rules';

/** The settings that a form changes. */
export interface RoomFields {
  title: string;
  description: string;
  /** Separated by spaces or commas. */
  tags: string;
  capacity: number;
  isPrivate: boolean;
  joinCode: string;
  unlisted: boolean;
  closeWhenEmpty: boolean;
  timelineSeconds: number;
  initialRole: string;
  /** By "role.action"; entries like the default are omitted. */
  permissions: Record<string, string>;
  /** By "role.quota"; likewise. */
  quotas: Record<string, number>;
}

/** Labels, and the default of each role; 0: unlimited. */
export const QUOTAS = {
  bodies: ['Bodies', 0, 30, 0, 0],
  joints: ['Joints', 0, 30, 0, 0],
  energy_per_second: ['Energy, J/s', 0, 1e5, 1e6, 0],
  explosions_per_minute: ['Explosions per minute', 0, 12, 60, 0],
} as const;
export type Quota = keyof typeof QUOTAS;

export function defaultQuota(role: Role, quota: Quota): number {
  return QUOTAS[quota][(ROLES.indexOf(role) + 1) as 1 | 2 | 3 | 4];
}

export function fieldsOf(settings: RoomSettings | undefined): RoomFields {
  return {
    title: settings?.title ?? '',
    description: settings?.description ?? '',
    tags: (settings?.tags ?? []).join(' '),
    capacity: settings?.capacity ?? 0,
    isPrivate: (settings?.joinCode ?? '') !== '',
    joinCode: settings?.joinCode ?? '',
    unlisted: settings?.unlisted ?? false,
    closeWhenEmpty: settings?.closeWhenEmpty ?? false,
    timelineSeconds: settings?.timelineSeconds ?? 0,
    initialRole: settings?.initialRole || 'player',
    permissions: { ...settings?.permissions },
    quotas: { ...settings?.quotas },
  };
}

export function reachIn(permissions: Readonly<Record<string, string>>, role: Role, action: Action): Reach {
  return REACHES.find((reach) => reach === permissions[`${role}.${action}`]) ?? defaultReach(role, action);
}

export function setReach(permissions: Record<string, string>, role: Role, action: Action, reach: Reach): void {
  if (reach === defaultReach(role, action)) delete permissions[`${role}.${action}`];
  else permissions[`${role}.${action}`] = reach;
}

export function setQuota(quotas: Record<string, number>, role: Role, quota: Quota, value: number): void {
  if (value === defaultQuota(role, quota)) delete quotas[`${role}.${quota}`];
  else quotas[`${role}.${quota}`] = value;
}

/** The settings of the form, which replace all others. `areas`: the current ones. */
export function settingsOf(fields: RoomFields, areas: RoomSettings['areas']) {
  const { title, description, tags, capacity, isPrivate, joinCode, unlisted, closeWhenEmpty, timelineSeconds, initialRole, permissions, quotas } = fields;
  return {
    title: title.trim(),
    description: description.trim(),
    tags: tags.split(/[\s,]+/).filter((tag) => tag !== ''),
    capacity,
    joinCode: isPrivate ? joinCode : '',
    unlisted,
    closeWhenEmpty,
    timelineSeconds,
    initialRole,
    permissions,
    quotas,
    areas,
  };
}

/** The name of the field that a message of the server concerns; undefined: none of the form. */
export function fieldOfProblem(message: string): string | undefined {
  const name = /^room\.([a-z_]+)/.exec(message)?.[1];
  return name && { join_code: 'joinCode', initial_role: 'initialRole', timeline_seconds: 'timelineSeconds' }[name] || name;
}

/** How many permissions of a role differ from the default. */
export function replacedCount(permissions: Readonly<Record<string, string>>, role: Role): number {
  return ACTION_NAMES.filter((action) => reachIn(permissions, role, action) !== defaultReach(role, action)).length;
}
