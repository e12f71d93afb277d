// Who is playing: a token that the page was opened with, as #token=... . It is taken out of the address at once, so that neither
// history nor a shared link holds it, and kept for as long as the tab lives.

const KEY = 'jostle-token';

export interface UrlLocation {
  readonly hash: string;
  /** Puts another hash in the address without a trace of the old one. */
  replaceHash(hash: string): void;
}

export function takeToken(place: UrlLocation, store: Pick<Storage, 'getItem' | 'setItem'>): string {
  const fields = new URLSearchParams(place.hash.replace(/^#/, ''));
  const given = fields.get('token');
  if (given === null) return store.getItem(KEY) ?? '';
  fields.delete('token');
  place.replaceHash(fields.toString());
  store.setItem(KEY, given);
  return given;
}
