// The bar of pointer tools.

import { iconButton, type IconName } from './icons';

export interface ToolDefinition<Id extends string = string> {
  readonly tool: Id;
  readonly key: string;
  readonly label: string;
  readonly hint: string;
  readonly icon: IconName;
}

export class Toolbar<Id extends string> {
  private readonly buttons = new Map<Id, HTMLButtonElement>();

  constructor(
    private readonly bar: HTMLElement,
    tools: readonly ToolDefinition<Id>[],
    select: (tool: Id) => void,
  ) {
    for (const { tool, key, label, hint, icon } of tools) {
      const button = iconButton(icon, label, label);
      button.removeAttribute('aria-label'); // the text is its name
      button.dataset['tool'] = tool;
      button.title = `${hint} (${key.toUpperCase()})`;
      const keyText = document.createElement('kbd');
      keyText.textContent = key.toUpperCase();
      keyText.setAttribute('aria-hidden', 'true');
      button.append(keyText);
      button.onclick = () => select(tool);
      this.buttons.set(tool, button);
      bar.append(button);
    }
  }

  /** Shows which tool is selected. */
  show(selected: Id): void {
    for (const [tool, button] of this.buttons) {
      button.setAttribute('aria-pressed', String(tool === selected));
      if (tool === selected && this.bar.scrollWidth > this.bar.clientWidth) button.scrollIntoView({ block: 'nearest', inline: 'center' });
    }
  }
}
