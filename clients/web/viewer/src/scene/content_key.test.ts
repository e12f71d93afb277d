import { expect, it } from 'vitest';
import { contentKey } from './content_key';

it('is equal only for equal numbers', () => {
  const key = contentKey('hull', [1, 2, 3]);
  expect(contentKey('hull', [1, 2, 3])).toBe(key);
  const others = [
    contentKey('mesh', [1, 2, 3]),
    contentKey('hull', [1, 2, 3 + 1e-15]),
    contentKey('hull', [2, 1, 3]),
    contentKey('hull', [1, 2], [3]),
    contentKey('hull', [1, 2, 3, 0]),
  ];
  expect(new Set([key, ...others]).size).toBe(6);
});

it('differs for ten thousand hulls that differ in one number', () => {
  const keys = new Set(Array.from({ length: 10_000 }, (_, i) => contentKey('hull', [0, 0, i / 7, 1])));
  expect(keys.size).toBe(10_000);
});
