// The other players: two browsers in one world, a wide page and a phone. Name at the first visit, player
// list, chat and mute, notices, name tags, cursors and grabs of the other, following, the address of the
// page, link and QR code; the lobby with cards, uploads with errors at their line, and downloads.
// Alone: node viewer/e2e/people.mjs SERVER_BINARY [--screenshots FOLDER]

import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import decodeQR from 'qr/decode.js';
import { CHROMIUM_FLAGS } from './chromium.mjs';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const WIDE = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };
const TARGET_MIN = 44; // pixels, on phones
const TIMEOUT_S = 120; // long enough for a busy machine with software rendering
const HOSTILE_NAME = '<img src=x>'; // shown as text
const HEBREW = 'שלום לכולם';

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const people = (page) => page.evaluate(() => window.jostle?.people);
const inspect = (page, name) => page.evaluate((member) => window.jostle?.[member], name);

async function checkAccessibility(page, what, expect) {
  await page.evaluate(AXE);
  const violations = await page.evaluate(async () => (await window.axe.run(document, { resultTypes: ['violations'] })).violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 140)).join(' | ')}`));
  expect(violations.length === 0, `axe-core finds no violations: ${what}${violations.map((text) => `\n    ${text}`).join('')}`);
}

/** Targets that are too small for fingers, elements beyond the page, and panels over the tools or each other. */
const layoutProblems = (page, targetMin) =>
  page.evaluate(async (min) => {
    await Promise.all(document.getAnimations().map(({ finished }) => finished));
    const problems = [];
    for (const element of document.querySelectorAll('button, select, input, summary')) {
      const box = element.getBoundingClientRect();
      if (box.width === 0 || getComputedStyle(element).visibility === 'hidden') continue;
      const target = element.closest('label')?.getBoundingClientRect() ?? box;
      if (Math.min(target.width, target.height) < min - 0.5) problems.push(`${element.textContent || element.name || element.ariaLabel} is ${Math.round(target.width)} x ${Math.round(target.height)}`);
      if (!element.closest('#tools, .body') && (box.left < -0.5 || box.right > innerWidth + 0.5 || box.top < -0.5 || box.bottom > innerHeight + 0.5)) problems.push(`${element.textContent || element.ariaLabel} is beyond the page`);
    }
    const boxes = [...document.querySelectorAll('.panel, #bar, #tools, #following')].map((e) => [e.id, e.getBoundingClientRect()]).filter(([, box]) => box.height > 0);
    for (const [k, [a, x]] of boxes.entries())
      for (const [b, y] of boxes.slice(k + 1)) if (x.left < y.right - 1 && y.left < x.right - 1 && x.top < y.bottom - 1 && y.top < x.bottom - 1) problems.push(`${a} and ${b} overlap`);
    for (const panel of document.querySelectorAll('.panel:not([hidden]) > .body')) if (panel.scrollWidth > panel.clientWidth + 1) problems.push(`${panel.parentElement.id} is wider than its panel`);
    return problems;
  }, targetMin);

async function checkLayout(page, what, expect, targetMin = 0) {
  const problems = await layoutProblems(page, targetMin);
  expect(problems.length === 0, `layout of ${what}: ${problems.join('; ') || 'nothing overlaps or is clipped'}`);
}

async function say(page, text) {
  await page.locator('#chat form input').fill(text);
  await page.locator('#chat form input').press('Enter');
}

const chatLines = (page) => page.locator('#chat ol li').evaluateAll((rows) => rows.map((row) => [row.querySelector('.name')?.textContent ?? '', row.querySelector('.text').textContent]));

/** Opens a panel from the bar, or on a phone from the menu. */
async function openPanel(page, id) {
  const button = page.locator(`#panel-buttons [aria-controls=${id}]`);
  if (await button.isVisible()) return button.click();
  await page.locator('#panel-buttons [aria-controls=menu]').click();
  const title = await page.locator(`#${id}`).getAttribute('aria-label');
  await page.locator('#menu .menu button', { hasText: title }).first().click();
}

