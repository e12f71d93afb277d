/** The part of a world that a client subscribes to (proto Interest). */
export interface AreaOfInterest {
  /** m, horizontally around the focus, from 1; 0: the whole world. */
  readonly radius: number;
  /** Bandwidth limit in kbit/s, from 16; 0: no limit. */
  readonly maxKbps: number;
}
