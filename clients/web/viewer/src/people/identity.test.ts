import { expect, it } from 'vitest';
import { loadIdentity, PLAYER_COLORS, storeIdentity } from './identity';

function memoryStore(initial: Record<string, string> = {}) {
  const values = new Map(Object.entries(initial));
  return { getItem: (key: string) => values.get(key) ?? null, setItem: (key: string, value: string) => void values.set(key, value) };
}

it('remembers the name and the color', () => {
  const store = memoryStore();
  expect(loadIdentity(store, () => 0)).toEqual({ name: 'Guest 100', color: PLAYER_COLORS[0], chosen: false });
  storeIdentity(store, { name: 'Ann', color: 0x00ff10, chosen: true });
  expect(loadIdentity(store)).toEqual({ name: 'Ann', color: 0x00ff10, chosen: true });
});

it('ignores stored values that are not valid', () => {
  const store = memoryStore({ 'jostle-name': '\u202E\u0007', 'jostle-color': 'red; x' });
  expect(loadIdentity(store, () => 0.5)).toEqual({ name: 'Guest 550', color: PLAYER_COLORS[5], chosen: false });
});

it('works without storage', () => {
  const refuse = () => {
    throw new Error('no storage');
  };
  const store = { getItem: refuse, setItem: refuse };
  expect(loadIdentity(store, () => 0).name).toBe('Guest 100');
  storeIdentity(store, { name: 'Ann', color: 0, chosen: true });
});
