// Tests the viewer in headless Chromium against a real server: joining, dragging, throwing, shapes of
// every kind, module renderers, picking by the server, the debug view, events, prediction over a slow
// network, recordings, resuming after a server failure, dragging and cutting a rope, controlling a car, a
// character and a boat, two players in one world, the lobby, the sandbox tools, rooms, every tool in two
// browsers, and the acceptance of its layout; and the example of the SDK.
// Usage: node viewer/e2e/viewer.mjs SERVER_BINARY [--screenshot FILE]
// FILE shows the sandbox, FILE-shapes the debug view of a world of shapes. The exit status is 1 if a
// test fails.

import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, existsSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { testAcceptance } from './acceptance.mjs';
import { CHROMIUM_FLAGS, setName } from './chromium.mjs';
import { testControl } from './control.mjs';
import { testDeformables } from './deformables.mjs';
import { testMonitor } from './monitor.mjs';
import { testPeople } from './people.mjs';
import { testPrediction } from './prediction.mjs';
import { testRecording } from './recording.mjs';
import { testResume } from './resume.mjs';
import { testRoom } from './room.mjs';
import { testSandbox } from './sandbox.mjs';
import { testSdkExample } from './sdk_example.mjs';
import { shapesScene } from './shapes_scene.mjs';
import { testTools } from './tools.mjs';

const [server, ...rest] = process.argv.slice(2);
if (!server || !existsSync(server)) {
  console.error('usage: node viewer/e2e/viewer.mjs SERVER_BINARY [--screenshot FILE]');
  process.exit(2);
}
const screenshot = rest[0] === '--screenshot' ? rest[1] : undefined;
const webRoot = fileURLToPath(new URL('../../dist', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'jostle-e2e-'));
const portFile = join(folder, 'ports.json');

// Long enough for a busy machine with software rendering, where one frame can take 1 s.
const TIMEOUT_S = 60;

