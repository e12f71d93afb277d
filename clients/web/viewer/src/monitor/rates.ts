// Rates of counters that only increase, from successive readings.

import type { Count } from './api';

export interface Rate {
  readonly name: string;
  readonly total: number;
  readonly perSecond: number;
}

export class Rates {
  private totals = new Map<string, number>();
  private readAt: number | undefined;

  /** `seconds`: a clock. The first reading, and the first one after the server restarted, have rates of 0. */
  read(counts: readonly Count[], seconds: number): Rate[] {
    const elapsed = this.readAt === undefined ? 0 : seconds - this.readAt;
    const rates = counts.map(({ name, value }) => {
      const before = this.totals.get(name);
      const grown = before === undefined || value < before ? 0 : value - before;
      return { name, total: value, perSecond: elapsed > 0 ? grown / elapsed : 0 };
    });
    this.totals = new Map(counts.map(({ name, value }) => [name, value]));
    this.readAt = seconds;
    return rates;
  }
}

const UNITS = ['', 'k', 'M', 'G', 'T'];

/** 1234567 is "1.23 M". */
export function shortNumber(value: number): string {
  let unit = 0;
  let scaled = value;
  while (scaled >= 1000 && unit < UNITS.length - 1) {
    scaled /= 1000;
    unit++;
  }
  const digits = unit === 0 && Number.isInteger(scaled) ? 0 : scaled < 10 ? 2 : scaled < 100 ? 1 : 0;
  return `${scaled.toFixed(digits)}${unit > 0 ? ` ${UNITS[unit]}` : ''}`;
}

/** 93784 is "1 d 2 h", 75 is "1 min 15 s". */
export function duration(seconds: number): string {
  const whole = Math.floor(seconds);
  const days = Math.floor(whole / 86400);
  const hours = Math.floor(whole / 3600) % 24;
  const minutes = Math.floor(whole / 60) % 60;
  if (days > 0) return `${days} d ${hours} h`;
  if (hours > 0) return `${hours} h ${minutes} min`;
  if (minutes > 0) return `${minutes} min ${whole % 60} s`;
  return `${whole} s`;
}
