// Reads the values of a channel in order. Values are untrusted: reads past the end return 0 and set
// `failed`.

const word = new DataView(new ArrayBuffer(4));

export class ValueReader {
  failed = false;
  private at = 0;

  constructor(private readonly values: Int32Array) {}

  get left(): number {
    return this.values.length - this.at;
  }
  value(): number {
    if (this.left > 0) return this.values[this.at++]!;
    this.failed = true;
    return 0;
  }
  /** A value quantized to 2^bits steps from low to high; fails for other values. */
  quantized(low: number, high: number, bits: number): number {
    const step = this.value();
    const last = 2 ** bits - 1;
    if (step >= 0 && step <= last) return low + (step / last) * (high - low);
    this.failed = true;
    return low;
  }
  /** A float sent as its four bytes; fails if it is not finite. */
  f32(): number {
    word.setInt32(0, this.value());
    const value = word.getFloat32(0);
    if (Number.isFinite(value)) return value;
    this.failed = true;
    return 0;
  }
}