/** Taps until the menu opens: while the sheet still moves, a slow page takes a tap at an old place. */
async function tapMenuOf(page, name) {
  for (let tries = 1; ; tries++) {
    await page.locator('#players li', { hasText: name }).locator('button').tap();
    const opened = page.locator('#context-menu').waitFor({ timeout: tries < 5 ? 5000 : undefined }).then(() => true);
    if (await (tries < 5 ? opened.catch(() => false) : opened)) return;
  }
}

export async function testPeople({ browser, url, post, until, expect, take = async () => {} }) {
  const errors = [];
  const open = async (options, query) => {
    const context = await browser.newContext({ ...options, permissions: ['clipboard-read', 'clipboard-write'] });
    const page = await context.newPage();
    page.setDefaultTimeout(TIMEOUT_S * 1000);
    page.on('pageerror', (error) => errors.push(String(error)));
    await page.goto(`${url}/?${query}`);
    await until('the page plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 20));
    return page;
  };
  const room = { title: 'Tower club', description: 'Build towers, then knock them over.', tags: ['towers'], capacity: 8, initialRole: 'player' };
  const created = await post('/api/worlds', { name: 'club', sceneName: 'sandbox', room });
  expect(created.ok, `a room is created: ${created.status}`);
  const wide = await open({ viewport: WIDE }, 'world=club&quality=low');
  try {
    await testName({ page: wide, until, expect, take });
    const phone = await open({ viewport: PHONE, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }, 'world=club&quality=low');
    await testPhoneName({ phone, wide, until, expect, take });
    await testList({ wide, phone, until, expect, take });
    await testChat({ wide, phone, until, expect, take });
    await testCursors({ wide, phone, until, expect, take });
    await testAddress({ page: wide, other: phone, until, expect, take });
    await testShare({ wide, phone, until, expect, take, browser });
    await testLobby({ wide, phone, post, until, expect, take });
    await phone.context().close();
    await testScenes({ page: wide, until, expect, take });
  } finally {
    await wide.context().close();
  }
  expect(errors.length === 0, `the pages have no errors ${errors.join('; ')}`);
}

async function testName({ page, until, expect, take }) {
  await until('the first visit asks for a name', () => page.locator('#identity form').isVisible());
  const guest = (await people(page)).identity.name;
  expect(/^Guest \d{3}$/.test(guest), `until then, the user plays as ${guest}`);
  await take(page, 'wide-name');
  await checkLayout(page, 'the wide page with the name', expect);
  await page.locator('#identity button[type=submit]').click();
  expect(/visible character/.test(await page.locator('#identity .problem').textContent()), 'an empty name is refused with a reason');
  await page.locator('#identity input[name=name]').fill('Ann');
  await page.locator('#identity input[aria-label=violet]').check();
  await checkAccessibility(page, 'name', expect);
  await page.locator('#identity button[type=submit]').click();
  expect(await page.locator('#identity').isHidden(), 'the panel closes when the name is saved');
}

async function testPhoneName({ phone, wide, until, expect, take }) {
  await until('the phone asks for a name', () => phone.locator('#identity form').isVisible());
  await take(phone, 'phone-name');
  await checkLayout(phone, 'the phone with the name', expect, TARGET_MIN);
  await phone.locator('#identity input[name=name]').fill(HOSTILE_NAME);
  await phone.locator('#identity button[type=submit]').tap();
  const lines = await until('the wide page shows who joined and who was renamed', async () => {
    const { lines } = await people(wide);
    return lines.some(({ text }) => text.endsWith(`is now ${HOSTILE_NAME}`)) && lines;
  });
  expect(lines.some(({ text }) => /^Guest \d{3} joined$/.test(text)), `notices: ${lines.map(({ text }) => text).join(', ')}`);
  expect((await wide.locator('#feed p').count()) > 0, 'notices are shown over the tools');
  expect((await wide.locator('#feed').getAttribute('aria-live')) === 'polite', 'a live region announces them');
}

async function testList({ wide, phone, until, expect, take }) {
  await wide.keyboard.press('p');
  const rows = wide.locator('#players li');
  await until('both players are listed', async () => (await rows.count()) === 2);
  const names = await wide.locator('#players .name').allTextContents();
  expect(names[0] === 'Ann' && names[1] === HOSTILE_NAME, `the list shows ${names.join(', ')}`);
  expect((await wide.locator('#players img').count()) === 0, 'a name with markup is text');
  const about = await until('pings are known', async () => {
    const texts = await wide.locator('#players .about').allTextContents();
    return texts.every((text) => / ms/.test(text)) && texts;
  });
  expect(/^you · owner · \d+ ms$/.test(about[0]) && /^player · \d+ ms$/.test(about[1]), `roles and pings: ${about.join(', ')}`);
  const color = await wide.locator('#players li').first().evaluate((row) => row.style.getPropertyValue('--player'));
  expect(color === '#9b59d0', `the list shows the chosen color ${color}`);
  expect((await wide.locator('#panel-buttons [aria-controls=players]').getAttribute('aria-label')) === 'Players, 2 players', 'the button counts the players');
  await openPanel(phone, 'players');
  await until('the phone lists both', async () => (await phone.locator('#players li').count()) === 2);
  const seen = await phone.locator('#players li', { hasText: 'Ann' }).evaluate((row) => row.style.getPropertyValue('--player'));
  expect(seen === '#9b59d0', 'the other browser shows the color that was chosen after joining');
  await checkLayout(phone, 'the phone with the players', expect, TARGET_MIN);
  await take(phone, 'phone-players');
  await wide.locator('#players li', { hasText: HOSTILE_NAME }).locator('button').click();
  await until('the menu of the player is open', () => wide.locator('#context-menu').isVisible());
  const actions = await wide.locator('#context-menu button').allTextContents();
  expect(['Follow', 'Mute for me', 'Report …', 'Mute for all, 5 minutes', 'Kick', 'Ban …'].every((label) => actions.includes(label)), `the owner may ${actions.join(', ')}`);
  await take(wide, 'wide-player-menu');
  await wide.keyboard.press('Escape');
  await tapMenuOf(phone, 'Ann');
  const few = await phone.locator('#context-menu button').allTextContents();
  expect(!few.includes('Kick') && few.includes('Vote to kick'), `a player may ${few.join(', ')}`);
  await checkLayout(phone, 'the phone with the menu of a player', expect, TARGET_MIN);
  await take(phone, 'phone-player-menu');
  await phone.locator('#context-menu button', { hasText: 'Report' }).tap();
  await phone.locator('#context-menu button', { hasText: 'Spam' }).tap();
  await until('the report is confirmed', async () => (await people(phone)).lines.some(({ text }) => /^You reported Ann to the server/.test(text)));
  await until('the server lists the report', async () => {
    const { reports } = await wide.evaluate(async () => {
      const request = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: '{}' };
      return (await fetch('api/admin/ListReports', request)).json();
    });
    return reports.some(({ name, reason, from }) => name === 'Ann' && reason === 'Spam' && from > 0);
  });
  await phone.locator('#players .close').tap();
}

