// Prints the figures of the viewer, one per command, and exits with 1 if a figure misses its limit. Run it on a
// machine that does nothing else.
// Usage: node viewer/e2e/figures.mjs SERVER_BINARY FIGURE
//   script-time   script per rendered frame with 2,000 moving bodies: at most 3 ms at the 90th percentile
//   input-frames  rendered frames from a click to its visible effect: at most 2
//   first-view    script of the first view with gzip and brotli: at most 350 kB
//   axe           violations that axe-core finds in each panel, wide and narrow, in both themes: none
//   lighthouse    accessibility score: at least 95; installs lighthouse in a temporary folder, unless
//                 JOSTLE_LIGHTHOUSE names a folder in which it is installed

import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import { BODIES, FRAMES_MAX, measureInput, measureScript, movingScene, SCRIPT_MS_MAX } from './acceptance.mjs';
import { CHROMIUM_FLAGS, setName } from './chromium.mjs';
import { workshop } from './sandbox.mjs';

const TIMEOUT_S = 90;
const FIRST_VIEW_MAX = 350e3; // bytes, compressed
const ACCESSIBILITY_MIN = 95;
const INPUTS = 10; // measured
const [server, figure] = process.argv.slice(2);
const webRoot = fileURLToPath(new URL('../../dist', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'jostle-figures-'));

