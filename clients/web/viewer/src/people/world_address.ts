// The address of the page names the world, so that it survives reloading and can be shared. A shared
// link contains neither the settings of the user nor a token.

const CODE_PREFIX = 'jostle-join-code:';

/** The search part of the page's URL with this world; the other parameters stay. */
export function searchWithWorld(search: string, world: string): string {
  const parameters = new URLSearchParams(search);
  parameters.set('world', world);
  return `?${parameters.toString()}`;
}

/** The link to a world. `joinCode`: of a private room, in the fragment, which no server logs. */
export function linkToWorld({ origin, pathname }: Pick<Location, 'origin' | 'pathname'>, world: string, joinCode = ''): string {
  const link = `${origin}${pathname}?${new URLSearchParams({ world }).toString()}`;
  return joinCode ? `${link}#${new URLSearchParams({ code: joinCode }).toString()}` : link;
}

/** Whether only this machine can open the address. */
export function isLoopback(hostname: string): boolean {
  return hostname === 'localhost' || hostname.endsWith('.localhost') || /^127\./.test(hostname) || hostname === '[::1]';
}

/** Join codes of private rooms by world name, for the lifetime of the tab. */
export class JoinCodes {
  constructor(private readonly store: Pick<Storage, 'getItem' | 'setItem'>) {}

  get(world: string): string {
    try {
      return this.store.getItem(CODE_PREFIX + world) ?? '';
    } catch {
      return '';
    }
  }
  set(world: string, code: string): void {
    try {
      this.store.setItem(CODE_PREFIX + world, code);
    } catch {
      // Pages without storage ask again.
    }
  }
}

export interface UrlHash {
  readonly hash: string;
  replaceHash(hash: string): void;
}

/** Removes the join code from the fragment of the URL and returns it; empty: there is none. */
export function takeJoinCode(url: UrlHash): string {
  const fields = new URLSearchParams(url.hash.replace(/^#/, ''));
  const code = fields.get('code');
  if (code === null) return '';
  fields.delete('code');
  url.replaceHash(fields.toString());
  return code;
}