async function testChat({ wide, phone, until, expect, take }) {
  await wide.locator('#view').focus();
  await wide.keyboard.press('c');
  await until('the chat has the focus', () => wide.evaluate(() => document.activeElement?.name === 'message'));
  await say(wide, 'Hello, world');
  await until('the phone announces the message', async () => (await phone.locator('#feed .text').allTextContents()).includes('Hello, world'));
  const label = await phone.locator('#panel-buttons [aria-controls=chat]').getAttribute('aria-label');
  expect(label === 'Chat, 1 unread', `the button of the phone is ${label}`);
  await take(phone, 'phone-feed');
  await openPanel(phone, 'chat');
  await until('the phone shows the message', async () => (await chatLines(phone)).some(([name, text]) => name === 'Ann' && text === 'Hello, world'));
  await say(phone, HEBREW);
  await say(phone, '<b>bold</b> \u202Eoverride');
  await until('the wide page shows both', async () => (await chatLines(wide)).filter(([name]) => name === HOSTILE_NAME).length === 2);
  const texts = (await chatLines(wide)).map(([, text]) => text);
  expect(texts.includes(HEBREW) && texts.includes('<b>bold</b> override'), 'markup is text, and overrides of direction are removed');
  expect((await wide.locator('#chat b, #chat img').count()) === 0, 'messages create no elements');
  expect((await wide.locator('#chat .text').last().getAttribute('dir')) === 'auto', 'each message has its own direction');
  for (let k = 1; k <= 14; k++) await say(phone, `burst ${k}`);
  await until('a burst above the limit of the server arrives completely', async () => (await chatLines(wide)).filter(([, text]) => /^burst \d+$/.test(text)).length === 14);
  const burst = (await chatLines(wide)).map(([, text]) => text).filter((text) => text.startsWith('burst'));
  expect(burst.join() === Array.from({ length: 14 }, (_, k) => `burst ${k + 1}`).join(), 'and in order');
  await say(phone, 'w'.repeat(299));
  await until('the long message arrives', async () => (await chatLines(wide)).some(([, text]) => text.length === 299));
  await checkLayout(wide, 'the wide page with the chat', expect);
  await checkLayout(phone, 'the phone with the chat', expect, TARGET_MIN);
  await checkAccessibility(phone, 'phone, chat', expect);
  for (const theme of ['dark', 'light']) {
    await wide.locator('#view').focus();
    if ((await wide.evaluate(() => document.documentElement.dataset.theme)) !== theme) await wide.keyboard.press('t');
    await checkAccessibility(wide, `wide page with list and chat, ${theme} theme`, expect);
    await take(wide, `wide-chat-${theme}`);
  }
  await wide.keyboard.press('t');
  await take(phone, 'phone-chat');

  // Muted for the user only.
  await wide.locator('#chat button.name').last().click();
  await wide.locator('#context-menu button', { hasText: 'Mute for me' }).click();
  await say(phone, 'still here?');
  await say(wide, 'I cannot read you');
  await until('the answer arrives', async () => (await chatLines(phone)).some(([, text]) => text === 'I cannot read you'));
  expect((await chatLines(wide)).every(([name]) => name !== HOSTILE_NAME), 'the wide page shows no message of the muted player');
  await wide.locator('#players li', { hasText: HOSTILE_NAME }).locator('button').click();
  await wide.locator('#context-menu button', { hasText: 'Unmute for me' }).click();
  // Muted for all by the owner of the room.
  await wide.locator('#players li', { hasText: HOSTILE_NAME }).locator('button').click();
  await wide.locator('#context-menu button', { hasText: /^Mute for all/ }).click();
  await wait(500);
  await say(phone, 'can you hear me?');
  const refused = await until('the message of the muted player is refused', async () => (await people(phone)).lines.find(({ text, refused }) => text === 'can you hear me?' && refused));
  expect(/mute/.test(refused.refused), `the sender reads: ${refused.refused}`);
  await take(phone, 'phone-muted');
  await wide.locator('#players li', { hasText: HOSTILE_NAME }).locator('button').click();
  await wide.locator('#context-menu button', { hasText: 'End the mute' }).click();
  await wait(500);
  await say(phone, 'better?');
  await until('the mute ended', async () => (await chatLines(wide)).some(([, text]) => text === 'better?'));
  await wide.locator('#chat form input').focus();
  await wide.keyboard.press('Escape');
  expect(await wide.evaluate(() => document.activeElement?.id === 'view'), 'Esc leaves the field');
  await phone.locator('#chat .close').tap();
}

