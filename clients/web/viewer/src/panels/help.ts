// Lists the tools, the keys and the gestures.

import type { Command } from '../ui/commands';
import type { PanelContent } from '../ui/panels';
import type { ToolDefinition } from '../ui/toolbar';

const POINTER: [what: string, how: string][] = [
  ['Turn', 'Drag the ground'],
  ['Pan', 'Drag with the right button'],
  ['Zoom', 'Wheel'],
  ['Focus', 'Double click a body'],
  ['Menu of a body', 'Right click it'],
];
const TOUCH: [what: string, how: string][] = [
  ['Turn', 'Drag with one finger'],
  ['Pan and zoom', 'Drag and pinch with two fingers'],
  ['Focus', 'Double tap a body'],
  ['Menu of a body', 'Press it for half a second'],
];
const VIEW_KEYS: [key: string, what: string][] = [
  ['Esc', 'Release the controlled entity, or close the newest panel'],
  ['Space', 'Play or pause a recording'],
  ['← → ↑ ↓', 'Turn the view while it has the focus'],
  ['+ −', 'Zoom the view while it has the focus'],
];
const DRIVING: [key: string, what: string][] = [
  ['W A S D', 'Steer the controlled entity; arrow keys do the same'],
  ['Space Shift E Q', 'Its buttons, such as jump or hand brake'],
];

function section(title: string, rows: readonly (readonly [string, string])[], asKeys: boolean): HTMLElement[] {
  const heading = document.createElement('h3');
  heading.textContent = title;
  const list = document.createElement('dl');
  for (const [term, description] of rows) {
    const dt = document.createElement('dt');
    const [, key, label] = asKeys ? [] : (/^(\S) (.+)$/.exec(term) ?? []);
    if (key && label) dt.append(Object.assign(document.createElement('kbd'), { textContent: key }), ` ${label}`);
    else if (asKeys) dt.append(...term.split(' ').map((key) => Object.assign(document.createElement('kbd'), { textContent: key })));
    else dt.textContent = term;
    const dd = document.createElement('dd');
    dd.textContent = description;
    list.append(dt, dd);
  }
  return [heading, list];
}

export function helpPanel(content: HTMLElement, tools: readonly ToolDefinition[], commands: readonly Command[]): PanelContent {
  const touch = matchMedia('(pointer: coarse)').matches;
  const keys = commands.filter(({ key }) => !tools.some((tool) => tool.key === key)).map(({ key, label }) => [key.length === 1 ? key.toUpperCase() : key, label] as const);
  const toolRows = tools.map(({ key, label, hint }) => (touch ? [label, hint.replace('Click', 'Tap').replace('; Esc releases it', '')] : [`${key.toUpperCase()} ${label}`, hint]) as [string, string]);
  content.append(
    ...(touch ? section('Touch', TOUCH, false) : []),
    ...section('Tools', toolRows, false),
    ...(touch ? [] : section('Mouse', POINTER, false)),
    ...section('Keys', [...keys, ...VIEW_KEYS], true),
    ...section('Driving', DRIVING, true),
  );
  return {};
}
