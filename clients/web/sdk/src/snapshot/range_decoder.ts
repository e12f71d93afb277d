// The range decoder of codec 2 (proto/WIRE.md): bits with adaptive models. 32-bit values are unsigned
// by `>>> 0`. Reads past the end return zeros and are counted.

export const UPDATES_MAX = 100;
/** Trailing zero bytes that an encoder omits, at most. */
const TAIL = 4;
const BOTTOM = 2 ** 24;
const RAW_BITS_MAX = 16; // raw bits per division of the range

const RATES = Uint16Array.from({ length: UPDATES_MAX + 1 }, (_, n) => Math.floor(655360 / (10 * n + 16)));

/** Probability of a one for each model, of 65536, and its number of updates. */
export interface Models {
  readonly one: Uint16Array;
  readonly updates: Uint8Array;
}

export class RangeDecoder {
  private at = 0;
  private range = 0xffffffff;
  private code = 0;

  constructor(
    private readonly bytes: Uint8Array,
    private readonly models: Models,
  ) {
    for (let k = 0; k < 4; k++) this.code = ((this.code << 8) | this.next()) >>> 0;
  }

  private next(): number {
    const at = this.at++;
    return at < this.bytes.length ? this.bytes[at]! : 0;
  }

  private shift(): void {
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.next()) >>> 0;
  }

  bit(model: number): boolean {
    const { one, updates } = this.models;
    const p = one[model]!;
    const n = updates[model]!;
    const rate = RATES[n]!;
    if (n < UPDATES_MAX) updates[model] = n + 1;
    const bound = Math.imul(this.range >>> 16, p) >>> 0;
    const value = this.code < bound;
    let learned: number;
    if (value) {
      this.range = bound;
      learned = p + (Math.imul(65535 - p, rate) >>> 16);
    } else {
      this.code = (this.code - bound) >>> 0;
      this.range = (this.range - bound) >>> 0;
      learned = p - (Math.imul(p, rate) >>> 16);
    }
    one[model] = learned < 64 ? 64 : learned > 65472 ? 65472 : learned;
    while (this.range < BOTTOM) this.shift();
    return value;
  }

  /** `count` equiprobable bits; at most 50. */
  raw(count: number): number {
    let value = 0;
    for (let left = count; left > 0; ) {
      const bits = Math.min(left, RAW_BITS_MAX);
      left -= bits;
      this.range >>>= bits;
      const digit = Math.min(Math.floor(this.code / this.range), 2 ** bits - 1);
      this.code = (this.code - digit * this.range) >>> 0;
      value = value * 2 ** bits + digit;
      while (this.range < BOTTOM) this.shift();
    }
    return value;
  }

  /** More zeros were read past the end than an encoder omits. */
  get pastEnd(): boolean {
    return this.at > this.bytes.length + TAIL;
  }

  /** All bytes were read, and no more. */
  get atCleanEnd(): boolean {
    return !this.pastEnd && this.at >= this.bytes.length;
  }

  get position(): number {
    return Math.min(this.at, this.bytes.length);
  }
}
