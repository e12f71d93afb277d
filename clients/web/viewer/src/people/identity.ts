// The name and the color of the user, stored in the browser.

import { cleanName } from './text';

export const PLAYER_COLORS = [0xe4572e, 0xf29e1f, 0xe0c51b, 0x5fae3a, 0x1fa187, 0x2f8fd8, 0x5566e0, 0x9b59d0, 0xd64f9e, 0x8a6d55] as const;

export const COLOR_NAMES = ['red', 'orange', 'yellow', 'green', 'teal', 'blue', 'indigo', 'violet', 'pink', 'brown'] as const;

export interface Identity {
  readonly name: string; // as the server accepts it
  readonly color: number; // 0xRRGGBB
  /** False: the name was generated. */
  readonly chosen: boolean;
}

const NAME_KEY = 'jostle-name';
const COLOR_KEY = 'jostle-color';

export type IdentityStore = Pick<Storage, 'getItem' | 'setItem'>;

/** The stored identity, or else a guest with a random number and color. */
export function loadIdentity(store: IdentityStore, random: () => number = Math.random): Identity {
  const stored = cleanName(read(store, NAME_KEY));
  const color = parseColor(read(store, COLOR_KEY)) ?? PLAYER_COLORS[Math.floor(random() * PLAYER_COLORS.length)]!;
  if (stored) return { name: stored, color, chosen: true };
  return { name: `Guest ${100 + Math.floor(random() * 900)}`, color, chosen: false };
}

export function storeIdentity(store: IdentityStore, { name, color }: Identity): void {
  try {
    store.setItem(NAME_KEY, name);
    store.setItem(COLOR_KEY, colorText(color));
  } catch {
    // Pages without storage ask again at the next visit.
  }
}

function read(store: IdentityStore, key: string): string {
  try {
    return store.getItem(key) ?? '';
  } catch {
    return '';
  }
}

/** "#rrggbb" */
export const colorText = (color: number): string => `#${color.toString(16).padStart(6, '0')}`;

function parseColor(text: string): number | undefined {
  return /^#[0-9a-f]{6}$/i.test(text) ? Number.parseInt(text.slice(1), 16) : undefined;
}

export const isColor = (value: unknown): value is number => Number.isInteger(value) && (value as number) >= 0 && (value as number) <= 0xffffff;
