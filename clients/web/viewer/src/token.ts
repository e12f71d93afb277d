// The token of the user, from #token=... of the URL. It is removed from the URL immediately, so that
// neither the history nor a shared link contains it, and stored for the lifetime of the tab.

const KEY = 'jostle-token';

export interface UrlLocation {
  readonly hash: string;
  /** Replaces the hash without a history entry. */
  replaceHash(hash: string): void;
}

export function takeToken(url: UrlLocation, store: Pick<Storage, 'getItem' | 'setItem'>): string {
  const fields = new URLSearchParams(url.hash.replace(/^#/, ''));
  const token = fields.get('token');
  if (token === null) return store.getItem(KEY) ?? '';
  fields.delete('token');
  url.replaceHash(fields.toString());
  store.setItem(KEY, token);
  return token;
}