/** A box of the tower that the page shows. */
const towerBox = (page, until) =>
  until('the tower is rendered', () =>
    page.evaluate(() => {
      const towers = window.jostle.dynamicBodies().filter((id) => window.jostle.entityName(id) === 'tower' && window.jostle.poseOf(id));
      return towers.sort((a, b) => window.jostle.poseOf(b)[1] - window.jostle.poseOf(a)[1])[0];
    }),
  );

/** The view no longer moves relative to a body. */
const cameraRests = (page, body, until) =>
  until('the camera rests', async () => {
    const before = await page.evaluate((id) => window.jostle.screenPosition(id), body);
    await wait(400);
    const after = await page.evaluate((id) => window.jostle.screenPosition(id), body);
    return Math.hypot(before.x - after.x, before.y - after.y) < 1;
  });

async function testCursors({ wide, phone, until, expect, take }) {
  await wide.keyboard.press('1');
  const box = await towerBox(wide, until);
  await cameraRests(wide, box, until);
  const at = await wide.evaluate((id) => window.jostle.screenPosition(id), box);
  await wide.mouse.move(at.x, at.y);
  await wide.mouse.move(at.x + 2, at.y + 1);
  const cursor = await until('the phone receives the cursor', async () => (await people(phone)).cursors[0]);
  const pose = await wide.evaluate((id) => window.jostle.poseOf(id), box);
  const apart = Math.hypot(cursor.position.x - pose[0], cursor.position.y - pose[1], cursor.position.z - pose[2]);
  expect(apart < 2, `the cursor is ${apart.toFixed(2)} m from the body under it`);
  await until('its name tag is shown', async () => (await phone.locator('#tags span').allTextContents()).includes('Ann'));
  expect(true, 'the cursor has the name of its player');

  const sentBefore = (await people(wide)).cursorMessagesSent;
  const startMs = Date.now();
  await wide.mouse.down();
  for (let k = 1; k <= 40; k++) {
    await wide.mouse.move(at.x - 4 * k, at.y - 3 * k);
    await wait(50);
  }
  const seconds = (Date.now() - startMs) / 1000;
  const sent = (await people(wide)).cursorMessagesSent - sentBefore;
  expect(sent > 0 && sent / seconds <= 3.5, `a moving cursor sends ${(sent / seconds).toFixed(1)} messages per second`);
  await until('the phone shows what the other grabs', async () => (await people(phone)).cursors[0]?.grab === box);
  expect(true, `the phone shows that the other grabs body ${box}`);
  await take(phone, 'phone-cursor');

  // The phone follows the player.
  await openPanel(phone, 'players');
  await tapMenuOf(phone, 'Ann');
  await phone.locator('#context-menu button', { hasText: 'Follow' }).tap();
  await phone.locator('#players .close').tap();
  await until('the camera reaches the cursor', () =>
    phone.evaluate(() => {
      const [cursor] = window.jostle.people.cursors;
      const [x, y, z] = window.jostle.cameraTarget;
      return cursor && Math.hypot(x - cursor.position.x, y - cursor.position.y, z - cursor.position.z) < 1;
    }),
  );
  expect((await phone.locator('#following span').textContent()) === 'Following Ann', 'following a player moves the camera to its cursor');
  await checkLayout(phone, 'the phone while following', expect, TARGET_MIN);
  await take(phone, 'phone-following');
  await phone.locator('#following button').tap();
  expect(await phone.locator('#following').isHidden(), 'and ends');
  await wide.mouse.up();
  await until('the grab ends', async () => (await people(phone)).cursors[0]?.grab === undefined);

  const restBefore = (await people(wide)).cursorMessagesSent;
  await wait(1500);
  expect((await people(wide)).cursorMessagesSent - restBefore <= 1, 'a resting cursor sends nothing');
  // The other direction. With a mouse, because a slow page takes a touch for a long press.
  await phone.keyboard.press('f');
  await wait(1000);
  const other = await towerBox(phone, until);
  await cameraRests(phone, other, until);
  const start = await phone.evaluate((id) => window.jostle.screenPosition(id), other);
  await phone.mouse.move(start.x, start.y);
  await phone.mouse.down();
  for (let k = 1; k <= 12; k++) {
    await phone.mouse.move(start.x + 3 * k, start.y - 3 * k);
    await wait(60);
  }
  const grabs = await until('the wide page shows the grab of the phone', async () => (await people(wide)).cursors.find(({ grab }) => grab > 0));
  expect(grabs.grab > 0, 'the wide page shows the grab of the phone');
  await until('and its name tag', async () => (await wide.locator('#tags span').allTextContents()).includes(HOSTILE_NAME));
  await take(wide, 'wide-grab');
  await phone.mouse.up();
}

