// New chat lines over the tools while the chat is closed. A live region announces them.

import { colorText } from './identity';
import type { ChatLine, ChatLog } from './chat_log';

const SHOWN_MS = 9000;
const LINES_MAX = 4;

export function lineElement(line: ChatLine, tag: 'p' | 'li'): HTMLElement {
  const element = document.createElement(tag);
  element.className = line.kind;
  if (line.kind === 'message') {
    const name = document.createElement('bdi');
    name.className = 'name';
    name.textContent = line.name;
    name.style.setProperty('--player', colorText(line.color));
    element.append(name, ' ');
  }
  const text = document.createElement('span');
  text.dir = 'auto';
  text.className = 'text';
  text.textContent = line.text;
  element.append(text);
  if (line.refused) {
    const refused = document.createElement('small');
    refused.textContent = `Not sent: ${line.refused}`;
    element.classList.add('refused');
    element.append(refused);
  }
  return element;
}

export class Feed {
  constructor(
    private readonly element: HTMLElement,
    log: ChatLog,
  ) {
    element.setAttribute('role', 'log');
    element.setAttribute('aria-live', 'polite');
    element.setAttribute('aria-label', 'New messages');
    log.listen((line) => {
      if (log.isOpen) element.replaceChildren();
      else if (line) this.add(line);
    });
  }

  private add(line: ChatLine): void {
    const shown = lineElement(line, 'p');
    this.element.append(shown);
    while (this.element.childElementCount > LINES_MAX) this.element.firstElementChild!.remove();
    setTimeout(() => shown.remove(), SHOWN_MS);
  }
}
