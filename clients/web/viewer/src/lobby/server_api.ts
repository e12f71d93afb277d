// The JSON API of the server for worlds: /api/worlds.

import { withToken } from '@jostle/client';

export interface RoomInfo {
  readonly title: string;
  readonly description: string;
  readonly tags: readonly string[];
  readonly capacity: number; // 0: as many as the server allows
  readonly isPrivate: boolean; // requires a join code
  readonly players: number;
  readonly spectators: number;
}
export interface WorldInfo {
  readonly id: string;
  readonly name: string;
  readonly scene: string;
  readonly bodies: number;
  readonly awake: number;
  readonly clients: number;
  readonly hz: number;
  readonly tick: number;
  readonly paused: string; // why; empty: it runs
  readonly oldestRestorableTick: number; // 0: the world is not persisted
  readonly room?: RoomInfo | null;
}
export interface SceneInfo {
  readonly name: string;
  readonly description: string;
}
export interface RoomTemplate {
  readonly name: string;
  readonly scene: string;
  readonly room?: { readonly title?: string; readonly description?: string } | null;
}
export interface Listing {
  readonly worlds: readonly WorldInfo[];
  readonly scenes: readonly SceneInfo[];
  readonly templates?: readonly RoomTemplate[];
}
export interface ExportedScene {
  readonly tick?: number;
  readonly scene?: object;
  readonly omitted?: readonly string[];
}

/** The server refused a request; the message is for the user. */
export class ApiError extends Error {
  constructor(
    message: string,
    readonly status: number,
  ) {
    super(message);
  }
}

export class ServerApi {
  constructor(
    private readonly token: string,
    private readonly send: typeof fetch = (path, init) => fetch(path, init),
  ) {}

  list(): Promise<Listing> {
    return this.call('api/worlds') as Promise<Listing>;
  }

  /** `source`: one of the sources of CreateWorldRequest. */
  async create(name: string, source: object): Promise<WorldInfo> {
    const init = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ name, ...source }) };
    return ((await this.call('api/worlds', init)) as { world: WorldInfo }).world;
  }

  async delete(world: string): Promise<void> {
    await this.call(`api/worlds/${encodeURIComponent(world)}`, { method: 'DELETE' });
  }

  /** The current state of a world as a scene. */
  scene(world: string): Promise<ExportedScene> {
    return this.call(`api/worlds/${encodeURIComponent(world)}/scene`) as Promise<ExportedScene>;
  }

  private async call(path: string, init?: RequestInit): Promise<unknown> {
    const headers = withToken(this.token, init?.headers as Record<string, string> | undefined);
    const response = await this.send(path, { ...init, headers }).catch(() => {
      throw new ApiError('the server does not respond', 0);
    });
    const text = await response.text();
    let payload: { message?: string } = {};
    try {
      payload = JSON.parse(text) as typeof payload;
    } catch {
      payload = { message: text };
    }
    if (!response.ok) throw new ApiError(payload.message || `the server responded with HTTP status ${response.status}`, response.status);
    return payload;
  }
}