async function testAddress({ page, other, until, expect }) {
  const worldOf = (one) => new URL(one.url()).searchParams.get('world');
  expect(worldOf(page) === 'club' && /quality=low/.test(page.url()), `the address is ${page.url()}`);
  await page.reload();
  await until('the reloaded page plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 5));
  const { world, identity } = await people(page);
  expect(world === 'club' && identity.name === 'Ann' && identity.color === 0x9b59d0, `after reloading, ${identity.name} is in ${world}`);
  expect(await page.locator('#identity').isHidden(), 'the name is not asked again');
  await until('the other sees the departure and the return', async () => {
    const texts = (await people(other)).lines.map(({ text }) => text);
    return texts.includes('Ann left') && texts.includes('Ann joined');
  });
  await openPanel(other, 'players');
  await until('no entry of the old page remains', async () => (await other.locator('#players li').count()) === 2);
  await other.locator('#players .close').tap();
  expect(true, 'others see that the user left and joined again');
}

async function testShare({ wide, phone, until, expect, take }) {
  await wide.keyboard.press('i');
  await until('the link is shown', () => wide.locator('#share canvas').isVisible());
  const link = await wide.locator('#share input[type=url]').inputValue();
  expect(link === `${new URL(wide.url()).origin}/?world=club`, `the link is ${link}`);
  await wide.locator('#share button', { hasText: 'Copy link' }).click();
  await until('the copy is confirmed', async () => /copied/.test(await wide.locator('#share [role=status]').textContent()));
  expect((await wide.evaluate(() => navigator.clipboard.readText())) === link, 'the link is in the clipboard');
  // What a phone would see: the rendered pixels.
  const png = (await wide.locator('#share canvas').screenshot()).toString('base64');
  const image = await wide.evaluate(async (data) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (byte) => byte.charCodeAt(0))]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return { width: bitmap.width, height: bitmap.height, data: [...context.getImageData(0, 0, bitmap.width, bitmap.height).data] };
  }, png);
  expect(decodeQR({ ...image, data: Uint8Array.from(image.data) }) === link, 'the rendered QR code decodes to the link');
  await checkLayout(wide, 'the wide page with the link', expect);
  await checkAccessibility(wide, 'link', expect);
  await take(wide, 'wide-share');
  await wide.locator('#share .close').click();
  await openPanel(phone, 'share');
  await until('the phone shows the QR code', () => phone.locator('#share canvas').isVisible());
  await checkLayout(phone, 'the phone with the link', expect, TARGET_MIN);
  await take(phone, 'phone-share');
  await phone.locator('#share .close').tap();
}

