// Bits in, and the two codes of proto/WIRE.md. Numbers may have up to 40 bits, so arithmetic takes over where 32-bit
// operators would cut. Reading never trusts the bytes: past the end it gives zeros and remembers.

const RICE_ESCAPE = 15;
const RICE_ESCAPE_BITS = 33;

export class BitReader {
  private at = 0; // bit

  constructor(private readonly bytes: Uint8Array) {}

  /** The next `count` bits, least significant first; count at most 40. */
  bits(count: number): number {
    let value = 0;
    let have = 0;
    while (have < count) {
      const byte = this.bytes[this.at >> 3] ?? 0;
      const offset = this.at & 7;
      const take = Math.min(8 - offset, count - have);
      value += ((byte >> offset) & ((1 << take) - 1)) * 2 ** have;
      have += take;
      this.at += take;
    }
    return value;
  }

  rice(k: number): number {
    let ones = 0;
    while (ones < RICE_ESCAPE && this.bits(1) === 1) ones++;
    if (ones === RICE_ESCAPE) return this.bits(RICE_ESCAPE_BITS);
    return ones * 2 ** k + this.bits(k);
  }

  expGolomb(k: number): number {
    const low = this.rice(0) + k;
    if (low > 40) {
      this.at = this.bytes.length * 8 + 1; // not ours: counts as past the end
      return 0;
    }
    return this.bits(low) + 2 ** low - 2 ** k;
  }

  /** Takes the next 15 bits when they are all ones. */
  takeEscape(): boolean {
    const before = this.at;
    if (this.bits(RICE_ESCAPE) === 2 ** RICE_ESCAPE - 1) return true;
    this.at = before;
    return false;
  }

  get pastEnd(): boolean {
    return this.at > this.bytes.length * 8;
  }

  get position(): number {
    return this.at;
  }

  /** What is left is padding: fewer than eight bits, all zero. */
  atCleanEnd(): boolean {
    const left = this.bytes.length * 8 - this.at;
    return left >= 0 && left < 8 && this.bits(left) === 0;
  }
}

export function unZigZag(u: number): number {
  return u % 2 === 1 ? -(u + 1) / 2 : u / 2;
}

/** Bits needed to write x: 0 for 0, 1 for 1, 2 for 2 and 3, ... */
export function bitWidth(x: number): number {
  let bits = 0;
  for (let rest = x; rest >= 1; rest = Math.floor(rest / 2)) bits++;
  return bits;
}
