// The chat: the lines, and a field for a message.

import type { PanelContent } from '../ui/panels';
import type { ChatLine, ChatLog } from './chat_log';
import { lineElement } from './feed';
import { CHAT_CHARACTERS_MAX } from './text';

export interface ChatPanelOptions {
  readonly log: ChatLog;
  send(text: string): void;
  /** Leaves the field. */
  leave(): void;
  /** Opens the menu of the sender of a line. */
  openMenu(client: number, at: HTMLElement): void;
}

const isAtEnd = (box: HTMLElement) => box.scrollHeight - box.scrollTop - box.clientHeight < 40;

export function chatPanel(content: HTMLElement, { log, send, leave, openMenu }: ChatPanelOptions): PanelContent {
  content.className = 'chat';
  const lines = document.createElement('div');
  lines.className = 'lines';
  lines.setAttribute('role', 'log');
  lines.setAttribute('aria-live', 'polite');
  lines.setAttribute('aria-label', 'Chat');
  lines.tabIndex = 0; // so that keys scroll it
  const list = document.createElement('ol');
  lines.append(list);
  const empty = document.createElement('p');
  empty.className = 'note';
  empty.textContent = 'No messages yet. Everybody in this world can read what you write.';
  const form = document.createElement('form');
  const field = document.createElement('input');
  Object.assign(field, { type: 'text', name: 'message', maxLength: CHAT_CHARACTERS_MAX, autocomplete: 'off', placeholder: 'Message', enterKeyHint: 'send', dir: 'auto' });
  field.setAttribute('aria-label', 'Message to everybody in this world');
  const button = document.createElement('button');
  button.type = 'submit';
  button.textContent = 'Send';
  form.append(field, button);
  content.append(empty, lines, form);

  const rowOf = (line: ChatLine) => {
    const row = lineElement(line, 'li');
    const time = document.createElement('time');
    const date = new Date(line.timeMs);
    time.dateTime = date.toISOString();
    time.textContent = date.toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' });
    row.append(time);
    const name = row.querySelector<HTMLElement>('.name');
    if (name && !line.own && line.from !== 0) {
      const menu = document.createElement('button');
      menu.type = 'button';
      menu.className = 'name';
      menu.title = 'Mute, report and more';
      menu.append(name.cloneNode(true));
      menu.onclick = () => openMenu(line.from, menu);
      name.replaceWith(menu);
    }
    return row;
  };
  const render = () => {
    list.replaceChildren(...log.lines.map(rowOf));
    empty.hidden = list.childElementCount > 0;
    lines.scrollTop = lines.scrollHeight;
  };
  log.listen((line) => {
    if (!line) return render();
    const follows = isAtEnd(lines);
    list.append(rowOf(line));
    while (list.childElementCount > log.lines.length) list.firstElementChild!.remove();
    empty.hidden = true;
    if (follows || line.own) lines.scrollTop = lines.scrollHeight;
  });
  form.onsubmit = (event) => {
    event.preventDefault();
    if (field.value.trim() === '') return;
    send(field.value);
    field.value = '';
  };
  field.onkeydown = (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    leave();
  };
  render();
  return {
    opened() {
      log.setOpen(true);
      // On touch screens the keyboard would cover the messages.
      if (!matchMedia('(pointer: coarse)').matches) field.focus();
    },
    closed: () => log.setOpen(false),
  };
}
