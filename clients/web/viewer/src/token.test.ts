import { expect, it } from 'vitest';
import { takeToken } from './token';

function tab(hash: string, kept: Record<string, string> = {}) {
  const place = { hash, replaceHash: (now: string) => void (place.hash = now) };
  const store = { getItem: (key: string) => kept[key] ?? null, setItem: (key: string, value: string) => void (kept[key] = value) };
  return { place, store };
}

it('takes the token out of the address and keeps it for the tab', () => {
  const { place, store } = tab('#token=a.b.c&x=1');
  expect(takeToken(place, store)).toBe('a.b.c');
  expect(place.hash).toBe('x=1');
  expect(takeToken(place, store)).toBe('a.b.c');
  expect(takeToken(tab('').place, tab('').store)).toBe('');
});
