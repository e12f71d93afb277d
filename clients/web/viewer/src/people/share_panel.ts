// The link to the world: copy it, share it, or scan its QR code with a phone.

import encodeQR from 'qr';
import type { PanelContent } from '../ui/panels';
import { isLoopback } from './world_address';

const PIXELS_PER_MODULE = 6;
const QUIET_ZONE = 4; // modules, as the standard requires

/** Draws black on white in both themes: scanners need the contrast. */
export function drawQrCode(canvas: HTMLCanvasElement, text: string): void {
  const rows = encodeQR(text, 'raw', { ecc: 'medium', border: QUIET_ZONE });
  canvas.width = canvas.height = rows.length * PIXELS_PER_MODULE;
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = '#000';
  for (const [y, row] of rows.entries())
    for (const [x, dark] of row.entries()) if (dark) context.fillRect(x * PIXELS_PER_MODULE, y * PIXELS_PER_MODULE, PIXELS_PER_MODULE, PIXELS_PER_MODULE);
}

/** Pages without TLS have no clipboard API, except on the machine of the server. */
async function copy(field: HTMLInputElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(field.value);
    return true;
  } catch {
    field.focus();
    field.select();
    return document.execCommand('copy');
  }
}

export interface SharePanelOptions {
  /** `withCode`: with the join code of a private room. */
  link(withCode: boolean): string;
  joinCode(): string;
  title(): string;
}

export function sharePanel(content: HTMLElement, { link, joinCode, title }: SharePanelOptions): PanelContent {
  content.className = 'share';
  const field = document.createElement('input');
  field.readOnly = true;
  field.type = 'url';
  field.setAttribute('aria-label', 'Link to this world');
  field.onfocus = () => field.select();
  const copyButton = document.createElement('button');
  copyButton.type = 'button';
  copyButton.className = 'primary';
  copyButton.textContent = 'Copy link';
  const status = document.createElement('p');
  status.className = 'note';
  status.setAttribute('role', 'status');
  const shareButton = document.createElement('button');
  shareButton.type = 'button';
  shareButton.textContent = 'Share …';
  shareButton.hidden = !('share' in navigator);
  const codeLabel = document.createElement('label');
  codeLabel.className = 'check';
  const withCode = document.createElement('input');
  withCode.type = 'checkbox';
  codeLabel.append(withCode, 'Include the join code');
  const canvas = document.createElement('canvas');
  canvas.setAttribute('role', 'img');
  const note = document.createElement('p');
  note.className = 'note';
  const buttons = document.createElement('div');
  buttons.className = 'buttons';
  buttons.append(copyButton, shareButton);
  content.append(field, codeLabel, buttons, status, canvas, note);

  const render = () => {
    codeLabel.hidden = joinCode() === '';
    field.value = link(withCode.checked);
    drawQrCode(canvas, field.value);
    canvas.setAttribute('aria-label', `QR code of ${field.value}`);
    note.textContent = isLoopback(new URL(field.value).hostname)
      ? 'Only this computer can open this address. Open the viewer under the address of this computer in your network to invite others.'
      : 'Scan the code with a phone, or send the link.';
    status.textContent = '';
  };
  withCode.onchange = render;
  copyButton.onclick = async () => {
    status.textContent = (await copy(field)) ? 'The link was copied.' : 'Copy the selected link with your keyboard.';
  };
  shareButton.onclick = () => void navigator.share({ title: title(), url: field.value }).catch(() => {});
  return {
    opened: render,
    // The user may have joined another world meanwhile.
    update: () => {
      if (field.value !== link(withCode.checked)) render();
    },
  };
}
