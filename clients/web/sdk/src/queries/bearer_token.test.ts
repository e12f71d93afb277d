import { expect, it } from 'vitest';
import { withToken } from './bearer_token.js';

it('adds the token as a header, and no header without a token', () => {
  expect(withToken('a.b.c', { Accept: 'x' })).toEqual({ Accept: 'x', Authorization: 'Bearer a.b.c' });
  expect(withToken('')).toEqual({});
});
