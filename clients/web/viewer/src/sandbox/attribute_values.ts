// Typed values of attributes as texts that the user edits.

import type { Attribute } from '@jostle/client/gen/play_pb';

export const ATTRIBUTE_TYPES = { boolean: 'Boolean', integer: 'Integer', number: 'Number', text: 'Text', vector: 'Vector' } as const;
export type AttributeType = keyof typeof ATTRIBUTE_TYPES;

export type AttributeValueCase =
  | { readonly case: 'boolean'; readonly value: boolean }
  | { readonly case: 'integer'; readonly value: bigint }
  | { readonly case: 'number'; readonly value: number }
  | { readonly case: 'text'; readonly value: string }
  | { readonly case: 'vector'; readonly value: { readonly x: number; readonly y: number; readonly z: number } };

const INTEGER_MAX = 2n ** 63n - 1n;
const KEY = /^[a-z0-9_.]{1,32}$/;

export function valueText({ value }: Pick<Attribute, 'value'>): string {
  if (value.case === 'vector') return [value.value.x, value.value.y, value.value.z].join(', ');
  return value.case === undefined ? '' : String(value.value);
}

/** The problem of a key; empty: it is valid. */
export function keyProblem(key: string, used: (key: string) => boolean): string {
  if (!KEY.test(key)) return 'A key has 1 to 32 of the characters a-z, 0-9, _ and dot.';
  return used(key) ? `The attribute ${key} exists; change it above.` : '';
}

function parseNumber(text: string): number | undefined {
  const value = text.trim() === '' ? NaN : Number(text);
  return Number.isFinite(value) ? value : undefined;
}

/** The value of a text, or the problem as a string. The server checks the length of texts. */
export function parseValue(type: AttributeType, text: string): AttributeValueCase | string {
  switch (type) {
    case 'boolean':
      return { case: 'boolean', value: text === 'true' };
    case 'integer': {
      if (!/^\s*[+-]?\d+\s*$/.test(text)) return 'Enter a whole number.';
      const value = BigInt(text.trim().replace(/^\+/, ''));
      return value > INTEGER_MAX || value < -INTEGER_MAX - 1n ? 'The number must fit in 64 bits.' : { case: 'integer', value };
    }
    case 'number': {
      const value = parseNumber(text);
      return value === undefined ? 'Enter a number.' : { case: 'number', value };
    }
    case 'text':
      return { case: 'text', value: text };
    case 'vector': {
      const [x, y, z, ...more] = text.split(/\s*[,;\s]\s*/).filter((part) => part !== '').map(parseNumber);
      if (x === undefined || y === undefined || z === undefined || more.length > 0) return 'Enter three numbers: x, y, z.';
      return { case: 'vector', value: { x, y, z } };
    }
  }
}
