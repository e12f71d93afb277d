// The players, the attributes and the room of a world as one client receives them.

import {
  PlayerEventKind,
  type Attribute,
  type AttributeSet,
  type AttributeUpdate,
  type Player,
  type PlayerUpdate,
  type Snapshot,
} from '../gen/jostle/v1/play_pb.js';
import type { RoomUpdate } from '../gen/jostle/v1/room_pb.js';

/** The world, a player (its client id) or an entity. */
export type AttributeTarget = { readonly kind: 'world' } | { readonly kind: 'player' | 'entity'; readonly id: number };

/**
 * A value of an attribute: a boolean, an integer (bigint), a number, a text or a vector. An integral number
 * stays a number.
 */
export type AttributeValue = boolean | bigint | number | string | { readonly x: number; readonly y: number; readonly z: number };

const NO_ATTRIBUTES: ReadonlyMap<string, Attribute> = new Map();

const keyOf = (target: AttributeTarget) => (target.kind === 'world' ? 'world' : `${target.kind} ${target.id}`);

function targetOf({ target }: AttributeSet): string {
  if (target.case === 'entity' || target.case === 'player') return keyOf({ kind: target.case, id: target.value });
  return keyOf({ kind: 'world' });
}

export class WorldData {
  /** Players by client id; for clients that subscribe to players. */
  readonly players = new Map<number, Player>();
  /** The room as this client may see it, for clients that subscribe to it; undefined: the world is no room. */
  room: RoomUpdate | undefined;
  private readonly attributes = new Map<string, Map<string, Attribute>>();

  /** Attributes of a target by key; for clients that subscribe to attributes. */
  attributesOf(target: AttributeTarget): ReadonlyMap<string, Attribute> {
    return this.attributes.get(keyOf(target)) ?? NO_ATTRIBUTES;
  }

  /** The value of an attribute; undefined: it does not exist, or the client may not read it. */
  value(target: AttributeTarget, key: string): AttributeValue | undefined {
    return this.attributesOf(target).get(key)?.value.value;
  }

  clear(): void {
    this.players.clear();
    this.attributes.clear();
    this.room = undefined;
  }

  /** Applies a snapshot; snapshots arrive in order. */
  apply(snapshot: Snapshot): void {
    for (const update of snapshot.players) this.applyPlayers(update);
    for (const update of snapshot.attributes) this.applyAttributes(update);
    if (snapshot.room) this.room = snapshot.room;
  }

  private applyPlayers(update: PlayerUpdate): void {
    if (update.complete) this.players.clear();
    for (const player of update.players) this.players.set(player.client, player);
    for (const { kind, player } of update.events) {
      if (!player) continue;
      const known = this.players.get(player.client);
      if (kind === PlayerEventKind.LEFT) this.players.delete(player.client);
      else this.players.set(player.client, { ...player, pingMs: known?.pingMs ?? 0 });
    }
    for (const { client, pingMs } of update.pings) {
      const player = this.players.get(client);
      if (player) player.pingMs = pingMs;
    }
  }

  private applyAttributes(update: AttributeUpdate): void {
    if (update.complete) this.attributes.clear();
    for (const set of update.sets) {
      const key = targetOf(set);
      const attributes = this.attributes.get(key) ?? new Map<string, Attribute>();
      for (const attribute of set.attributes) {
        if (attribute.value.case === undefined) attributes.delete(attribute.key);
        else attributes.set(attribute.key, attribute);
      }
      if (attributes.size > 0) this.attributes.set(key, attributes);
      else this.attributes.delete(key);
    }
    for (const id of update.entitiesEnded) this.attributes.delete(keyOf({ kind: 'entity', id }));
    for (const id of update.playersEnded) this.attributes.delete(keyOf({ kind: 'player', id }));
  }
}
