import { IDEAL_NETWORK } from '@jostle/client';
import { describe, expect, it } from 'vitest';
import { parseUrlParameters, takeToken } from './url_parameters';

const areaOfInterest = (search: string) => parseUrlParameters(search).areaOfInterest;
const networkConditions = (search: string) => parseUrlParameters(search).networkConditions;

describe('area of interest', () => {
  it('is the whole world by default', () => {
    expect(areaOfInterest('?world=yard')).toBeUndefined();
    expect(areaOfInterest('?interest=150')).toEqual({ radius: 150, maxKbps: 0 });
    expect(areaOfInterest('?kbps=500&interest=x')).toEqual({ radius: 0, maxKbps: 500 });
  });

  it('ignores values that the server rejects', () => {
    for (const search of ['?interest=-3', '?interest=0.5', '?kbps=3', '?kbps=NaN', '?interest=1e9'])
      expect(areaOfInterest(search), search).toBeUndefined();
  });
});

it('parses the network conditions', () => {
  const conditions = networkConditions('?world=yard&latency_ms=80&jitter_ms=20.5&stall_ms=250&stall_interval_ms=3000&seed=9')!;
  expect(conditions).toEqual({ ...IDEAL_NETWORK, latencyMs: 80, jitterMs: 20.5, stallMs: 250, stallIntervalMs: 3000, seed: 9 });
  expect(networkConditions('?world=yard')).toBeUndefined();
  expect(networkConditions('?latency_ms=-1&loss=2&jitter_ms=much&jitter_tail_ms=&loss_burst=0')).toBeUndefined();
});

it('selects the world, the recording, the quality and prediction', () => {
  expect(parseUrlParameters('')).toMatchObject({ world: '', recording: undefined, quality: 'auto', predict: false });
  expect(parseUrlParameters('?world=sandbox&recording=a.rec&quality=low&predict=1')).toMatchObject({
    world: 'sandbox',
    recording: 'a.rec',
    quality: 'low',
    predict: true,
  });
  expect(parseUrlParameters('?quality=best&predict=yes')).toMatchObject({ quality: 'auto', predict: false });
});

function tab(hash: string, stored: Record<string, string> = {}) {
  const url = { hash, replaceHash: (now: string) => void (url.hash = now) };
  const store = { getItem: (key: string) => stored[key] ?? null, setItem: (key: string, value: string) => void (stored[key] = value) };
  return { url, store };
}

it('removes the token from the URL and stores it for the tab', () => {
  const { url, store } = tab('#token=a.b.c&x=1');
  expect(takeToken(url, store)).toBe('a.b.c');
  expect(url.hash).toBe('x=1');
  expect(takeToken(url, store)).toBe('a.b.c');
  expect(takeToken(tab('').url, tab('').store)).toBe('');
});
