// The viewer in a real headless Chromium against a real server: joins, drags a box and sees it move, throws a ball and sees
// one more body, draws shapes of every kind and a module's lines, asks what is under the pointer, looks at the solver, reads events,
// foresees what it drags over a slow link, plays a recording, comes back to a server that was killed, drives a car, a character
// and a boat.
// Usage: node viewer/e2e/viewer.mjs SERVER_BINARY [--screenshot FILE]; FILE shows the sandbox, FILE-shapes the debug view of a world of
// shapes. Exit status 1 when something does not hold.

import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, existsSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { playing } from './playing.mjs';
import { predicting } from './predicting.mjs';
import { replaying } from './replaying.mjs';
import { restarting } from './restarting.mjs';
import { shapesScene } from './shapes_scene.mjs';

const CHROMIUM_FLAGS = [
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

const [server, ...rest] = process.argv.slice(2);
if (!server || !existsSync(server)) {
  console.error('usage: node viewer/e2e/viewer.mjs SERVER_BINARY [--screenshot FILE]');
  process.exit(2);
}
const screenshot = rest[0] === '--screenshot' ? rest[1] : undefined;
const webRoot = fileURLToPath(new URL('../../dist', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'jostle-e2e-'));
const portFile = join(folder, 'ports.json');

// Long enough for a busy machine that draws in software, where one picture can take a second.
const PATIENCE_S = 60;

async function until(what, check) {
  const end = Date.now() + PATIENCE_S * 1000;
  for (;;) {
    const value = await check();
    if (value) return value;
    if (Date.now() > end) throw new Error(`not within ${PATIENCE_S} s: ${what}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

let passed = 0;
function expect(holds, what) {
  if (!holds) throw new Error(`does not hold: ${what}`);
  passed++;
  console.log(`  ok: ${what}`);
}

const scenes = ['sandbox', 'hovercraft', 'race_track', 'parkour'];
const ways = { '--listen': '127.0.0.1:0', '--http': '127.0.0.1:0', '--admin': '127.0.0.1:0', '--web-root': webRoot, '--port-file': portFile };
// On a busy machine a step may take long: that is not what is looked at here.
const patience = ['tick.step_seconds_max', 'scene.first_step_seconds_max'].flatMap((limit) => ['--set', `${limit}=${PATIENCE_S}`]);
const process_ = spawn(server, [...scenes.flatMap((scene) => ['--scene', scene]), ...Object.entries(ways).flat(), ...patience], {
  stdio: ['ignore', 'inherit', 'inherit'],
});
let browser;
let status = 0;
try {
  const ports = await until('the server writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: CHROMIUM_FLAGS });
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  page.setDefaultTimeout(PATIENCE_S * 1000);
  const post = (path, message) =>
    fetch(`http://127.0.0.1:${ports.http}${path}`, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify(message),
    });
  const shoot = (what) => page.screenshot({ path: screenshot.replace(/(\.\w+)?$/, `-${what}$1`), timeout: 40_000 });
  const down = { origin: { y: 50 }, motion: { y: -100 } };
  const servesQueries = (await post('/api/query/CastRays', { rays: [down] })).status === 200;
  if (!servesQueries) console.log('  skipped: this server answers no /api/query; picking by it, the debug view and events are not checked');
  const made = await post('/api/worlds', { name: 'shapes', scene: shapesScene });
  const servesShapes = made.ok;
  if (!servesShapes) console.log(`  skipped: this server does not take the world of shapes: ${await made.text()}`);

  const errors = [];
  let debugQuestions = 0;
  let raysAnswered = 0;
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    const expected = !servesQueries && message.location().url.includes('/api/query/');
    if (message.type() === 'error' && !expected) errors.push(message.text());
  });
  page.on('response', (response) => response.url().endsWith('/api/query/CastRays') && response.status() === 200 && raysAnswered++);
  page.on('request', (request) => request.url().endsWith('/api/query/Debug') && debugQuestions++);
  // Drawn in software here: few pixels, or the page would have no time for anything else.
  await page.goto(`http://127.0.0.1:${ports.http}/?quality=low`);

  await until('the viewer plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
  expect((await page.evaluate(() => window.jostle.entities)) > 200, 'the sandbox has more than 200 bodies');
  await until('statistics arrive', () => page.evaluate(() => window.jostle.stats?.bodies > 200));
  expect((await page.locator('#stats .plot').count()) === 7, 'seven live plots');

  // Snapshots come before pictures: on a busy machine the first picture of the tower may be a while.
  await until('the tower is drawn', () =>
    page.evaluate(() => {
      const towers = window.jostle.loose().filter((id) => window.jostle.nameOf(id) === 'tower');
      return towers.length > 0 && towers.every((id) => window.jostle.pose(id));
    }),
  );
  // The top box of the tower: alone against the sky, so nothing hides it.
  const box = await page.evaluate(() => {
    const towers = window.jostle.loose().filter((id) => window.jostle.nameOf(id) === 'tower');
    return towers.sort((a, b) => window.jostle.pose(b)[1] - window.jostle.pose(a)[1])[0];
  });
  const before = await page.evaluate((id) => window.jostle.pose(id), box);
  const at = await page.evaluate((id) => window.jostle.screen(id), box);
  await page.mouse.move(at.x, at.y);
  const readout = await until('the line on what is under the pointer', () => page.locator('#readout:not([hidden])').textContent());
  expect(readout.startsWith(`tower · id ${box} · box · `), `under the pointer: ${readout}`);
  if (servesQueries) {
    await until('the server answers the ray of the pointer', () => raysAnswered > 0);
    const [before, began] = [raysAnswered, Date.now()];
    for (let i = 0; i < 60; i++) await page.mouse.move(at.x + (i % 3) - 1, at.y);
    await new Promise((done) => setTimeout(done, 1000));
    await until('the server answers a ray of the moves', () => raysAnswered > before);
    const perSecond = (raysAnswered - before) / ((Date.now() - began) / 1000);
    expect(perSecond <= 11, `60 moves of the pointer: ${perSecond.toFixed(1)} rays answered a second`);
    await page.mouse.move(at.x, at.y);
  }
  await page.mouse.down();
  for (let i = 1; i <= 20; i++) {
    await page.mouse.move(at.x - 10 * i, at.y - 4 * i);
    await new Promise((done) => setTimeout(done, 40));
  }
  const moved = await until('the dragged box moves more than 1 m', async () => {
    const now = await page.evaluate((id) => window.jostle.pose(id), box);
    const way = Math.hypot(now[0] - before[0], now[1] - before[1], now[2] - before[2]);
    return way > 1 ? way : 0;
  });
  await page.mouse.up();
  expect(moved > 1, `dragging moved the box ${moved.toFixed(2)} m on the server`);

  const count = await page.evaluate(() => window.jostle.entities);
  await page.keyboard.press('2');
  await page.mouse.click(640, 380);
  await until('the thrown ball is there', () => page.evaluate((n) => window.jostle.entities === n + 1, count));
  expect(true, 'throwing a ball made one more body');

  await page.keyboard.press('w');
  await until('the list of worlds', () => page.locator('#worlds .world').count());
  expect((await page.locator('#worlds .scene').count()) >= 5, 'the world picker offers the scenes');
  await page.locator('#worlds .scene', { hasText: 'billiards' }).click();
  await until('the new world is joined', () => page.evaluate(() => window.jostle.state === 'playing' && window.jostle.entities < 60));
  expect(true, 'a world made from a scene is joined');
  await page.keyboard.press('w');
  await page.locator('#worlds .world', { hasText: 'sandbox' }).locator('button', { hasText: 'Join' }).click();
  await until('back in the sandbox', () => page.evaluate(() => window.jostle.entities > 200 && window.jostle.snapshots > 30));

  if (servesShapes) {
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=low&world=shapes`);
    await until('the world of shapes plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
    const parts = await page.evaluate(() => window.jostle.parts());
    const right = { field: 1, plane: 1, mesh: 1, cylinder: 10, cone: 5, hull: 5, sphere: 5, box: 6, tube: 4, cap: 8 };
    const same = Object.keys({ ...right, ...parts }).every((kind) => parts[kind] === right[kind]);
    expect(same, `every shape is drawn as what it is: ${JSON.stringify(parts)}`);
  }
  await page.goto(`http://127.0.0.1:${ports.http}/?quality=low&world=hovercraft`);
  await until('the hovercraft plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
  await until('its four jets are drawn', () => page.evaluate(() => window.jostle.moduleLines() === 4));
  expect(true, "a module's state is drawn: four jets of a hovercraft");
  if (screenshot) await shoot('hovercraft');

  if (servesShapes && servesQueries) {
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=low&world=shapes`);
    await until('the world of shapes plays again', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
    expect(debugQuestions === 0, 'no question for the debug view while it is off');
    await page.keyboard.press('d');
    for (const toggle of ['contacts', 'joints', 'islands']) await page.locator(`#debug input[name=${toggle}]`).check();
    const note = await until('the debug view says what there is', async () => {
      const text = await page.locator('#debug .note').textContent();
      return /[1-9]\d* contacts?, [1-9]\d* islands?, 4 joints/.test(text) && text;
    });
    expect(true, `the debug view shows ${note}`);
    const asked = debugQuestions;
    const since = Date.now();
    await new Promise((done) => setTimeout(done, 1200));
    await until('the debug view asks again and again', () => debugQuestions > asked + 1);
    const perSecond = (debugQuestions - asked) / ((Date.now() - since) / 1000);
    expect(perSecond <= 6, `the debug view asks ${perSecond.toFixed(1)} times a second`);
    for (const toggle of ['contacts', 'joints', 'islands']) await page.locator(`#debug input[name=${toggle}]`).uncheck();
    await until('it asks no longer', async () => {
      const last = debugQuestions;
      await new Promise((done) => setTimeout(done, 700));
      return debugQuestions === last;
    });
    expect(true, 'and no longer once it is off');
    await page.keyboard.press('d');

    await page.keyboard.press('e');
    await until('back in the world with events', () => page.evaluate(() => window.jostle.state === 'playing' && window.jostle.snapshots > 0));
    await page.keyboard.press('2');
    const words = await until('a thrown ball hits something', async () => {
      await page.mouse.click(640, 400);
      await new Promise((done) => setTimeout(done, 300));
      return (await page.locator('#events li').allTextContents()).find((line) => / hit .* at \d+\.\d m\/s/.test(line));
    });
    expect(true, `events in words: ${words}`);
    await page.keyboard.press('e');
  }

  await predicting({ page, url: `http://127.0.0.1:${ports.http}`, until, expect });
  await replaying({ page, url: `http://127.0.0.1:${ports.http}`, until, expect, shoot: screenshot && shoot });

  // Its errors are those of a server that is away.
  const others = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  others.setDefaultTimeout(PATIENCE_S * 1000);
  const shootOthers = (what) => others.screenshot({ path: screenshot.replace(/(\.\w+)?$/, `-${what}$1`), timeout: 40_000 });
  await restarting({ page: others, server, folder, webRoot, until, expect, shoot: screenshot && shootOthers });
  await others.close();

  // Last, and made only now: its waves cost the server more than all the others.
  const harbour = await post('/api/worlds', { name: 'harbour', sceneName: 'harbour' });
  expect(harbour.ok, `a harbour is made: ${harbour.status}`);
  await playing({ page, url: `http://127.0.0.1:${ports.http}`, until, expect, shoot: screenshot && shoot });

  expect((await page.evaluate(() => window.jostle.decodeErrors)) === 0, 'every snapshot decoded with its CRC');
  expect(errors.length === 0, `no error on the page ${errors.join('; ')}`);
  if (screenshot) {
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=medium`);
    await until('a finer picture', () => page.evaluate(() => window.jostle?.snapshots > 100));
    await page.screenshot({ path: screenshot, timeout: 40_000 });
    console.log(`  wrote ${screenshot}`);
    if (servesShapes) {
      await page.goto(`http://127.0.0.1:${ports.http}/?quality=high&world=shapes`);
      await until('the shapes in a finer picture', () => page.evaluate(() => window.jostle?.snapshots > 100));
      const beside = screenshot.replace(/(\.\w+)?$/, '-shapes$1');
      if (servesQueries) {
        await page.keyboard.press('d');
        for (const toggle of ['contacts', 'joints', 'bounds']) await page.locator(`#debug input[name=${toggle}]`).check();
        await until('lines', async () => /contact/.test(await page.locator('#debug .note').textContent()));
      }
      await new Promise((done) => setTimeout(done, 1500));
      await page.screenshot({ path: beside, timeout: 40_000 });
      console.log(`  wrote ${beside}`);
    }
  }
} catch (error) {
  console.error(`FAILED: ${error.message}`);
  status = 1;
} finally {
  await browser?.close();
  process_.kill('SIGTERM');
  await new Promise((done) => (process_.exitCode !== null ? done() : process_.on('exit', done)));
  rmSync(folder, { recursive: true, force: true });
}
console.log(`viewer: ${passed} passed, ${status} failed`);
process.exit(status);
