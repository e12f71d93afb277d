// What of a world a viewer asks to be told, from its address line: ?sight=150&kbps=500.

/** A circle on the ground, in m (0: all of the world), and how many kbit/s (0: what the world takes). */
export interface AreaOfInterest {
  readonly radius: number;
  readonly maxKbps: number;
}

const KBPS_MIN = 16; // a server refuses less

/** What is out of range is left out; undefined: all, and without a bound. */
export function areaOfInterestFromQuery(search: string): AreaOfInterest | undefined {
  const asked = new URLSearchParams(search);
  const number = (name: string, least: number) => {
    const value = Number(asked.get(name) ?? '');
    return value >= least && value <= 1e6 ? value : 0;
  };
  const radius = number('sight', 1);
  const maxKbps = Math.round(number('kbps', KBPS_MIN));
  return radius > 0 || maxKbps > 0 ? { radius, maxKbps } : undefined;
}
