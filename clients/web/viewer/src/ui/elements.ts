// Elements of panels. Text is always set as text, never as HTML: names come from clients.

export function element<K extends keyof HTMLElementTagNameMap>(tag: K, text = '', className = ''): HTMLElementTagNameMap[K] {
  const created = document.createElement(tag);
  created.textContent = text;
  if (className) created.className = className;
  return created;
}

export function button(text: string, run: () => void, className = ''): HTMLButtonElement {
  const created = element('button', text, className);
  created.type = 'button';
  created.onclick = run;
  return created;
}
