// Drags a rope of the playground with the mouse, and cuts it.

const ROPE = 0; // the first rope of the scene

const pointsOf = (page) => page.evaluate((index) => window.jostle.pointsOf(index), ROPE);
const middleOf = (points) => {
  const k = 3 * Math.floor(points.length / 6);
  return points.slice(k, k + 3);
};
const screen = (page, point) => page.evaluate((p) => window.jostle.toScreen(...p), point);

export async function testDeformables({ page, url, until, expect, takeScreenshot }) {
  await page.goto(`${url}/?quality=low&world=swings`);
  await until('the ropes are rendered', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.pointsOf(0) !== undefined));
  const count = await page.evaluate(() => window.jostle.pointObjectCount);
  await page.keyboard.press('1');
  let shown = { x: 0, y: 0 };
  await until('the camera rests', async () => {
    const last = shown;
    shown = await screen(page, [0, 2, 0]);
    await page.waitForTimeout(200);
    return Math.hypot(shown.x - last.x, shown.y - last.y) < 0.5;
  });
  const before = middleOf(await pointsOf(page));
  const from = await screen(page, before);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let k = 1; k <= 10; k++) await page.mouse.move(from.x + 8 * k, from.y - 2 * k);
  const moved = await until('the rope follows the mouse', async () => {
    const at = middleOf(await pointsOf(page));
    const distance = Math.hypot(at[0] - before[0], at[1] - before[1], at[2] - before[2]);
    return distance > 0.15 && distance;
  });
  if (takeScreenshot) await takeScreenshot('rope');
  await page.mouse.up();
  expect(true, `the mouse drags a rope by ${moved.toFixed(2)} m`);

  await page.keyboard.press('9');
  await until('the cut is made', async () => {
    const at = await screen(page, middleOf(await pointsOf(page)));
    await page.mouse.click(at.x, at.y);
    return page.evaluate((ropes) => window.jostle.pointObjectCount > ropes, count);
  });
  expect(true, 'the tool "Cut" cuts the rope in two');
}
