import { expect, it } from 'vitest';
import { keyProblem, parseValue, valueText } from './attribute_values';

it('parses values of each type', () => {
  expect(parseValue('boolean', 'true')).toEqual({ case: 'boolean', value: true });
  expect(parseValue('integer', ' -9223372036854775808 ')).toEqual({ case: 'integer', value: -(2n ** 63n) });
  expect(parseValue('number', '1e-3')).toEqual({ case: 'number', value: 0.001 });
  expect(parseValue('text', ' a ')).toEqual({ case: 'text', value: ' a ' });
  expect(parseValue('vector', '1, -2.5  3')).toEqual({ case: 'vector', value: { x: 1, y: -2.5, z: 3 } });
});

it('names what is wrong', () => {
  expect(parseValue('integer', '1.5')).toBe('Enter a whole number.');
  expect(parseValue('integer', '9223372036854775808')).toBe('The number must fit in 64 bits.');
  expect(parseValue('number', '')).toBe('Enter a number.');
  expect(parseValue('number', 'Infinity')).toBe('Enter a number.');
  expect([parseValue('vector', '1, 2'), parseValue('vector', '1 2 3 4')]).toEqual(['Enter three numbers: x, y, z.', 'Enter three numbers: x, y, z.']);
});

it('checks keys', () => {
  const used = (key: string) => key === 'hp';
  expect(keyProblem('door.open_2', used)).toBe('');
  expect(keyProblem('hp', used)).toContain('exists');
  for (const key of ['', 'HP', 'a b', 'x'.repeat(33)]) expect(keyProblem(key, used)).toContain('1 to 32');
});

it('writes values as they are entered', () => {
  const vector = { $typeName: 'jostle.v1.Vec3', x: 1, y: -0.5, z: 0 } as const;
  expect(valueText({ value: { case: 'vector', value: vector } })).toBe('1, -0.5, 0');
  expect(valueText({ value: { case: 'boolean', value: false } })).toBe('false');
});
