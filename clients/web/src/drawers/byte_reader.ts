// Foreign bytes, little endian. Past the end all is zero and `failed` is set.

export class ByteReader {
  failed = false;
  private at = 0;
  private readonly view: DataView;

  constructor(bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get left(): number {
    return this.view.byteLength - this.at;
  }
  u8(): number {
    const at = this.take(1);
    return at < 0 ? 0 : this.view.getUint8(at);
  }
  u16(): number {
    const at = this.take(2);
    return at < 0 ? 0 : this.view.getUint16(at, true);
  }
  u32(): number {
    const at = this.take(4);
    return at < 0 ? 0 : this.view.getUint32(at, true);
  }
  /** What is no number fails. */
  f32(): number {
    const at = this.take(4);
    const value = at < 0 ? 0 : this.view.getFloat32(at, true);
    if (Number.isFinite(value)) return value;
    this.failed = true;
    return 0;
  }
  /** A number that was rounded to even steps from low to high. */
  quantized(low: number, high: number, bytes: 1 | 2): number {
    const share = bytes === 1 ? this.u8() / 255 : this.u16() / 65535;
    return low + share * (high - low);
  }

  private take(count: number): number {
    const at = this.at;
    if (count > this.left) {
      this.failed = true;
      this.at = this.view.byteLength;
      return -1;
    }
    this.at += count;
    return at;
  }
}
