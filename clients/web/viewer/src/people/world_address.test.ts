import { expect, it } from 'vitest';
import { isLoopback, JoinCodes, linkToWorld, searchWithWorld, takeJoinCode } from './world_address';

it('names the world in the address and keeps the other parameters', () => {
  expect(searchWithWorld('?quality=low&world=a', 'my world & more')).toBe('?quality=low&world=my+world+%26+more');
  expect(new URLSearchParams(searchWithWorld('', 'ö#?')).get('world')).toBe('ö#?');
});

it('links to a world without the settings of the user', () => {
  const page = { origin: 'http://host:8080', pathname: '/' };
  expect(linkToWorld(page, 'a b')).toBe('http://host:8080/?world=a+b');
  expect(linkToWorld(page, 'a', 'se&same')).toBe('http://host:8080/?world=a#code=se%26same');
});

it('takes the join code out of the fragment', () => {
  const hashes: string[] = [];
  expect(takeJoinCode({ hash: '#code=se%26same&x=1', replaceHash: (hash) => hashes.push(hash) })).toBe('se&same');
  expect(takeJoinCode({ hash: '#x=1', replaceHash: (hash) => hashes.push(hash) })).toBe('');
  expect(hashes).toEqual(['x=1']);
});

it('recognizes addresses of this machine', () => {
  expect(['localhost', '127.0.0.1', '[::1]', 'a.localhost'].every(isLoopback)).toBe(true);
  expect(['192.168.0.2', 'example.org', 'localhost.example.org'].some(isLoopback)).toBe(false);
});

it('remembers join codes by world', () => {
  const values = new Map<string, string>();
  const codes = new JoinCodes({ getItem: (key) => values.get(key) ?? null, setItem: (key, value) => void values.set(key, value) });
  codes.set('a', 'x');
  expect([codes.get('a'), codes.get('b')]).toEqual(['x', '']);
});
