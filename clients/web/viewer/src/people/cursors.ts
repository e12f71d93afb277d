// Cursors and grabs of the other players. Each client samples its cursor at most 10 times per second
// while it moves, and sends the samples in up to 3 messages per second, because the server's default
// limit is 5 messages per second. Receivers play them back 0.45 s later, so that cursors move evenly.
// A client that is alone sends nothing.

import * as THREE from 'three';
import type { Grab } from '../interaction/tools';
import type { Solids } from '../scene/solids';
import type { MessageBudget } from './message_budget';

export const CURSOR_TOPIC = 'cursor';

const SAMPLE_MS = 100;
const SEND_MS = 333;
const SEND_MS_PER_PLAYER = 30; // bounds what a full room receives
const SAMPLES_MAX = 8; // of a message
const AGE_MAX_MS = 3000; // of a sample in a message
const PLAYBACK_DELAY_MS = 450;
const SHOWN_MS = 20_000; // after the last sample
const MOVED = 0.01; // m
const COORDINATE_MAX = 1e6; // m
const CHAT_RESERVE = 4; // messages
const RADIUS = 0.05; // m at 10 m from the camera
const GRAB_RADIUS = 0.018;
const UP = new THREE.Vector3(0, 1, 0);

export interface Point {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}
/** A body and the grabbed point in its frame; entity 0: a rope or cloth. */
export interface RemoteGrab {
  readonly entity: number;
  readonly point: Point;
}
export interface CursorSample extends Point {
  readonly atMs: number;
}
export interface CursorMessage {
  /** Rising times; empty: the cursor left the view. */
  readonly samples: readonly CursorSample[];
  readonly grab: RemoteGrab | undefined;
}

const rounded = (value: number) => Math.round(value * 1000) / 1000;
const triple = ({ x, y, z }: Point): [number, number, number] => [rounded(x), rounded(y), rounded(z)];
const isCoordinate = (value: unknown) => typeof value === 'number' && Math.abs(value) <= COORDINATE_MAX;
const isId = (value: unknown) => Number.isInteger(value) && (value as number) >= 0 && (value as number) < 2 ** 32;

/** JSON: {"p": [[age in ms, x, y, z], ...], "g": [entity, x, y, z]} */
export function encodeCursor({ samples, grab }: CursorMessage, nowMs: number): Uint8Array<ArrayBuffer> {
  const p = samples.map((sample) => [Math.round(nowMs - sample.atMs), ...triple(sample)]);
  return new TextEncoder().encode(JSON.stringify(grab ? { p, g: [grab.entity, ...triple(grab.point)] } : { p }));
}

/** undefined: not a valid message. */
export function decodeCursor(data: Uint8Array, nowMs: number): CursorMessage | undefined {
  let message: { p?: unknown; g?: unknown } | null;
  try {
    message = JSON.parse(new TextDecoder().decode(data)) as typeof message;
  } catch {
    return undefined;
  }
  if (typeof message !== 'object' || message === null || !Array.isArray(message.p) || message.p.length > SAMPLES_MAX) return undefined;
  const samples: CursorSample[] = [];
  for (const one of message.p as unknown[]) {
    if (!Array.isArray(one) || one.length !== 4 || !one.slice(1).every(isCoordinate)) return undefined;
    const [age, x, y, z] = one as [number, number, number, number];
    if (typeof age !== 'number' || !(age >= 0 && age <= AGE_MAX_MS)) return undefined;
    samples.push({ atMs: nowMs - age, x, y, z });
  }
  samples.sort((a, b) => a.atMs - b.atMs);
  const g = message.g as [number, number, number, number] | undefined;
  if (g === undefined) return { samples, grab: undefined };
  if (!Array.isArray(g) || g.length !== 4 || !isId(g[0]) || !g.slice(1).every(isCoordinate)) return undefined;
  return { samples, grab: { entity: g[0], point: { x: g[1], y: g[2], z: g[3] } } };
}

/** Samples the own cursor and sends it. */
export class CursorSender {
  private samples: CursorSample[] = [];
  private last: Point | undefined; // sampled
  private grabbed: number | undefined; // entity of the grab that was sent
  private sampledMs = -Infinity;
  private sentMs = -Infinity;
  private pausedUntilMs = -Infinity;
  private shown = false; // others see the cursor
  sent = 0;

  constructor(
    private readonly budget: MessageBudget,
    private readonly send: (data: Uint8Array<ArrayBuffer>) => void,
  ) {}

  /** Call once per rendered frame. `others`: number of other players. */
  update(nowMs: number, others: number, point: Point | undefined, grab: Grab | undefined): void {
    if (others === 0 || nowMs < this.pausedUntilMs) return this.reset();
    if (point) this.sample(nowMs, point, grab);
    const left = point === undefined && this.shown;
    if ((this.samples.length === 0 && !left) || nowMs - this.sentMs < Math.max(SEND_MS, SEND_MS_PER_PLAYER * others)) return;
    if (!this.budget.take(nowMs, CHAT_RESERVE)) return;
    const samples = left ? [] : this.samples.filter(({ atMs }) => nowMs - atMs <= AGE_MAX_MS).slice(-SAMPLES_MAX);
    const { entity = 0, point: at = undefined } = grab ?? {};
    this.send(encodeCursor({ samples, grab: at && !left ? { entity, point: at } : undefined }, nowMs));
    this.sent++;
    this.sentMs = nowMs;
    this.samples = [];
    this.shown = !left;
    if (left) this.last = undefined;
  }