async function testLobby({ wide, phone, post, until, expect, take }) {
  const secret = await post('/api/worlds', { name: 'den', sceneName: 'billiards', room: { title: 'The den', joinCode: 'sesame' } });
  expect(secret.ok, `a private room is created: ${secret.status}`);
  await openPanel(phone, 'worlds');
  await until('the cards are shown', async () => (await phone.locator('#worlds .card').count()) >= 3);
  const club = phone.locator('#worlds .card', { hasText: 'Tower club' });
  const about = await club.locator('.about').textContent();
  expect(/^2\sof\s8\splayers · \d+\sbodies$/.test(about), `the card shows ${about}`);
  const drawn = await until('its thumbnail is loaded', () => club.locator('img').evaluate((image) => image.complete && image.naturalWidth));
  expect(drawn >= 200, `the card has a thumbnail of ${drawn} pixels`);
  await checkLayout(phone, 'the phone with the lobby', expect, TARGET_MIN);
  await checkAccessibility(phone, 'phone, lobby', expect);
  await take(phone, 'phone-lobby');
  const den = phone.locator('#worlds .card', { hasText: 'The den' });
  await den.locator('button', { hasText: 'Join' }).tap();
  await den.locator('input').fill('sesame');
  await checkLayout(phone, 'the phone with the join code', expect, TARGET_MIN);
  await take(phone, 'phone-code');
  await den.locator('form button').tap();
  await until('the private room is joined', async () => (await people(phone)).world === 'den' && (await inspect(phone, 'state')) === 'playing');
  expect(new URL(phone.url()).searchParams.get('world') === 'den', 'its address names the new world');
  await until('the other sees the departure', async () => (await people(wide)).lines.some(({ text }) => text === `${HOSTILE_NAME} left`));
  await phone.reload();
  await until('reloading stays in the private room', async () => (await people(phone))?.world === 'den' && (await inspect(phone, 'state')) === 'playing');
  expect(true, 'reloading stays in the private room');
  await phone.goBack();
  await until('Back returns to the previous world', async () => (await people(phone))?.world === 'club' && (await inspect(phone, 'state')) === 'playing');
  expect(true, 'Back returns to the previous world');

  await wide.locator('#view').focus();
  await wide.keyboard.press('w');
  await until('the cards are shown', async () => (await wide.locator('#worlds .card').count()) >= 3);
  await wide.locator('#worlds input[type=search]').fill('tower');
  expect((await wide.locator('#worlds .card').count()) === 1, 'the search finds the room by its title');
  await wide.locator('#worlds input[type=search]').fill('');
  await until('all thumbnails of the view are loaded', () => wide.evaluate(() => [...document.querySelectorAll('#worlds .card img')].every((image) => image.complete)));
  await checkLayout(wide, 'the wide page with the lobby', expect);
  await wide.locator('#view').focus();
  for (const theme of ['light', 'dark']) {
    if ((await wide.evaluate(() => document.documentElement.dataset.theme)) !== theme) await wide.keyboard.press('t');
    await checkAccessibility(wide, `wide page with the lobby, ${theme} theme`, expect);
    await take(wide, `wide-lobby-${theme}`);
  }
}

