// Text of other users. It is shown with textContent and its own direction; this removes what could
// disturb the text around it, and limits its length.

export const NAME_BYTES_MAX = 32; // as the server
export const CHAT_CHARACTERS_MAX = 300;

// Control characters, line separators, marks and overrides of direction, and invisible characters.
const DISTURBING = /[\u0000-\u001f\u007f-\u009f\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb]/gu;

/** One line of at most `charactersMax` characters. */
export function cleanText(text: string, charactersMax: number): string {
  const line = text.replace(/\s+/gu, ' ').replace(DISTURBING, '').trim();
  const characters = [...line];
  return characters.length <= charactersMax ? line : `${characters.slice(0, charactersMax - 1).join('')}…`;
}

export const utf8Bytes = (text: string): number => new TextEncoder().encode(text).length;

/** A display name that the server accepts: at most 32 bytes; empty: there is no visible character. */
export function cleanName(text: string): string {
  let name = '';
  for (const character of cleanText(text, NAME_BYTES_MAX)) {
    if (utf8Bytes(name + character) > NAME_BYTES_MAX) break;
    name += character;
  }
  return name.trim();
}

/** The text of a message; undefined: it is empty or not UTF-8. */
export function messageText(data: Uint8Array, charactersMax = CHAT_CHARACTERS_MAX): string | undefined {
  try {
    return cleanText(new TextDecoder('utf-8', { fatal: true }).decode(data), charactersMax) || undefined;
  } catch {
    return undefined;
  }
}
