// Icons as strokes of 24 x 24 units.

const PATHS = {
  drag: 'M8 12V6.5a1.5 1.5 0 0 1 3 0V11m0-.5v-5a1.5 1.5 0 0 1 3 0V11m0-3.5a1.5 1.5 0 0 1 3 0V14a6 6 0 0 1-6 6c-3 0-4.2-1.4-5.6-3.8L4 13.4a1.4 1.4 0 0 1 2.3-1.6L8 14',
  throw: 'M5 19c1-6 5-11 10-12m0 0-4-2m4 2-2 4M18 17a2 2 0 1 0 0 .1',
  box: 'M12 3l8 4.5v9L12 21l-8-4.5v-9zM4 7.5l8 4.5 8-4.5M12 12v9',
  sphere: 'M12 3a9 9 0 1 0 .1 0M3.5 12c3 2.6 14 2.6 17 0',
  capsule: 'M8 8a4 4 0 0 1 8 0v8a4 4 0 0 1-8 0zM8 12h8',
  explode: 'M12 2l2 6 5-3-2 5.5 5 2.5-5.5 1.500L18 20l-5-3-1 5-2-5-5 2 2-5-5-1.500 5-2.500L5 5l5 3z',
  delete: 'M4 7h16M9 7V4h6v3M6 7l1 13h10l1-13M10 11v5M14 11v5',
  drive: 'M12 3a9 9 0 1 0 .1 0M12 10a2 2 0 1 0 .1 0M3.500 10.500 10 11.500M20.500 10.500 14 11.500M12 14v7',
  cut: 'M6 4a2.500 2.500 0 1 0 .1 0M6 15a2.500 2.500 0 1 0 .1 0M8 8l12 9M8 16 20 7',
  worlds: 'M12 3a9 9 0 1 0 .1 0M3 12h18M12 3c-5 5-5 13 0 18M12 3c5 5 5 13 0 18',
  stats: 'M4 20h16M7 16v-4M12 16V5M17 16V9',
  debug: 'M12 7a5 5 0 0 1 5 5v2a5 5 0 0 1-10 0v-2a5 5 0 0 1 5-5zM9 4l1.500 3M15 4l-1.500 3M7 12H3M21 12h-4M7 16l-3 2M17 16l3 2',
  events: 'M5 6h2M5 12h2M5 18h2M10 6h9M10 12h9M10 18h9',
  help: 'M12 3a9 9 0 1 0 .1 0M9.500 9.500a2.500 2.500 0 1 1 3.500 2.300c-.700.300-1 .800-1 1.700M12 16.500v.1',
  fit: 'M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5',
  theme: 'M12 3a9 9 0 1 0 .1 0M12 3v18a9 9 0 0 0 0-18z',
  menu: 'M4 7h16M4 12h16M4 17h16',
  inspect: 'M10.500 4a6.500 6.500 0 1 0 .1 0M15.300 15.300 21 21M10.500 8v5M8 10.500h5',
  plot: 'M4 4v16h16M7 14c2-6 4-6 6-2s4 2 6-5',
  time: 'M12 4a8.500 8.500 0 1 0 .1 0M12 8v5l3.500 2M9 2h6',
  build: 'M4 20l9-9M11 9l4 4 5-5-4-4zM4 20h4',
  joint: 'M7 15a3 3 0 1 0 .1 0M17 3a3 3 0 1 0 .1 0M9.200 15.800 14.900 8.200',
  close: 'M6 6l12 12M18 6 6 18',
  players: 'M9 5a3.200 3.200 0 1 0 .1 0M3 20c0-4 2.500-6 6-6s6 2 6 6M16 5.500a3 3 0 0 1 0 5.800M17.500 14.300c2.300.6 3.500 2.500 3.500 5.700',
  chat: 'M4 5h16v11H10l-4 4v-4H4zM8 9h8M8 12h5',
  share: 'M14 4h6v6M20 4l-8 8M10 5H5v14h14v-5',
  room: 'M12 3l7 3v5c0 5-3 8-7 10-4-2-7-5-7-10V6zM9 12l2 2 4-4',
  edit: 'M4 20l1-5L16 4l4 4L9 19zM13 7l4 4',
  more: 'M5 11.500a.6.6 0 1 0 .1 0M12 11.500a.6.6 0 1 0 .1 0M19 11.500a.6.6 0 1 0 .1 0',
} as const;

export type IconName = keyof typeof PATHS;

export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 24 24');
  svg.setAttribute('aria-hidden', 'true');
  svg.classList.add('icon');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', PATHS[name]);
  svg.append(path);
  return svg;
}

/** A button with an icon; `label` is its accessible name. */
export function iconButton(name: IconName, label: string, text = ''): HTMLButtonElement {
  const button = document.createElement('button');
  button.type = 'button';
  button.append(icon(name));
  if (text) {
    const span = document.createElement('span');
    span.textContent = text;
    button.append(span);
  }
  button.setAttribute('aria-label', label);
  return button;
}
