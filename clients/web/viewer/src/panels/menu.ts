// The menu of narrow screens: the panels and the commands, which wide screens have in the bar.

import { iconButton, type IconName } from '../ui/icons';
import type { PanelContent, PanelDefinition } from '../ui/panels';

export interface MenuEntry {
  readonly icon: IconName;
  readonly label: string;
  readonly hint: string;
  run(): void;
}

export function menuPanel(content: HTMLElement, panels: readonly PanelDefinition[], open: (id: string) => void, commands: readonly MenuEntry[]): PanelContent {
  const entries: MenuEntry[] = [...panels.map(({ id, icon, title, hint }) => ({ icon, label: title, hint, run: () => open(id) })), ...commands];
  content.className = 'menu';
  content.append(
    ...entries.map(({ icon, label, hint, run }) => {
      const button = iconButton(icon, label, label);
      const text = document.createElement('small');
      text.textContent = hint;
      button.append(text);
      button.onclick = run;
      return button;
    }),
  );
  return {};
}
