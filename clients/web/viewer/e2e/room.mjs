// Rooms: two browsers, the owner on a wide page and a player on a phone. Settings with errors at their field,
// permissions that disable tools and name their rule, protected areas, bans, and the transfer of the room.
// The player connects through a proxy that gives it another address, because a ban refuses an address.

import { spawn } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { connect, createServer } from 'node:net';
import { join } from 'node:path';
import { checkAccessibility, layoutProblems } from './acceptance.mjs';
import { setName } from './chromium.mjs';
import { helpersOf, workshop } from './sandbox.mjs';

const WIDE = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };
const TARGET_MIN = 44; // pixels
const PLAYER_ADDRESS = '192.0.2.7';

/** Forwards connections and adds the address of the client to each request. */
function startProxy(port) {
  const sockets = new Set();
  const proxy = createServer((client) => {
    const server = connect(port, '127.0.0.1');
    for (const socket of [client, server]) {
      sockets.add(socket);
      socket.on('error', () => {});
      socket.on('close', () => (client.destroy(), server.destroy()));
    }
    client.on('data', (chunk) => {
      const line = /^(?:GET|POST|DELETE) [^\r\n]+\r\n/.exec(chunk.subarray(0, 4096).toString('latin1'))?.[0];
      server.write(line ? Buffer.concat([chunk.subarray(0, line.length), Buffer.from(`X-Forwarded-For: ${PLAYER_ADDRESS}\r\n`), chunk.subarray(line.length)]) : chunk);
    });
    server.pipe(client);
  });
  const stop = () => {
    proxy.close();
    for (const socket of sockets) socket.destroy();
  };
  return new Promise((resolve) => proxy.listen(0, '127.0.0.1', () => resolve({ port: proxy.address().port, stop })));
}

