// Numbers in the output of the range coder (proto/WIRE.md, "Numbers").

import type { RangeDecoder } from './range_decoder.js';

export const MAGNITUDE = 5; // models of a number: nonzero, negative, above 1, above 3, odd
export const FIRST_WIDTH = 2; // bits below the leading one of a number above 3
export const LAST_WIDTH = 14;
export const TAIL = 2 * (LAST_WIDTH - FIRST_WIDTH) + 1;
export const COUNT = 40;

/** The width of value + 1 in unary, then its bits below the leading one. */
export function readCount(input: RangeDecoder, models: number): number {
  let bitCount = 0;
  while (bitCount < COUNT && input.bit(models + bitCount)) bitCount++;
  return 2 ** bitCount + input.raw(bitCount) - 1;
}

function readLarge(input: RangeDecoder, tail: number): number {
  const steps = LAST_WIDTH - FIRST_WIDTH;
  let k = 0;
  while (k < steps && input.bit(tail + k)) k++;
  let bitCount = FIRST_WIDTH + k;
  if (k === steps) bitCount += input.raw(5);
  const second = input.bit(tail + steps + k) ? 3 : 2;
  return second * 2 ** (bitCount - 1) + input.raw(bitCount - 1);
}

export function readNumber(input: RangeDecoder, models: number, tail: number): number {
  if (!input.bit(models)) return 0;
  const negative = input.bit(models + 1);
  let size = 1;
  if (input.bit(models + 2)) {
    if (input.bit(models + 3)) size = readLarge(input, tail);
    else size = input.bit(models + 4) ? 3 : 2;
  }
  return negative ? -size : size;
}
