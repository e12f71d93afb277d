// The range decoder of codec 2 (proto/WIRE.md): bits against models that learn from them. Numbers of 32 bits are kept unsigned
// by `>>> 0`. Reading never trusts the bytes: past the end it gives zeros and remembers how many.

export const SEEN_MAX = 100;
/** An encoder leaves out zeros at the end, and so many at most. */
const TAIL = 4;
const BOTTOM = 2 ** 24;
const PIECE = 16; // raw bits that one division of the range takes

const RATES = Uint16Array.from({ length: SEEN_MAX + 1 }, (_, n) => Math.floor(655360 / (10 * n + 16)));

/** How likely each next bit is a one, of 65536, and how many bits said so. */
export interface Models {
  readonly one: Uint16Array;
  readonly seen: Uint8Array;
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

  private take(): void {
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.next()) >>> 0;
  }

  bit(model: number): boolean {
    const { one, seen } = this.models;
    const p = one[model]!;
    const n = seen[model]!;
    const rate = RATES[n]!;
    if (n < SEEN_MAX) seen[model] = n + 1;
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
    while (this.range < BOTTOM) this.take();
    return value;
  }

  /** `count` bits, each as likely a one as a zero; at most 50. */
  raw(count: number): number {
    let value = 0;
    for (let left = count; left > 0; ) {
      const bits = Math.min(left, PIECE);
      left -= bits;
      this.range >>>= bits;
      const digit = Math.min(Math.floor(this.code / this.range), 2 ** bits - 1);
      this.code = (this.code - digit * this.range) >>> 0;
      value = value * 2 ** bits + digit;
      while (this.range < BOTTOM) this.take();
    }
    return value;
  }

  /** More zeros were read past the end than an encoder leaves out. */
  get pastEnd(): boolean {
    return this.at > this.bytes.length + TAIL;
  }

  /** Every byte was needed, and no more. */
  get atCleanEnd(): boolean {
    return !this.pastEnd && this.at >= this.bytes.length;
  }

  get position(): number {
    return Math.min(this.at, this.bytes.length);
  }
}
