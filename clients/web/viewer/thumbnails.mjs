// Writes the thumbnails of the catalogue scenes for the lobby: public/thumbnails/SCENE.webp, drawn by the
// viewer itself after a few seconds of simulation. The thumbnails are committed; run it again after a scene
// or the look of the viewer changed, then build.
// Usage: npm run thumbnails -- SERVER_BINARY [SCENE...]

import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { CHROMIUM_FLAGS, setName } from './e2e/chromium.mjs';

const WIDTH = 240;
const HEIGHT = 150;
const SCALE = 2; // drawn larger, then reduced
const SECONDS = 2.5; // of simulation
const QUALITY = 0.72;

const [server, ...only] = process.argv.slice(2);
if (!server || !existsSync(server)) {
  console.error('usage: npm run thumbnails -- SERVER_BINARY [SCENE...]');
  process.exit(2);
}
const folder = fileURLToPath(new URL('public/thumbnails/', import.meta.url));
mkdirSync(folder, { recursive: true });
const work = mkdtempSync(join(tmpdir(), 'jostle-thumbnails-'));
const portFile = join(work, 'ports.json');
const webRoot = fileURLToPath(new URL('../dist', import.meta.url));
const child = spawn(server, ['--scene', 'stack', '--listen', '127.0.0.1:0', '--http', '127.0.0.1:0', '--admin', '127.0.0.1:0', '--web-root', webRoot, '--port-file', portFile, '--set', 'tick.step_seconds_max=60', '--set', 'scene.first_step_seconds_max=60'], { stdio: 'ignore' });
const until = async (what, check, seconds = 120) => {
  for (const end = Date.now() + seconds * 1000; Date.now() < end; await new Promise((resolve) => setTimeout(resolve, 50))) {
    const value = await check();
    if (value) return value;
  }
  throw new Error(`timeout after ${seconds} s: ${what}`);
};

let browser;
try {
  const { http } = await until('the server writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
  const url = `http://127.0.0.1:${http}`;
  const { scenes } = await (await fetch(`${url}/api/worlds`)).json();
  const known = scenes.map(({ name }) => name);
  const names = only.length > 0 ? only.filter((name) => known.includes(name)) : known.filter((name) => !name.startsWith('bench_') && !/_\d+$/.test(name));
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: CHROMIUM_FLAGS });
  const page = await browser.newPage({ viewport: { width: SCALE * WIDTH, height: SCALE * HEIGHT }, colorScheme: 'light' });
  page.setDefaultTimeout(120_000);
  await setName(page);
  for (const name of names) {
    const created = await fetch(`${url}/api/worlds`, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ name, sceneName: name }) });
    const { world, message } = await created.json();
    if (!created.ok && name !== 'stack') {
      console.error(`${name}: ${message}`);
      continue;
    }
    await page.goto(`${url}/?quality=medium&world=${name}`);
    await page.addStyleTag({ content: 'body > :not(main), main > :not(#view) { display: none !important; }' });
    const hz = world?.hz ?? 60;
    await until(`${name} plays`, () => page.evaluate((ticks) => window.jostle?.state === 'playing' && window.jostle.tick > ticks, SECONDS * hz));
    await page.keyboard.press('f'); // shows the whole scene
    await page.waitForTimeout(1500);
    const png = (await page.screenshot({ timeout: 120_000 })).toString('base64');
    const webp = await page.evaluate(
      async ({ data, width, height, quality }) => {
        const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (byte) => byte.charCodeAt(0))]), { resizeWidth: width, resizeHeight: height, resizeQuality: 'high' });
        const canvas = document.createElement('canvas');
        Object.assign(canvas, { width, height });
        canvas.getContext('2d').drawImage(bitmap, 0, 0);
        return canvas.toDataURL('image/webp', quality).split(',')[1];
      },
      { data: png, width: WIDTH, height: HEIGHT, quality: QUALITY },
    );
    const bytes = Buffer.from(webp, 'base64');
    writeFileSync(join(folder, `${name}.webp`), bytes);
    console.log(`${name}: ${bytes.length} bytes`);
    if (world) await fetch(`${url}/api/worlds/${world.id}`, { method: 'DELETE' });
  }
} finally {
  await browser?.close();
  child.kill('SIGTERM');
  rmSync(work, { recursive: true, force: true });
}