async function testScenes({ page, until, expect, take }) {
  const upload = (name, text) => page.locator('#worlds input[type=file]').setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
  const faulty = '{\n  "name": "balls", "bodies": [\n    {"mass": 2, "shapes": [{"sphere": {"radius": 0.5}}]},\n    {"mas": 2, "shapes": [{"sphere": {"radius": 1}}]}\n  ]\n}\n';
  await upload('faulty.json', faulty);
  await until('the problem is shown', () => page.locator('#worlds .problems pre').count());
  const where = await page.locator('#worlds .problems p strong').textContent();
  const marked = await page.locator('#worlds .problems pre .at').textContent();
  expect(where === 'Line 4, column 13: ' && marked === '4    {"mas": 2, "shapes": [{"sphere": {"radius": 1}}]}', `${where}${marked}`);
  await page.evaluate(() => document.querySelector('#worlds .body').scrollTo(0, 0));
  await checkAccessibility(page, 'problems of a scene', expect);
  await checkLayout(page, 'the wide page with problems', expect);
  await take(page, 'wide-problems');
  await upload('syntax.json', '{\n  "bodies": [\n');
  await until('the syntax error is shown', async () => /syntax/.test(await page.locator('#worlds .problems').textContent()));
  expect(/^Line \d+, column \d+: $/.test(await page.locator('#worlds .problems p strong').textContent()), 'a syntax error has its line');
  await upload('two balls.json', faulty.replace('"mas"', '"mass"'));
  await until('the uploaded scene is joined', async () => (await people(page)).world === 'two balls' && (await inspect(page, 'entityCount')) === 2);
  expect(true, 'a corrected scene is joined under the name of its file');

  await page.keyboard.press('w');
  const card = page.locator('#worlds .card', { hasText: 'two balls' });
  await card.locator('button', { hasText: 'Joined' }).waitFor();
  await card.getByRole('button', { name: /^More about/ }).click();
  const [downloaded] = await Promise.all([page.waitForEvent('download'), page.locator('#context-menu button', { hasText: 'Download' }).click()]);
  const file = readFileSync(await downloaded.path(), 'utf8');
  expect(downloaded.suggestedFilename() === 'two balls.json' && JSON.parse(file).bodies.length === 2, `${downloaded.suggestedFilename()} has ${file.length} bytes and two bodies`);
  await upload('again.json', file);
  await until('the downloaded scene is joined', async () => (await people(page)).world === 'again' && (await inspect(page, 'entityCount')) === 2);
  expect(true, 'the downloaded scene can be uploaded again');
  // A file that is dropped on the page.
  const data = await page.evaluateHandle((text) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([text], 'dropped.json', { type: 'application/json' }));
    return transfer;
  }, file);
  await page.dispatchEvent('#view', 'drop', { dataTransfer: data });
  await until('the dropped scene is joined', async () => (await people(page)).world === 'dropped');
  expect(true, 'a scene file can be dropped on the page');
}