async function until(what, check) {
  const end = Date.now() + TIMEOUT_S * 1000;
  for (;;) {
    const value = await check();
    if (value) return value;
    if (Date.now() > end) throw new Error(`timeout after ${TIMEOUT_S} s: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

let passed = 0;
function expect(condition, what) {
  if (!condition) throw new Error(`expectation failed: ${what}`);
  passed++;
  console.log(`  ok: ${what}`);
}

const scenes = ['sandbox', 'hovercraft', 'race_track', 'parkour'];
const options = { '--listen': '127.0.0.1:0', '--http': '127.0.0.1:0', '--admin': '127.0.0.1:0', '--web-root': webRoot, '--port-file': portFile };
// A step may take long on a busy machine, which is not tested here.
const limits = ['tick.step_seconds_max', 'scene.first_step_seconds_max'].flatMap((limit) => ['--set', `${limit}=${TIMEOUT_S}`]);
const serverProcess = spawn(server, [...scenes.flatMap((scene) => ['--scene', scene]), ...Object.entries(options).flat(), ...limits], {
  stdio: ['ignore', 'inherit', 'inherit'],
});
let browser;
let status = 0;
try {
  const ports = await until('the server writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: CHROMIUM_FLAGS });
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  page.setDefaultTimeout(TIMEOUT_S * 1000);
  await setName(page);
  const post = (path, message) =>
    fetch(`http://127.0.0.1:${ports.http}${path}`, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify(message),
    });
  const takeScreenshot = (what) => page.screenshot({ path: screenshot.replace(/(\.\w+)?$/, `-${what}$1`), timeout: 40_000 });
  const down = { origin: { y: 50 }, motion: { y: -100 } };
  const servesQueries = (await post('/api/query/CastRays', { rays: [down] })).status === 200;
  if (!servesQueries) console.log('  skipped: this server does not serve /api/query; picking by the server, the debug view and events are not tested');
  const created = await post('/api/worlds', { name: 'shapes', scene: shapesScene });
  const servesShapes = created.ok;
  if (!servesShapes) console.log(`  skipped: this server rejects the world of shapes: ${await created.text()}`);

  const errors = [];
  let debugRequests = 0;
  let rayResponses = 0;
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    const expected = !servesQueries && message.location().url.includes('/api/query/');
    if (message.type() === 'error' && !expected) errors.push(message.text());
  });
  page.on('response', (response) => response.url().endsWith('/api/query/CastRays') && response.status() === 200 && rayResponses++);
  page.on('request', (request) => request.url().endsWith('/api/query/Debug') && debugRequests++);
  // Low quality, because software rendering would use all of the time.
  await page.goto(`http://127.0.0.1:${ports.http}/?quality=low`);

  await until('the viewer plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
  expect((await page.evaluate(() => window.jostle.entityCount)) > 200, 'the sandbox has more than 200 bodies');
  await until('statistics are received', () => page.evaluate(() => window.jostle.stats?.bodies > 200));
  expect((await page.locator('#stats .plot').count()) === 7, 'the statistics panel has seven plots');

  // On a busy machine the tower may be rendered long after the first snapshot.
  await until('the tower is rendered', () =>
    page.evaluate(() => {
      const towers = window.jostle.dynamicBodies().filter((id) => window.jostle.entityName(id) === 'tower');
      return towers.length > 0 && towers.every((id) => window.jostle.poseOf(id));
    }),
  );
  // The top box of the tower, which nothing hides.
  const box = await page.evaluate(() => {
    const towers = window.jostle.dynamicBodies().filter((id) => window.jostle.entityName(id) === 'tower');
    return towers.sort((a, b) => window.jostle.poseOf(b)[1] - window.jostle.poseOf(a)[1])[0];
  });
  const initial = await page.evaluate((id) => window.jostle.poseOf(id), box);
  const at = await page.evaluate((id) => window.jostle.screenPosition(id), box);
  await page.mouse.move(at.x, at.y);
  const readout = await until('the readout describes the body under the pointer', () => page.locator('#readout:not([hidden])').textContent());
  expect(readout.startsWith(`tower · id ${box} · box · `), `the readout shows ${readout}`);
  if (servesQueries) {
    await until('the server responds to the ray of the pointer', () => rayResponses > 0);
    const [responsesBefore, startMs] = [rayResponses, Date.now()];
    for (let i = 0; i < 60; i++) await page.mouse.move(at.x + (i % 3) - 1, at.y);
    await new Promise((resolve) => setTimeout(resolve, 1000));
    await until('the server responds to a ray of the moves', () => rayResponses > responsesBefore);
    const perSecond = (rayResponses - responsesBefore) / ((Date.now() - startMs) / 1000);
    expect(perSecond <= 11, `60 pointer moves cause ${perSecond.toFixed(1)} ray queries per second`);
    await page.mouse.move(at.x, at.y);
  }
  await page.mouse.down();
  for (let i = 1; i <= 20; i++) {
    await page.mouse.move(at.x - 10 * i, at.y - 4 * i);
    await new Promise((resolve) => setTimeout(resolve, 40));
  }
  const moved = await until('the dragged box moves more than 1 m', async () => {
    const pose = await page.evaluate((id) => window.jostle.poseOf(id), box);
    const distance = Math.hypot(pose[0] - initial[0], pose[1] - initial[1], pose[2] - initial[2]);
    return distance > 1 ? distance : 0;
  });
  await page.mouse.up();
  expect(moved > 1, `dragging moves the box ${moved.toFixed(2)} m on the server`);

  const count = await page.evaluate(() => window.jostle.entityCount);
  await page.keyboard.press('2');
  await page.mouse.click(640, 380);
  await until('the thrown ball exists', () => page.evaluate((n) => window.jostle.entityCount === n + 1, count));
  expect(true, 'throwing a ball adds one body');

  await page.keyboard.press('w');
  await until('the list of worlds is shown', () => page.locator('#worlds .world').count());
  expect((await page.locator('#worlds .scene').count()) >= 5, 'the worlds panel lists the scenes');
  await page.locator('#worlds .scene', { hasText: 'billiards' }).click();
  await until('the new world is joined', () => page.evaluate(() => window.jostle.state === 'playing' && window.jostle.entityCount < 60));
  expect(true, 'a world created from a scene is joined');
  await page.keyboard.press('w');
  await page.locator('#worlds .world', { hasText: 'sandbox' }).locator('button', { hasText: 'Join' }).click();
  await until('the sandbox is joined again', () => page.evaluate(() => window.jostle.entityCount > 200 && window.jostle.snapshots > 30));

  if (servesShapes) {
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=low&world=shapes`);
    await until('the world of shapes plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
    const parts = await page.evaluate(() => window.jostle.partCounts());
    const expected = { field: 1, plane: 1, mesh: 1, cylinder: 10, cone: 5, hull: 5, sphere: 5, box: 6, tube: 4, cap: 8 };
    const same = Object.keys({ ...expected, ...parts }).every((kind) => parts[kind] === expected[kind]);
    expect(same, `every kind of shape is rendered: ${JSON.stringify(parts)}`);
  }
  await page.goto(`http://127.0.0.1:${ports.http}/?quality=low&world=hovercraft`);
  await until('the hovercraft plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
  await until('the four thrusters are rendered', () => page.evaluate(() => window.jostle.moduleLineCount() === 4));
  expect(true, 'the module state of the hovercraft is rendered');
  if (screenshot) await takeScreenshot('hovercraft');

  if (servesShapes && servesQueries) {
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=low&world=shapes`);
    await until('the world of shapes plays again', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 30));
    expect(debugRequests === 0, 'no debug queries while the debug view is off');
    await page.keyboard.press('d');
    for (const toggle of ['contacts', 'joints', 'islands']) await page.locator(`#debug input[name=${toggle}]`).check();
    const note = await until('the debug view summarizes the counts', async () => {
      const text = await page.locator('#debug .note').textContent();
      return /[1-9]\d* contacts?, [1-9]\d* islands?, 4 joints/.test(text) && text;
    });
    expect(true, `the debug view shows ${note}`);
    const requestsBefore = debugRequests;
    const since = Date.now();
    await new Promise((resolve) => setTimeout(resolve, 1200));
    await until('the debug view repeats its query', () => debugRequests > requestsBefore + 1);
    const perSecond = (debugRequests - requestsBefore) / ((Date.now() - since) / 1000);
    expect(perSecond <= 6, `the debug view queries ${perSecond.toFixed(1)} times per second`);
    for (const toggle of ['contacts', 'joints', 'islands']) await page.locator(`#debug input[name=${toggle}]`).uncheck();
    await until('the queries stop', async () => {
      const last = debugRequests;
      await new Promise((resolve) => setTimeout(resolve, 700));
      return debugRequests === last;
    });
    expect(true, 'no debug queries after it is turned off');
    await page.keyboard.press('d');

    await page.keyboard.press('e');
    await until('the world is rejoined with events', () => page.evaluate(() => window.jostle.state === 'playing' && window.jostle.snapshots > 0));
    await page.keyboard.press('2');
    const description = await until('a thrown ball hits a body', async () => {
      await page.mouse.click(640, 400);
      await new Promise((resolve) => setTimeout(resolve, 300));
      return (await page.locator('#events li').allTextContents()).find((line) => / hit .* at \d+\.\d m\/s/.test(line));
    });
    expect(true, `the events panel shows ${description}`);
    await page.keyboard.press('e');
  }

  await testSdkExample({ url: `http://127.0.0.1:${ports.http}`, expect });
  await testPrediction({ page, url: `http://127.0.0.1:${ports.http}`, until, expect });
  await testRecording({ page, url: `http://127.0.0.1:${ports.http}`, until, expect, takeScreenshot: screenshot && takeScreenshot });

  // On a page of its own, because a stopped server causes console errors.
  const otherPage = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  otherPage.setDefaultTimeout(TIMEOUT_S * 1000);
  await setName(otherPage);
  const takeOtherScreenshot = (what) => otherPage.screenshot({ path: screenshot.replace(/(\.\w+)?$/, `-${what}$1`), timeout: 40_000 });
  await testResume({ page: otherPage, server, folder, webRoot, until, expect, takeScreenshot: screenshot && takeOtherScreenshot });
  await otherPage.close();

  const takePeople = async (one, what) => screenshot && void (await one.screenshot({ path: screenshot.replace(/(\.\w+)?$/, `-${what}$1`), timeout: 60_000 }));
  await testPeople({ browser, url: `http://127.0.0.1:${ports.http}`, post, until, expect, take: takePeople });

  // Created last, because its waves cost the server more than all other worlds.
  const swings = await post('/api/worlds', { name: 'swings', sceneName: 'swings' });
  expect(swings.ok, `the playground is created: ${swings.status}`);
  await testDeformables({ page, url: `http://127.0.0.1:${ports.http}`, until, expect, takeScreenshot: screenshot && takeScreenshot });
  const harbour = await post('/api/worlds', { name: 'harbour', sceneName: 'harbour' });
  expect(harbour.ok, `the harbour is created: ${harbour.status}`);
  await testControl({ page, url: `http://127.0.0.1:${ports.http}`, until, expect, takeScreenshot: screenshot && takeScreenshot });
  await testMonitor({ browser, page, url: `http://127.0.0.1:${ports.http}`, until, expect, takeScreenshot: screenshot?.replace(/(\.\w+)?$/, '-monitor$1') });

  const nameOf = screenshot && ((what) => screenshot.replace(/(\.\w+)?$/, `-${what}$1`));
  await testSandbox({ browser, url: `http://127.0.0.1:${ports.http}`, post, until, expect, screenshot: nameOf });
  await testRoom({ browser, server, folder, webRoot, until, expect, screenshot: nameOf });
  await testTools({ browser, url: `http://127.0.0.1:${ports.http}`, post, until, expect });
  // Takes four minutes and measures times: JOSTLE_ACCEPTANCE=1 on a machine that does nothing else.
  if (process.env.JOSTLE_ACCEPTANCE) await testAcceptance({ browser, url: `http://127.0.0.1:${ports.http}`, post, until, expect, screenshot: nameOf });

  expect((await page.evaluate(() => window.jostle.decodeErrors)) === 0, 'every snapshot is decoded with a matching CRC');
  expect(errors.length === 0, `the page has no errors ${errors.join('; ')}`);
  if (screenshot) {
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=medium`);
    await until('medium quality is rendered', () => page.evaluate(() => window.jostle?.snapshots > 100));
    await page.screenshot({ path: screenshot, timeout: 40_000 });
    console.log(`  wrote ${screenshot}`);
    if (servesShapes) {
      await page.goto(`http://127.0.0.1:${ports.http}/?quality=high&world=shapes`);
      await until('the shapes are rendered in high quality', () => page.evaluate(() => window.jostle?.snapshots > 100));
      const shapesScreenshot = screenshot.replace(/(\.\w+)?$/, '-shapes$1');
      if (servesQueries) {
        await page.keyboard.press('d');
        for (const toggle of ['contacts', 'joints', 'bounds']) await page.locator(`#debug input[name=${toggle}]`).check();
        await until('contacts are shown', async () => /contact/.test(await page.locator('#debug .note').textContent()));
      }
      await new Promise((resolve) => setTimeout(resolve, 1500));
      await page.screenshot({ path: shapesScreenshot, timeout: 40_000 });
      console.log(`  wrote ${shapesScreenshot}`);
    }
  }
} catch (error) {
  console.error(`FAILED: ${error.message}`);
  status = 1;
} finally {
  await browser?.close();
  serverProcess.kill('SIGTERM');
  await new Promise((resolve) => (serverProcess.exitCode !== null ? resolve() : serverProcess.on('exit', resolve)));
  rmSync(folder, { recursive: true, force: true });
}
console.log(`viewer: ${passed} passed, ${status} failed`);
process.exit(status);
