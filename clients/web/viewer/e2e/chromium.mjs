// How the browser tests run Chromium: without a GPU and without background traffic.

export const CHROMIUM_FLAGS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--ignore-gpu-blocklist',
  '--enable-unsafe-swiftshader',
  '--use-gl=angle',
  '--use-angle=swiftshader',
];

/** Gives the user of a page or context a name, so that the viewer does not ask for one. */
export const setName = (target, name = 'tester') => target.addInitScript((value) => localStorage.setItem('jostle-name', value), name);
