// Somebody drags a box over a link of 400 ms each way, and with ?predict=1 sees it move before the server can have heard of it.

const ROUND_TRIP_MS = 800;

const towers = (page) => page.evaluate(() => window.jostle.loose().filter((id) => window.jostle.nameOf(id) === 'tower'));

export async function predicting({ page, url, until, expect }) {
  await page.goto(`${url}/?quality=low&predict=1&delay=${ROUND_TRIP_MS / 2}`);
  await until('the viewer plays and has its predictor', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.foreseen));
  await until('the tower is drawn', async () => {
    const ids = await towers(page);
    return ids.length > 0 && page.evaluate((all) => all.every((id) => window.jostle.pose(id)), ids);
  });
  await until('the clock of inputs runs', () => page.evaluate(() => window.jostle.inputTick > 0));
  const box = (await page.evaluate((ids) => ids.sort((a, b) => window.jostle.pose(b)[1] - window.jostle.pose(a)[1]), await towers(page)))[0];
  const at = await page.evaluate((id) => window.jostle.screen(id), box);
  // When the button went down, and when the box was first drawn 20 mm from where it stood.
  await page.evaluate((id) => {
    const seen = (window.seen = { movedMs: 0, stepM: 0 });
    addEventListener('pointerdown', () => {
      const began = performance.now();
      const stood = window.jostle.pose(id);
      let last = stood;
      const look = () => {
        const now = window.jostle.pose(id);
        const way = (from) => Math.hypot(now[0] - from[0], now[1] - from[1], now[2] - from[2]);
        if (seen.movedMs === 0 && way(stood) > 0.02) seen.movedMs = performance.now() - began;
        seen.stepM = Math.max(seen.stepM, way(last));
        last = now;
        requestAnimationFrame(look);
      };
      look();
    }, { capture: true, once: true });
  }, box);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  for (let i = 1; i <= 30; i++) {
    await page.mouse.move(at.x - 6 * i, at.y - 3 * i);
    await new Promise((done) => setTimeout(done, 30));
  }
  const movedMs = await until('the dragged box moves', () => page.evaluate(() => window.seen.movedMs));
  const foreseen = await page.evaluate(() => window.jostle.foreseen);
  expect(foreseen.followed === box && foreseen.bodies > 0, `the box and ${foreseen.bodies - 1} others are foreseen`);
  expect(movedMs < ROUND_TRIP_MS, `the box moved ${movedMs.toFixed(0)} ms after it was taken, over a round trip of ${ROUND_TRIP_MS} ms`);
  await page.mouse.up();
  await until('frames of the server were compared', () => page.evaluate(() => window.jostle.foreseen.frames > 60));
  const after = await page.evaluate(() => window.jostle.foreseen);
  expect(true, `${after.corrections} of ${after.frames} frames corrected what was foreseen, the last by ${(1000 * after.lastErrorM).toFixed(1)} mm`);
}
