// Tables and buttons of the monitor page. Text is always set as text, never as HTML: names come from
// clients.

import { element } from '../ui/elements';

export interface Column<Row> {
  readonly title: string;
  readonly cell: (row: Row) => string | Node | readonly Node[];
  readonly isNumber?: boolean;
}

/** A button that works once, until the next table replaces it. */
export function button(text: string, onClick: () => void): HTMLButtonElement {
  const created = element('button', text);
  created.type = 'button';
  created.addEventListener('click', () => {
    created.disabled = true;
    onClick();
  });
  return created;
}

/** Whether the user is about to press a button of the element, or chooses from a list. */
export function isInUse(parent: HTMLElement): boolean {
  return parent.matches(':has(button:enabled:hover, select:focus)');
}

/** Replaces the content of `parent`, unless the user is about to press one of its buttons. */
export function showTable<Row>(parent: HTMLElement, columns: readonly Column<Row>[], rows: readonly Row[], empty: string): void {
  if (isInUse(parent)) return;
  if (rows.length === 0) {
    parent.replaceChildren(element('p', empty, 'empty'));
    return;
  }
  const table = element('table');
  const head = table.createTHead().insertRow();
  for (const { title, isNumber } of columns) head.append(element('th', title, isNumber ? 'number' : ''));
  const body = table.createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    for (const { cell, isNumber } of columns) {
      const content = cell(row);
      const data = line.insertCell();
      if (isNumber) data.className = 'number';
      if (typeof content === 'string') data.textContent = content;
      else if (content instanceof Node) data.append(content);
      else data.append(...content);
    }
  }
  parent.replaceChildren(table);
}
