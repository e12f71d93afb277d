// Reads bits and the two variable-length codes of proto/WIRE.md. Values have up to 40 bits, so
// arithmetic is used where 32-bit operators would truncate. Reads past the end return zeros and set
// pastEnd.

const RICE_ESCAPE = 15;
const RICE_ESCAPE_BITS = 33;
const ALL_ONES = 2 ** RICE_ESCAPE - 1;
const BITS_PER_READ = 24; // bits that one peek returns at any bit offset

export class BitReader {
  private at = 0; // bit
  private readonly bytes: Uint8Array; // padded with zeros, so that peek needs no bounds check
  private readonly end: number; // bit

  constructor(bytes: Uint8Array) {
    this.bytes = new Uint8Array(bytes.length + 4);
    this.bytes.set(bytes);
    this.end = bytes.length * 8;
  }

  /** At least the next 24 bits; higher bits may follow. */
  private peek(): number {
    if (this.at > this.end) return 0;
    const { bytes } = this;
    const i = this.at >> 3;
    const word = bytes[i]! | (bytes[i + 1]! << 8) | (bytes[i + 2]! << 16) | (bytes[i + 3]! << 24);
    return word >>> (this.at & 7);
  }

  /** The next `count` bits, least significant first; `count` is at most 40. */
  bits(count: number): number {
    if (count > BITS_PER_READ) {
      const low = this.bits(BITS_PER_READ);
      return low + this.bits(count - BITS_PER_READ) * 2 ** BITS_PER_READ;
    }
    const value = this.peek() & ((1 << count) - 1);
    this.at += count;
    return value;
  }

  rice(k: number): number {
    const zeros = ~this.peek() & ALL_ONES; // the lowest set bit ends the run of ones
    if (zeros === 0) {
      this.at += RICE_ESCAPE;
      return this.bits(RICE_ESCAPE_BITS);
    }
    const ones = 31 - Math.clz32(zeros & -zeros);
    this.at += ones + 1;
    return (ones << k) + this.bits(k);
  }

  expGolomb(k: number): number {
    const low = this.rice(0) + k;
    if (low > 40) {
      this.at = this.end + 1; // not written by an encoder: reported as past the end
      return 0;
    }
    return this.bits(low) + 2 ** low - 2 ** k;
  }

  /** Consumes the next 15 bits if they are all ones. */
  takeEscape(): boolean {
    if ((this.peek() & ALL_ONES) !== ALL_ONES) return false;
    this.at += RICE_ESCAPE;
    return true;
  }

  get pastEnd(): boolean {
    return this.at > this.end;
  }

  get position(): number {
    return this.at;
  }

  /** Only padding remains: fewer than eight bits, all zero. */
  atCleanEnd(): boolean {
    const left = this.end - this.at;
    return left >= 0 && left < 8 && this.bits(left) === 0;
  }
}

export function zigZagDecode(u: number): number {
  return u % 2 === 1 ? -(u + 1) / 2 : u / 2;
}

/** Number of bits of x: 0 for 0, 1 for 1, 2 for 2 and 3, ... */
export function bitWidth(x: number): number {
  return x < 2 ** 32 ? 32 - Math.clz32(x) : 32 + bitWidth(Math.floor(x / 2 ** 32));
}
