// The name and the color of the user. It opens by itself at the first visit.

import type { PanelContent } from '../ui/panels';
import { COLOR_NAMES, colorText, PLAYER_COLORS, type Identity } from './identity';
import { cleanName, NAME_BYTES_MAX } from './text';

export function identityPanel(content: HTMLElement, current: () => Identity, save: (identity: Identity) => void, close: () => void): PanelContent {
  const form = document.createElement('form');
  form.className = 'identity';
  const nameLabel = document.createElement('label');
  nameLabel.textContent = 'Name';
  const name = document.createElement('input');
  Object.assign(name, { type: 'text', name: 'name', autocomplete: 'nickname', maxLength: NAME_BYTES_MAX, dir: 'auto', enterKeyHint: 'done' });
  nameLabel.append(name);
  const colors = document.createElement('fieldset');
  const legend = document.createElement('legend');
  legend.textContent = 'Color';
  colors.append(legend);
  const swatches = PLAYER_COLORS.map((color, k) => {
    const label = document.createElement('label');
    const radio = document.createElement('input');
    Object.assign(radio, { type: 'radio', name: 'color', value: String(color) });
    radio.setAttribute('aria-label', COLOR_NAMES[k]!);
    label.title = COLOR_NAMES[k]!;
    label.style.setProperty('--player', colorText(color));
    label.append(radio);
    colors.append(label);
    return radio;
  });
  const problem = document.createElement('p');
  problem.className = 'problem';
  problem.setAttribute('role', 'alert');
  const button = document.createElement('button');
  button.type = 'submit';
  button.className = 'primary';
  button.textContent = 'Save';
  form.append(nameLabel, colors, problem, button);
  content.append(form);

  form.onsubmit = (event) => {
    event.preventDefault();
    const chosen = cleanName(name.value);
    if (!chosen) {
      problem.textContent = 'Enter a name with at least one visible character.';
      name.setAttribute('aria-invalid', 'true');
      return name.focus();
    }
    problem.textContent = '';
    name.removeAttribute('aria-invalid');
    const color = swatches.find(({ checked }) => checked);
    save({ name: chosen, color: color ? Number(color.value) : current().color, chosen: true });
    close();
  };
  return {
    opened() {
      const identity = current();
      name.value = identity.chosen ? identity.name : '';
      name.placeholder = identity.name;
      problem.textContent = '';
      for (const radio of swatches) radio.checked = Number(radio.value) === identity.color;
    },
  };
}
