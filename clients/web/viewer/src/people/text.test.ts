import { describe, expect, it } from 'vitest';
import { cleanName, cleanText, messageText, utf8Bytes } from './text';

describe('text of other users', () => {
  it('removes control characters and overrides of direction, and keeps the text', () => {
    expect(cleanText('a\u202Eb\u0000c\u200Bd', 10)).toBe('abcd');
    expect(cleanText('  two\n\nlines\t', 20)).toBe('two lines');
    expect(cleanText('שלום <b>עולם</b>', 40)).toBe('שלום <b>עולם</b>');
  });

  it('limits the length by characters, not by code units', () => {
    expect(cleanText('😀😀😀😀', 3)).toBe('😀😀…');
    expect(cleanText('😀😀😀', 3)).toBe('😀😀😀');
  });

  it('limits names to 32 bytes without splitting a character', () => {
    const name = cleanName('Ä'.repeat(20));
    expect([name.length, utf8Bytes(name)]).toEqual([16, 32]);
    expect(cleanName('😀'.repeat(9))).toBe('😀'.repeat(8));
    expect(cleanName(' \u202E\u200B ')).toBe('');
  });

  it('ignores messages that are no text', () => {
    expect(messageText(Uint8Array.of(0xff, 0xfe))).toBeUndefined();
    expect(messageText(new Uint8Array())).toBeUndefined();
    expect(messageText(new TextEncoder().encode('hello'))).toBe('hello');
    expect(messageText(new TextEncoder().encode('x'.repeat(1000)))!.length).toBe(300);
  });
});