// --- alone

async function runAlone(server, folder) {
  const portFile = join(mkdtempSync(join(tmpdir(), 'jostle-people-')), 'ports.json');
  const webRoot = fileURLToPath(new URL('../../dist', import.meta.url));
  const child = spawn(server, ['--scene', 'sandbox', '--listen', '127.0.0.1:0', '--http', '127.0.0.1:0', '--admin', '127.0.0.1:0', '--web-root', webRoot, '--port-file', portFile, '--set', `tick.step_seconds_max=${TIMEOUT_S}`], { stdio: ['ignore', 'ignore', 'inherit'] });
  const until = async (what, check) => {
    for (const end = Date.now() + TIMEOUT_S * 1000; Date.now() < end; await wait(50)) {
      const value = await check();
      if (value) return value;
    }
    throw new Error(`timeout after ${TIMEOUT_S} s: ${what}`);
  };
  let passed = 0;
  const expect = (condition, what) => {
    if (!condition) throw new Error(`expectation failed: ${what}`);
    passed++;
    console.log(`  ok: ${what}`);
  };
  if (folder) mkdirSync(folder, { recursive: true });
  const take = async (page, name) => folder && void (await page.screenshot({ path: join(folder, `${name}.png`), timeout: 60_000 }));
  let browser;
  let status = 0;
  try {
    const { http } = await until('the server writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
    const url = `http://127.0.0.1:${http}`;
    browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: CHROMIUM_FLAGS });
    const post = (path, message) => fetch(url + path, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(message) });
    await testPeople({ browser, url, post, until, expect, take });
  } catch (error) {
    console.error(`FAILED: ${error.message}`);
    for (const [k, page] of (browser?.contexts() ?? []).flatMap((context) => context.pages()).entries()) await take(page, `failed-${k}`).catch(() => {});
    status = 1;
  } finally {
    await browser?.close();
    child.kill('SIGTERM');
    rmSync(portFile, { force: true });
  }
  console.log(`people: ${passed} passed, ${status} failed`);
  process.exit(status);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [server, option, folder] = process.argv.slice(2);
  if (!server || !existsSync(server)) {
    console.error('usage: node viewer/e2e/people.mjs SERVER_BINARY [--screenshots FOLDER]');
    process.exit(2);
  }
  await runAlone(server, option === '--screenshots' ? folder : undefined);
}
