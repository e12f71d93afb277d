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
  private readonly hints = new Map<Id, string>();
  private readonly refusals = new Map<Id, string>();

  constructor(
    private readonly bar: HTMLElement,
    tools: readonly ToolDefinition<Id>[],
    private readonly select: (tool: Id) => void,
    /** Called instead of `select` for a tool that a rule refuses. */
    private readonly explain: (rule: string) => void,
  ) {
    for (const { tool, key, label, hint, icon } of tools) {
      this.hints.set(tool, `${hint} (${key.toUpperCase()})`);
      const button = iconButton(icon, label, label);
      button.removeAttribute('aria-label'); // the text is its name
      button.dataset['tool'] = tool;
      button.title = this.hints.get(tool)!;
      const keyText = document.createElement('kbd');
      keyText.textContent = key.toUpperCase();
      keyText.setAttribute('aria-hidden', 'true');
      button.append(keyText);
      button.onclick = () => this.choose(tool);
      this.buttons.set(tool, button);
      bar.append(button);
    }
  }

  /** Selects the tool, or explains why it cannot be used. */
  choose(tool: Id): void {
    const rule = this.refusals.get(tool);
    if (rule) this.explain(rule);
    else this.select(tool);
  }

  /** Disables the tools that the rules refuse; `refusal` returns the rule, or an empty text. */
  setRefusals(refusal: (tool: Id) => string): void {
    for (const [tool, button] of this.buttons) {
      const rule = refusal(tool);
      if (rule) this.refusals.set(tool, rule);
      else this.refusals.delete(tool);
      // The button stays focusable, so that its title can be read.
      button.setAttribute('aria-disabled', String(rule !== ''));
      button.title = rule || this.hints.get(tool)!;
    }
  }

  /** The rule that refuses a tool; empty: none. */
  refusalOf(tool: Id): string {
    return this.refusals.get(tool) ?? '';
  }

  /** Shows which tool is selected. */
  show(selected: Id): void {
    for (const [tool, button] of this.buttons) {
      button.setAttribute('aria-pressed', String(tool === selected));
      if (tool === selected && this.bar.scrollWidth > this.bar.clientWidth) button.scrollIntoView({ block: 'nearest', inline: 'center' });
    }
  }
}
