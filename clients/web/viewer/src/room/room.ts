// The room of the world: what its rules allow to this client, and the panel with its settings. main.ts calls
// onDataChanged() when players or the room changed, and update() once per rendered frame.

import type { Connection, Input } from '@jostle/client';
import { PlayerRole, type InputResult } from '@jostle/client/gen/play_pb';
import type { Vec3 } from '@jostle/client/gen/common_pb';
import * as THREE from 'three';
import { VertexBuffer } from '../scene/vertex_buffer';
import type { Panels } from '../ui/panels';
import type { RoomPanel } from './room_panel';
import { RoomRules, type TargetOwner } from './room_rules';

export type RoomCommand = NonNullable<Extract<NonNullable<Input['kind']>, { case: 'room' }>['value']['kind']>;

const AREA_COLOR = new THREE.Color(0xff9f5e);

export interface RoomOptions {
  readonly scene: THREE.Scene;
  readonly panels: Panels;
  readonly connection: Connection;
  /** Name of a client for the user. */
  nameOf(client: number): string;
  /** The box of the selected body; undefined: none is selected. */
  selectedBox(): THREE.Box3 | undefined;
  /** Where the camera looks. */
  cameraTarget(): THREE.Vector3;
}

export class Room {
  private current = new RoomRules(undefined, PlayerRole.UNSPECIFIED);
  private readonly listeners: ((rules: RoomRules) => void)[] = [];
  private readonly lines = VertexBuffer.lines(0.9);
  private panel: RoomPanel | undefined;
  private drawn = '';

  constructor(private readonly options: RoomOptions) {
    options.scene.add(this.lines.object);
  }

  get rules(): RoomRules {
    return this.current;
  }

  /** Called with the rules now and after each change. */
  onChange(listener: (rules: RoomRules) => void): void {
    this.listeners.push(listener);
    listener(this.current);
  }

  /** The owner of an entity as the rules name it. */
  ownerOf(entity: number): TargetOwner {
    const { entities, welcome } = this.options.connection;
    const owner = entities.get(entity)?.owner ?? 0;
    return owner === 0 ? 'scene' : owner === welcome?.clientId ? 'self' : 'other';
  }

  /** Sends a command; returns the sequence of the input. */
  send(kind: RoomCommand): number {
    return this.options.connection.send({ kind: { case: 'room', value: { kind } } });
  }

  onDataChanged(): void {
    const { data, welcome } = this.options.connection;
    const role = data.players.get(welcome?.clientId ?? 0)?.role ?? PlayerRole.UNSPECIFIED;
    const rules = new RoomRules(data.room, role);
    const changed = rules.room !== this.current.room || rules.role !== this.current.role;
    this.current = rules;
    if (changed) for (const listener of this.listeners) listener(rules);
    this.panel?.show();
  }

  /** Returns whether the panel shows the refusal. */
  rejected(result: InputResult): boolean {
    return this.panel?.rejected(result) ?? false;
  }

  register(): void {
    this.options.panels.register({
      id: 'room',
      title: 'Room',
      hint: 'Settings, permissions, protected areas and bans of this room',
      key: 'r',
      icon: 'room',
      side: 'left',
      compact: true,
      load: async (content) => {
        const { RoomPanel } = await import('./room_panel');
        const { connection, nameOf, selectedBox, cameraTarget } = this.options;
        const clients = () => [...connection.data.players.keys()].filter((client) => client !== connection.welcome?.clientId);
        this.panel = new RoomPanel(content, { rules: () => this.current, send: (kind) => this.send(kind), nameOf, clients, selectedBox, cameraTarget });
        this.panel.show();
        return { opened: () => this.panel?.show() };
      },
    });
  }

  /** Draws the protected areas while the panel is open. */
  update(): void {
    const areas = (this.options.panels.isOpen('room') && this.current.room?.settings?.areas) || [];
    const key = JSON.stringify(areas.map(({ min, max }) => [min, max]));
    if (key === this.drawn) return;
    this.drawn = key;
    this.lines.begin();
    for (const { min, max } of areas) if (min && max) drawBox(this.lines, min, max);
    this.lines.end();
  }

  /** Number of vertices of the drawn areas. */
  get areaVertexCount(): number {
    return this.lines.count;
  }
}

function drawBox(lines: VertexBuffer, min: Vec3, max: Vec3): void {
  const corner = (k: number) => [k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z] as const;
  for (let k = 0; k < 8; k++)
    for (const bit of [1, 2, 4])
      if (!(k & bit)) for (const end of [k, k | bit]) lines.vertex(...corner(end), AREA_COLOR);
}
