// The methods of AdminService that the monitor page uses, as JSON over HTTP: POST api/admin/{method}.

import { withToken } from '@jostle/client';

export interface RoomInfo {
  title: string;
  capacity: number;
  isPrivate: boolean;
  unlisted: boolean;
  players: number;
  spectators: number;
}
export interface WorldInfo {
  id: string;
  name: string;
  scene: string;
  bodies: number;
  awake: number;
  clients: number;
  stepMsMean: number;
  timeScale: number;
  paused: string;
  owner: string;
  room?: RoomInfo;
}
export interface ClientInfo {
  id: number;
  name: string;
  subject: string;
  world: string;
  worldName: string;
  address: string;
  spectator: boolean;
  connectedSeconds: number;
  kbitPerSecond: number;
  snapshotsSkipped: number;
  roundTripMs: number;
}
export interface Count {
  name: string;
  value: number;
}
export interface LogLine {
  number: string;
  time: string;
  level: string;
  text: string;
}
export interface ServerStatus {
  version: string;
  uptimeSeconds: number;
  draining: boolean;
  worlds: WorldInfo[];
  clients: ClientInfo[];
  sentBytes: Count[];
  inputs: Count[];
  refusals: Count[];
  log: LogLine[];
  bans: Ban[];
  reports: Report[];
}
export interface Report {
  number: string;
  world: string;
  worldName: string;
  tick: number;
  time: string;
  from: number;
  fromName: string;
  client: number;
  name: string;
  reason: string;
  messages: string[];
}
export interface RoomMember {
  client: number;
  role: string;
  member: string;
  muted: boolean;
  removed: boolean;
}
export interface Room {
  settings: { title: string; areas: { name: string; minRole: string }[] };
  owner: string;
  members: RoomMember[];
  bans: { member: string; reason: string; permanent: boolean }[];
  voteTarget: number;
  votes: number;
}
export interface Ban {
  subject: string;
  network: string;
  reason: string;
  by: string;
  expires: string;
}

/** The server rejected the call; `signIn`: a token of an administrator is required. */
export class CallError extends Error {
  constructor(
    message: string,
    readonly signIn: boolean,
  ) {
    super(message);
  }
}

export class AdminApi {
  token = '';

  async call<Response>(method: string, request: object = {}): Promise<Response> {
    const response = await fetch(`api/admin/${method}`, {
      method: 'POST',
      headers: withToken(this.token, { 'Content-Type': 'application/json' }),
      body: JSON.stringify(request),
    }).catch(() => {
      throw new CallError('the server does not respond', false);
    });
    const text = await response.text();
    if (response.ok) return JSON.parse(text) as Response;
    let message = text;
    try {
      message = (JSON.parse(text) as { message: string }).message;
    } catch {
      // not JSON: a proxy responded
    }
    throw new CallError(message || `HTTP status ${response.status}`, response.status === 401 || response.status === 403);
  }
}
