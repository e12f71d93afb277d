// The monitor page: lists worlds and clients, shows traffic and the log, pauses a world, and kicks a
// client.

export async function testMonitor({ browser, page, url, until, expect, takeScreenshot }) {
  await page.goto(`${url}/?quality=low&world=sandbox`);
  await until('the viewer plays', () => page.evaluate(() => window.jostle?.state === 'playing'));
  const monitor = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  const errors = [];
  monitor.on('pageerror', (error) => errors.push(String(error)));
  monitor.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  monitor.on('dialog', (dialog) => void dialog.accept('for a test'));
  await monitor.goto(`${url}/monitor.html`);
  const world = monitor.locator('#worlds tr', { hasText: 'sandbox' }).first();
  await until('the monitor lists the world', async () => (await world.count()) > 0);
  const client = monitor.locator('#clients tr', { hasText: 'tester' });
  await until('the monitor lists the client', async () => (await client.count()) > 0);
  const poses = monitor.locator('#counters tr', { hasText: 'poses' });
  await until('poses have a rate', async () => /[1-9]/.test((await poses.locator('td').nth(2).textContent().catch(() => '')) ?? ''));
  expect((await monitor.locator('#log li').count()) > 0, 'the monitor shows the log');
  if (takeScreenshot) await monitor.screenshot({ path: takeScreenshot });

  await world.getByRole('button', { name: 'Pause' }).click();
  await until('the world is paused', async () => /paused/.test((await world.textContent().catch(() => '')) ?? ''));
  await monitor.mouse.move(0, 0);
  await world.getByRole('button', { name: 'Resume' }).click();
  await monitor.mouse.move(0, 0);
  await until('the world runs', async () => /runs/.test((await world.textContent().catch(() => '')) ?? ''));

  await client.getByRole('button', { name: 'Kick' }).click();
  await until('the client was removed', () => page.evaluate(() => window.jostle.state !== 'playing'));
  expect(errors.length === 0, `the monitor page has no errors: ${errors.join('; ')}`);
  await monitor.close();
}