export async function testRoom({ browser, server, folder, webRoot, until, expect, screenshot }) {
  const portFile = join(folder, 'room_ports.json');
  const options = { '--scene': 'stack', '--listen': '127.0.0.1:0', '--http': '127.0.0.1:0', '--admin': '127.0.0.1:0', '--web-root': webRoot, '--port-file': portFile };
  const child = spawn(server, [...Object.entries(options).flat(), '--set', 'trusted_proxies=["127.0.0.1/32"]', '--insecure', '--set', 'tick.step_seconds_max=60'], { stdio: ['ignore', 'inherit', 'inherit'] });
  const errors = [];
  const contexts = [];
  let proxy;
  try {
    const ports = await until('the server of the room writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
    proxy = await startProxy(ports.http);
    const created = await fetch(`http://127.0.0.1:${ports.http}/api/worlds`, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify({ name: 'den', scene: workshop({ title: 'Den', capacity: 8 }) }),
    });
    expect(created.ok, `a room is created: ${created.status}`);
    const open = async (name, port, options) => {
      const context = await browser.newContext(options);
      contexts.push(context);
      await setName(context, name);
      const page = await context.newPage();
      page.setDefaultTimeout(60_000);
      page.on('pageerror', (error) => errors.push(String(error)));
      await page.goto(`http://127.0.0.1:${port}/?world=den&quality=low`);
      await until(`${name} plays`, () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.room !== undefined && window.jostle.snapshots > 20));
      return page;
    };
    const wide = await open('Ann', ports.http, { viewport: WIDE });
    const phone = await open('Bob', proxy.port, { viewport: PHONE, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
    const take = async (page, name) => screenshot && (await page.screenshot({ path: screenshot(name), timeout: 60_000 }));
    const rooms = { wide, phone, until, expect, take, wideHelpers: helpersOf(wide, until) };
    await testSettings(rooms);
    await testPermissions(rooms);
    await testAreas(rooms);
    await testBans(rooms);
    await testTransfer(rooms);
    expect(errors.length === 0, `the pages of the room have no errors ${errors.join('; ')}`);
  } finally {
    for (const context of contexts) await context.close();
    proxy?.stop();
    child.kill('SIGTERM');
  }
}

const settingsOf = (page) => page.evaluate(() => window.jostle.room?.settings);
const saved = (page, until) => until('the settings are saved', async () => /saved/.test(await page.locator('#room form [role=status]').first().textContent()));

async function openRoom(page, until, isPhone) {
  if (isPhone) {
    await page.locator('#panel-buttons [aria-controls=menu]').click();
    await page.locator('#menu .menu button[aria-label="Room"]').click();
  } else await page.locator('#panel-buttons [aria-controls=room]').click();
  await until('the panel of the room is loaded', () => page.locator('#room input[name=title]').count());
}

async function testSettings({ wide, phone, until, expect, take }) {
  await openRoom(wide, until, false);
  expect((await wide.locator('#room input[name=title]').inputValue()) === 'Den', 'the form shows the settings');
  expect(/role is owner/.test(await wide.locator('#room .note').first().textContent()), 'the panel names the own role');
  const save = wide.locator('#room form button', { hasText: 'Save' });
  expect(await save.isDisabled(), 'unchanged settings cannot be saved');
  await wide.locator('#room input[name=title]').fill('Night shift');
  await wide.locator('#room textarea[name=description]').fill('Towers until the morning.');
  await wide.locator('#room input[name=tags]').fill('towers Loud!');
  await save.click();
  const problem = await until('the server refuses the tag', () => wide.locator('#room-problem-tags').textContent());
  expect(/"Loud!" is not a tag/.test(problem), `the problem is at its field: ${problem}`);
  expect((await wide.locator('#room input[name=tags]').getAttribute('aria-invalid')) === 'true', 'and the field is marked');
  await take(wide, 'room-problem');
  await checkAccessibility(wide, 'room settings with a problem', expect);
  await wide.locator('#room input[name=tags]').fill('towers, night');
  await wide.locator('#room input[name=capacity]').fill('6');
  await wide.locator('#room input[name=isPrivate]').check();
  await save.click();
  expect(/needs a join code/.test(await wide.locator('#room-problem-joinCode').textContent()), 'a private room needs a join code');
  await wide.locator('#room input[name=joinCode]').fill('sesame');
  await wide.locator('#room input[name=closeWhenEmpty]').check();
  await wide.locator('#room input[name=timelineSeconds]').fill('30');
  await save.click();
  await saved(wide, until);
  const own = await settingsOf(wide);
  expect(own.joinCode === 'sesame' && own.capacity === 6 && own.closeWhenEmpty && own.timelineSeconds === 30 && own.tags.join() === 'towers,night', `the settings are ${JSON.stringify(own)}`);
  const other = await until('the player receives the settings', async () => {
    const settings = await settingsOf(phone);
    return settings?.title === 'Night shift' && settings;
  });
  expect(other.joinCode === '' && other.capacity === 6, 'but not the join code');
  expect((await phone.title()) === 'Night shift – Jostle', 'the title of the page is that of the room');
  await openRoom(phone, until, true);
  expect((await phone.locator('#room input[name=title]').isDisabled()) && /room.permissions: player.settings is none/.test(await phone.locator('#room .note').first().textContent()), 'a player reads the settings and the rule');
  const problems = await layoutProblems(phone, TARGET_MIN);
  expect(problems.length === 0, `phone, room: targets have 44 pixels and fit the page ${problems.join('; ')}`);
  await checkAccessibility(phone, 'phone, room', expect);
  await take(phone, 'room-phone');
  await phone.locator('#room .close').click();
}

async function testPermissions({ wide, phone, until, expect, take }) {
  await wide.locator('#room summary', { hasText: 'Permissions' }).click();
  await wide.locator('#room select[name="player.explode"]').selectOption('none');
  await wide.locator('#room select[name="player.spawn"]').selectOption('none');
  await wide.locator('#room select[aria-label="Role of the permissions"]').selectOption('owner');
  expect(/player \(2 changed\)/.test(await wide.locator('#room select[aria-label="Role of the permissions"]').textContent()), 'the table counts what differs from the default');
  await wide.locator('#room select[name="owner.vote"]').selectOption('none');
  await take(wide, 'room-permissions');
  for (const theme of ['light', 'dark']) {
    await wide.evaluate(() => document.activeElement?.blur());
    await wide.keyboard.press('t');
    await checkAccessibility(wide, `room permissions, ${theme} theme`, expect);
  }
  await wide.locator('#room form button', { hasText: 'Save' }).click();
  await saved(wide, until);
  const rule = 'room.permissions: player.explode is none; the role player may not explode';
  const explode = phone.locator('#tools [data-tool=explode]');
  await until('the tool is disabled', async () => (await explode.getAttribute('aria-disabled')) === 'true');
  expect((await explode.getAttribute('title')) === rule, `its title is the rule: ${rule}`);
  const disabled = await phone.locator('#tools [aria-disabled=true]').evaluateAll((buttons) => buttons.map(({ dataset }) => dataset.tool).join());
  expect(disabled === 'throw,box,sphere,capsule,explode', `disabled tools: ${disabled}`);
  await explode.click({ force: true });
  expect((await phone.locator('#toasts p').allTextContents()).includes(rule) && (await explode.getAttribute('aria-pressed')) !== 'true', 'a click explains it and does not select the tool');
  await take(phone, 'room-disabled-tools');
  await checkAccessibility(phone, 'phone, disabled tools', expect);
  // The menu of a player follows the replaced permission and names it.
  await wide.evaluate(() => document.activeElement?.blur());
  await wide.keyboard.press('p');
  await wide.locator('#players li', { hasText: 'Bob' }).locator('button').click();
  const vote = wide.locator('#context-menu button', { hasText: 'Vote to kick' });
  expect((await vote.getAttribute('aria-disabled')) === 'true' && /owner\.vote is none/.test(await vote.textContent()), `the menu shows ${await vote.textContent()}`);
  await take(wide, 'room-player-menu');
  await checkAccessibility(wide, 'menu with a refused action', expect);
  await wide.keyboard.press('Escape');
  await wide.locator('#players .close').click();
  // Without the replaced entries, the tools work again.
  await wide.locator('#room select[aria-label="Role of the permissions"]').selectOption('player');
  await wide.locator('#room select[name="player.explode"]').selectOption('any');
  await wide.locator('#room select[name="player.spawn"]').selectOption('any');
  await wide.locator('#room form button', { hasText: 'Save' }).click();
  await saved(wide, until);
  await until('the tool is enabled again', async () => (await explode.getAttribute('aria-disabled')) === 'false');
  expect(Object.keys((await settingsOf(phone)).permissions).join() === 'owner.vote', 'only entries that differ from the default are stored');
  await wide.locator('#room summary', { hasText: 'Permissions' }).click();
}

async function testAreas({ wide, phone, until, expect, take, wideHelpers: { idsOf, clickBody, get } }) {
  await wide.evaluate(() => document.activeElement?.blur());
  await wide.keyboard.press('0');
  const [crate] = await idsOf('crate');
  await clickBody(crate);
  await until('the crate is selected', async () => (await get('selected'))?.id === crate);
  await wide.locator('#room summary', { hasText: 'Protect an area' }).click();
  await wide.locator('#room button', { hasText: 'Around the selection' }).click();
  const low = await wide.locator('#room input[name=areaMin]').inputValue();
  expect(low.split(', ').every((value, axis) => Math.abs(Number(value) - [-1.5, -1, -1.5][axis]) < 0.1), `the box of the crate and 1 m around it begins at ${low}`);
  await wide.locator('#room button', { hasText: /^Protect$/ }).click();
  expect(/name/.test(await wide.locator('#room-problem-area').textContent()), 'an area needs a name');
  await wide.locator('#room input[name=areaName]').fill('crate');
  await wide.locator('#room button', { hasText: /^Protect$/ }).click();
  await until('the player receives the area', async () => (await settingsOf(phone)).areas.length === 1);
  await until('the owner sees its box', async () => (await get('areaVertexCount')) === 24);
  await take(wide, 'room-area');
  await checkAccessibility(wide, 'protected areas', expect);
  // The player cannot drag what is inside.
  const id = crate;
  await phone.locator('#tools [data-tool=box]').click();
  const at = await until('the phone renders the crate', () => phone.evaluate((body) => window.jostle.screenPosition(body), id));
  await phone.mouse.click(at.x, at.y);
  const toast = await until('the server refuses', async () => (await phone.locator('#toasts p').allTextContents()).find((text) => /crate/.test(text)));
  expect(/area/.test(toast), `in a protected area, a player reads: ${toast}`);
  await wide.locator('#room button[aria-label="Remove the protection of crate"]').click();
  await until('the area is gone', async () => (await settingsOf(phone)).areas.length === 0 && (await get('areaVertexCount')) === 0);
  expect(true, 'an owner adds and removes protected areas');
}

async function testBans({ wide, phone, until, expect, take }) {
  await wide.evaluate(() => document.activeElement?.blur());
  await wide.keyboard.press('p');
  await wide.locator('#players li', { hasText: 'Bob' }).locator('button').click();
  await wide.locator('#context-menu button', { hasText: 'Ban …' }).click();
  await take(wide, 'room-ban');
  await wide.locator('#context-menu button', { hasText: 'For 1 hour' }).click();
  await until('the banned player is disconnected', () => phone.evaluate(() => window.jostle.state === 'stopped'));
  const [ban] = await until('the owner receives the ban', async () => {
    const bans = await wide.evaluate(() => window.jostle.room.bans);
    return bans.length === 1 && bans;
  });
  expect(ban.member === `network/${PLAYER_ADDRESS}` && !ban.permanent, `the panel lists the ban of ${ban.member}`);
  await until('the owner stays alone', async () => (await wide.locator('#players li').count()) === 1);
  await wide.locator('#room button[aria-label^="Unban"]').scrollIntoViewIfNeeded();
  await take(wide, 'room-bans');
  await checkAccessibility(wide, 'list of bans', expect);
  await wide.locator('#room button[aria-label^="Unban"]').click();
  await until('the ban is gone', () => wide.evaluate(() => window.jostle.room.bans.length === 0));
  await phone.goto(`${phone.url().split('#')[0]}#code=sesame`);
  await phone.reload();
  await until('the player joins again', () => phone.evaluate(() => window.jostle?.state === 'playing' && window.jostle.room !== undefined));
  expect(true, 'an unbanned player joins again with the join code');
  await wide.locator('#players .close').click();
}

async function testTransfer({ wide, phone, until, expect, take }) {
  await until('the player can be chosen', async () => (await wide.locator('#room select[aria-label="New owner"] option').allTextContents()).includes('Bob'));
  await wide.locator('#room select[aria-label="New owner"]').selectOption({ label: 'Bob' });
  const give = wide.locator('#room button', { hasText: 'Transfer the room' });
  await give.click();
  await take(wide, 'room-transfer');
  await wide.locator('#room button', { hasText: 'Click again to transfer' }).click();
  await until('the former owner is a builder', async () => /role is builder/.test(await wide.locator('#room .note').first().textContent()));
  expect((await settingsOf(wide)).joinCode === '' && (await wide.locator('#room input[name=title]').isDisabled()), 'the former owner no longer sees the join code or changes settings');
  await openRoom(phone, until, true);
  await until('the new owner may change the settings', () => phone.locator('#room input[name=title]').isEnabled());
  expect((await settingsOf(phone)).joinCode === 'sesame', 'the new owner sees the join code');
  const problems = await layoutProblems(phone, TARGET_MIN);
  expect(problems.length === 0, `phone, room of the owner: targets have 44 pixels and fit the page ${problems.join('; ')}`);
  await take(phone, 'room-phone-owner');
}
