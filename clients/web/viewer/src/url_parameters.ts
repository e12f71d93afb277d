// The URL parameters of the viewer; README.md documents them. Values out of range are ignored.

import { IDEAL_NETWORK, isImpaired, type AreaOfInterest, type NetworkConditions } from '@jostle/client';

/** auto: by the duration of frames. */
export type Quality = 'auto' | 'high' | 'medium' | 'low';

export interface UrlParameters {
  readonly world: string; // id or name; empty: the server's first world
  readonly recording: string | undefined; // URL of a recording to play instead
  readonly quality: Quality;
  readonly predict: boolean;
  readonly areaOfInterest: AreaOfInterest | undefined;
  readonly networkConditions: NetworkConditions | undefined;
}

const QUALITIES: readonly Quality[] = ['auto', 'high', 'medium', 'low'];
const INTEREST_MIN = 1; // m
const INTEREST_MAX = 1e6;
const KBPS_MIN = 16; // kbit/s; servers reject less
const KBPS_MAX = 1e6;

export function parseUrlParameters(search: string): UrlParameters {
  const parameters = new URLSearchParams(search);
  return {
    world: parameters.get('world') ?? '',
    recording: parameters.get('recording') || undefined,
    quality: QUALITIES.find((quality) => quality === parameters.get('quality')) ?? 'auto',
    predict: parameters.get('predict') === '1',
    areaOfInterest: parseAreaOfInterest(parameters),
    networkConditions: parseNetworkConditions(parameters),
  };
}

function parseAreaOfInterest(parameters: URLSearchParams): AreaOfInterest | undefined {
  const number = (name: string, min: number, max: number) => {
    const value = Number(parameters.get(name) ?? '');
    return value >= min && value <= max ? value : 0;
  };
  const radius = number('interest', INTEREST_MIN, INTEREST_MAX);
  const maxKbps = Math.round(number('kbps', KBPS_MIN, KBPS_MAX));
  return radius > 0 || maxKbps > 0 ? { radius, maxKbps } : undefined;
}

const CONDITIONS: Record<string, [field: keyof NetworkConditions, min: number, max: number]> = {
  latency_ms: ['latencyMs', 0, 60_000],
  jitter_ms: ['jitterMs', 0, 60_000],
  jitter_tail_ms: ['jitterTailMs', 0, 60_000],
  stall_ms: ['stallMs', 0, 60_000],
  stall_interval_ms: ['stallIntervalMs', 0, 1e9],
  loss: ['loss', 0, 1],
  loss_burst: ['lossBurst', 1, 1000],
  retransmit_ms: ['retransmitMs', 0, 60_000],
  rate_kbps: ['rateKbps', 0, 1e7],
  seed: ['seed', 0, 2 ** 32 - 1],
};

/** undefined: no parameter impairs the network. */
function parseNetworkConditions(parameters: URLSearchParams): NetworkConditions | undefined {
  const conditions: { -readonly [K in keyof NetworkConditions]: NetworkConditions[K] } = { ...IDEAL_NETWORK };
  for (const [name, text] of parameters) {
    const [field, min, max] = CONDITIONS[name] ?? [];
    const value = Number(text);
    if (field && text !== '' && value >= min! && value <= max!) conditions[field] = value;
  }
  return isImpaired(conditions) ? conditions : undefined;
}

// The token of the user, from #token=... of the URL. It is removed from the URL immediately, so that
// neither the history nor a shared link contains it, and stored for the lifetime of the tab.

const KEY = 'jostle-token';

export interface UrlLocation {
  readonly hash: string;
  /** Replaces the hash without a history entry. */
  replaceHash(hash: string): void;
}

export function takeToken(url: UrlLocation, store: Pick<Storage, 'getItem' | 'setItem'>): string {
  const fields = new URLSearchParams(url.hash.replace(/^#/, ''));
  const token = fields.get('token');
  if (token === null) return store.getItem(KEY) ?? '';
  fields.delete('token');
  url.replaceHash(fields.toString());
  store.setItem(KEY, token);
  return token;
}
