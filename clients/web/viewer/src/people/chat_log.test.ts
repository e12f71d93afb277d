import { expect, it } from 'vitest';
import { CHAT_LINES_MAX, ChatLog } from './chat_log';

const message = (from: number, text: string, own = false) => ({ kind: 'message' as const, from, name: `p${from}`, color: 0, text, own, timeMs: 0 });

it('counts unread messages of others while the chat is closed', () => {
  const log = new ChatLog();
  log.add(message(1, 'a'));
  log.add(message(2, 'own', true));
  log.add({ ...message(0, 'p3 joined'), kind: 'notice' });
  expect(log.unread).toBe(1);
  log.setOpen(true);
  log.add(message(1, 'b'));
  expect(log.unread).toBe(0);
});

it('hides the messages of a muted client and shows them again', () => {
  const log = new ChatLog();
  log.add(message(1, 'a'));
  log.add(message(2, 'b'));
  log.setHidden(1, true);
  log.add(message(1, 'c'));
  expect(log.lines.map(({ text }) => text)).toEqual(['b']);
  log.setHidden(1, false);
  expect(log.lines.map(({ text }) => text)).toEqual(['a', 'b']);
});

it('retains the newest lines', () => {
  const log = new ChatLog();
  for (let k = 0; k < CHAT_LINES_MAX + 5; k++) log.add(message(1, String(k)));
  expect([log.lines.length, log.lines[0]!.text, log.lines[0]!.number]).toEqual([CHAT_LINES_MAX, '5', 6]);
  expect(log.newestOf(1, 2).map(({ text }) => text)).toEqual(['203', '204']);
});