  private sample(nowMs: number, point: Point, grab: Grab | undefined): void {
    const entity = grab?.entity;
    const moved = !this.last || Math.hypot(point.x - this.last.x, point.y - this.last.y, point.z - this.last.z) > MOVED;
    if (nowMs - this.sampledMs < SAMPLE_MS || (!moved && entity === this.grabbed)) return;
    this.last = { x: point.x, y: point.y, z: point.z };
    this.grabbed = entity;
    this.sampledMs = nowMs;
    this.samples.push({ atMs: nowMs, ...this.last });
  }

  private reset(): void {
    this.samples = [];
    this.last = undefined;
    this.shown = false;
  }

  /** The server refuses messages of this client for a while. */
  pause(untilMs: number): void {
    this.pausedUntilMs = untilMs;
  }

  /** Others join: they receive the cursor even if it rests. */
  resend(): void {
    this.last = undefined;
  }
}

/** The cursor of another player. */
class RemoteCursor {
  private samples: CursorSample[] = [];
  grab: RemoteGrab | undefined;

  add({ samples, grab }: CursorMessage): void {
    if (samples.length === 0) this.samples = [];
    // Times depend on the latency of each message; older samples never follow newer ones.
    const lastMs = this.samples.at(-1)?.atMs ?? -Infinity;
    this.samples.push(...samples.filter(({ atMs }) => atMs > lastMs));
    this.samples = this.samples.slice(-2 * SAMPLES_MAX);
    this.grab = grab;
  }

  position(nowMs: number): Point | undefined {
    const atMs = nowMs - PLAYBACK_DELAY_MS;
    const { samples } = this;
    const last = samples.at(-1);
    if (!last || nowMs - last.atMs > SHOWN_MS) return undefined;
    const after = samples.findIndex((sample) => sample.atMs > atMs);
    if (after < 0) return last;
    const b = samples[after]!;
    const a = samples[after - 1] ?? b;
    const t = b.atMs > a.atMs ? Math.min(1, Math.max(0, (atMs - a.atMs) / (b.atMs - a.atMs))) : 1;
    return { x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y), z: a.z + t * (b.z - a.z) };
  }
}

export interface ShownCursor {
  readonly client: number;
  readonly position: Point;
  readonly grab: RemoteGrab | undefined;
}

const from = new THREE.Vector3();
const to = new THREE.Vector3();
const turn = new THREE.Quaternion();
const size = new THREE.Vector3();
const shade = new THREE.Color();

export class RemoteCursors {
  private readonly cursors = new Map<number, RemoteCursor>();

  receive(client: number, data: Uint8Array, nowMs: number): void {
    const message = decodeCursor(data, nowMs);
    if (!message) return;
    const cursor = this.cursors.get(client) ?? new RemoteCursor();
    this.cursors.set(client, cursor);
    cursor.add(message);
  }
  remove(client: number): void {
    this.cursors.delete(client);
  }
  clear(): void {
    this.cursors.clear();
  }

  shown(nowMs: number): ShownCursor[] {
    const shown: ShownCursor[] = [];
    for (const [client, cursor] of this.cursors) {
      const position = cursor.position(nowMs);
      if (position) shown.push({ client, position, grab: cursor.grab });
    }
    return shown;
  }
}

/** A ball at the cursor, and a line from the grabbed point to it. `distance`: of the camera, in m. */
export function drawCursor(solids: Solids, cursor: ShownCursor, color: number, poseOf: (entity: number) => ArrayLike<number> | undefined, distance: number): void {
  const scale = Math.max(0.2, distance / 10);
  to.set(cursor.position.x, cursor.position.y, cursor.position.z);
  solids.add('sphere', to, turn.identity(), size.setScalar(RADIUS * scale), shade.set(color));
  if (!cursor.grab) return;
  const { entity, point } = cursor.grab;
  const pose = poseOf(entity);
  if (entity !== 0 && !pose) return;
  from.set(point.x, point.y, point.z);
  if (pose) {
    from.applyQuaternion(turn.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!));
    from.set(from.x + pose[0]!, from.y + pose[1]!, from.z + pose[2]!);
  }
  const radius = GRAB_RADIUS * scale;
  solids.add('sphere', from, turn.identity(), size.setScalar(2.2 * radius), shade);
  to.sub(from);
  const length = to.length();
  if (length < 1e-3) return;
  turn.setFromUnitVectors(UP, to.divideScalar(length));
  solids.add('cylinder', from.addScaledVector(to, length / 2), turn, size.set(radius, length / 2, radius), shade);
}
