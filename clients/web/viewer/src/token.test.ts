import { expect, it } from 'vitest';
import { takeToken } from './token';

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