async function until(what, check) {
  const end = Date.now() + TIMEOUT_S * 1000;
  for (;;) {
    const value = await check();
    if (value) return value;
    if (Date.now() > end) throw new Error(`timeout after ${TIMEOUT_S} s: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

let failed = false;
function print(text, isGood) {
  console.log(`${text}${isGood ? '' : '  MISSED'}`);
  failed ||= !isGood;
}

async function scriptTime({ page, url, post }) {
  await post('/api/worlds', { name: 'moving', scene: movingScene });
  const { frames, median, p90 } = await measureScript({ page, url, until });
  print(`script per frame, ${BODIES} moving bodies, ${frames} frames: median ${median.toFixed(2)} ms, 90th percentile ${p90.toFixed(2)} ms (at most ${SCRIPT_MS_MAX} ms)`, p90 <= SCRIPT_MS_MAX);
}

async function inputFrames({ page, url }) {
  const measured = [];
  for (let k = 0; k < INPUTS; k++) measured.push(await measureInput({ page, url, until }));
  const local = measured.map((one) => one.local).sort((a, b) => a - b);
  const remote = measured.map((one) => one.server).sort((a, b) => a - b);
  print(`frames from a click to its visible effect, ${INPUTS} clicks: ${local.join(' ')} (at most ${FRAMES_MAX}); to the body of the server: ${remote.join(' ')}`, local[0] > 0 && local.at(-1) <= FRAMES_MAX);
}

function firstView() {
  const html = readFileSync(join(webRoot, 'index.html'), 'utf8');
  const scripts = [...html.matchAll(/(?:src|href)="\.\/(assets\/[^"]+\.js)"/g)].map(([, name]) => readFileSync(join(webRoot, name)));
  const bytes = (compress) => scripts.reduce((sum, script) => sum + compress(script).length, 0);
  const [plain, gzip, brotli] = [(script) => script, (script) => gzipSync(script, { level: 9 }), (script) => brotliCompressSync(script)].map(bytes);
  print(`script of the first view: ${scripts.length} files, ${(plain / 1000).toFixed(0)} kB, with gzip ${(gzip / 1000).toFixed(0)} kB, with brotli ${(brotli / 1000).toFixed(0)} kB (at most ${FIRST_VIEW_MAX / 1000} kB)`, scripts.length > 0 && gzip <= FIRST_VIEW_MAX);
}

async function axe({ browser, url, post }) {
  const source = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
  await post('/api/worlds', { name: 'workshop', scene: workshop({ title: 'Workshop', initialRole: 'builder', timelineSeconds: 60 }) });
  for (const [size, options] of [['1440 x 900', { viewport: { width: 1440, height: 900 } }], ['390 x 844', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }]]) {
    const page = await browser.newPage(options);
    page.setDefaultTimeout(1000 * TIMEOUT_S);
    await setName(page);
    await page.goto(`${url}/?world=workshop&quality=low`);
    await until('the workshop plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.room !== undefined && window.jostle.snapshots > 20));
    await page.evaluate(source);
    const panels = await page.locator('#panel-buttons [aria-controls]').evaluateAll((buttons) => buttons.map((button) => button.getAttribute('aria-controls')));
    for (const panel of panels) {
      await page.evaluate((id) => {
        for (const open of document.querySelectorAll('#panel-buttons [aria-expanded=true]')) open.click();
        document.querySelector(`#panel-buttons [aria-controls=${id}]`).click();
      }, panel);
      await until(`the panel ${panel} is loaded`, () => page.locator(`#${panel} .body > div`).count());
      await page.waitForTimeout(500);
      for (const theme of ['light', 'dark']) {
        await page.evaluate((wanted) => (document.documentElement.dataset.theme = wanted), theme);
        const violations = await page.evaluate(async () => (await window.axe.run(document, { resultTypes: ['violations'] })).violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 100)}`));
        print(`axe-core, ${size}, ${panel}, ${theme}: ${violations.length} violations ${violations.join('; ')}`, violations.length === 0);
      }
    }
    await page.close();
  }
}

async function lighthouse({ url }) {
  let home = process.env.JOSTLE_LIGHTHOUSE;
  if (!home) {
    home = join(folder, 'lighthouse');
    execFileSync('npm', ['install', '--prefix', home, '--no-audit', '--no-fund', '--loglevel=error', 'lighthouse@12'], { stdio: 'inherit', env: { ...process.env, PUPPETEER_SKIP_DOWNLOAD: '1' } });
  }
  const { default: run } = await import(pathToFileURL(join(home, 'node_modules/lighthouse/core/index.js')).href);
  const port = 9333;
  const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: [...CHROMIUM_FLAGS, `--remote-debugging-port=${port}`] });
  try {
    for (const path of ['/?quality=low', '/monitor.html'])
      for (const formFactor of ['desktop', 'mobile']) {
        const screenEmulation = formFactor === 'desktop' ? { mobile: false, width: 1440, height: 900, deviceScaleFactor: 1 } : { mobile: true, width: 390, height: 844, deviceScaleFactor: 1 };
        const { lhr } = await run(`${url}${path}`, { port, onlyCategories: ['accessibility'], formFactor, screenEmulation, maxWaitForLoad: 45_000, logLevel: 'error' });
        const score = Math.round(100 * lhr.categories.accessibility.score);
        const refused = lhr.categories.accessibility.auditRefs.map(({ id }) => lhr.audits[id]).filter(({ score }) => score !== null && score < 1).map(({ id }) => id);
        print(`lighthouse ${lhr.lighthouseVersion}, ${formFactor}, ${path}: accessibility ${score} (at least ${ACCESSIBILITY_MIN}) ${refused.join(' ')}`, score >= ACCESSIBILITY_MIN);
      }
  } finally {
    await browser.close();
  }
}

const FIGURES = { 'script-time': scriptTime, 'input-frames': inputFrames, 'first-view': firstView, axe, lighthouse };
if (!server || !existsSync(server) || !FIGURES[figure]) {
  console.error(`usage: node viewer/e2e/figures.mjs SERVER_BINARY FIGURE\nFIGURE is ${Object.keys(FIGURES).join(', ')}`);
  process.exit(2);
}
const portFile = join(folder, 'ports.json');
const options = { '--scene': 'sandbox', '--listen': '127.0.0.1:0', '--http': '127.0.0.1:0', '--admin': '127.0.0.1:0', '--web-root': webRoot, '--port-file': portFile, '--log-level': 'error' };
const child = spawn(server, Object.entries(options).flat(), { stdio: ['ignore', 'ignore', 'inherit'] });
let browser;
try {
  const ports = await until('the server writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
  const url = `http://127.0.0.1:${ports.http}`;
  const post = (path, message) => fetch(url + path, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(message) });
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: CHROMIUM_FLAGS });
  const page = await browser.newPage();
  page.setDefaultTimeout(1000 * TIMEOUT_S);
  await setName(page);
  await FIGURES[figure]({ browser, page, url, post });
} catch (error) {
  print(`${figure}: ${error.message}`, false);
} finally {
  await browser?.close();
  child.kill('SIGTERM');
  rmSync(folder, { recursive: true, force: true });
}
process.exit(failed ? 1 : 0);
