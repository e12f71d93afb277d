// Controlling entities: takes control of a car by its button, brakes, accelerates and checks that its
// wheels turn; walks and jumps with a character; drives a boat through rendered water.

const poseOf = (page, id) => page.evaluate((entity) => window.jostle.poseOf(entity), id);
const horizontalDistance = (a, b) => Math.hypot(a[0] - b[0], a[2] - b[2]);

async function joinWorld(page, url, world, until) {
  await page.goto(`${url}/?quality=low&world=${world}`);
  await until(`${world} is rendered`, () =>
    page.evaluate(() => {
      const { state, controllableEntities, poseOf } = window.jostle ?? {};
      return state === 'playing' && controllableEntities().length > 0 && controllableEntities().every((id) => poseOf(id));
    }),
  );
}

async function takeControl(page, name, until) {
  await page.keyboard.press('8');
  await page.locator('#driver button', { hasText: new RegExp(`^${name}$`) }).click();
  const id = await until(`${name} is controlled`, () => page.evaluate(() => window.jostle.controlledEntity));
  await until('the panel shows the keys', async () => / · Esc releases/.test(await page.locator('#driver').textContent()));
  return id;
}

export async function testControl({ page, url, until, expect, takeScreenshot }) {
  await joinWorld(page, url, 'race_track', until);
  expect((await page.evaluate(() => window.jostle.controllableEntities().length)) === 6, 'six cars are controllable');
  const car = await takeControl(page, 'car', until);
  await page.keyboard.down(' ');
  await until('the hand brake stops the car', async () => /· [0-2] km\/h/.test(await page.locator('#driver').textContent()));
  await page.keyboard.up(' ');
  const carStart = await poseOf(page, car);
  // Component of a spoke of the first wheel along the car's up axis: it changes while the wheel turns.
  const spokeHeight = () =>
    page.evaluate((id) => {
      const m = window.jostle.moduleSolidMatrix('box', 0);
      const [, , , x, y, z, w] = window.jostle.poseOf(id);
      const up = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
      return (m[4] * up[0] + m[5] * up[1] + m[6] * up[2]) / Math.hypot(m[4], m[5], m[6]);
    }, car);
  let [low, high] = [1, -1];
  await page.keyboard.down('w');
  const driven = await until('the car moves more than 5 m with turning wheels', async () => {
    const height = await spokeHeight();
    [low, high] = [Math.min(low, height), Math.max(high, height)];
    const distance = horizontalDistance(await poseOf(page, car), carStart);
    return distance > 5 && high - low > 0.5 && distance;
  });
  if (takeScreenshot) await takeScreenshot('driving');
  await page.keyboard.up('w');
  expect(true, `the throttle moves the car ${driven.toFixed(1)} m with turning wheels`);
  await page.keyboard.press('Escape');
  await until('Esc releases the car', () => page.evaluate(() => window.jostle.controlledEntity === 0));

  await joinWorld(page, url, 'parkour', until);
  const walker = await takeControl(page, 'walker1', until);
  const walkerStart = await poseOf(page, walker);
  await page.keyboard.down('w');
  const walked = await until('the character walks more than 3 m', async () => {
    const distance = horizontalDistance(await poseOf(page, walker), walkerStart);
    return distance > 3 && distance;
  });
  await page.keyboard.up('w');
  const ground = (await poseOf(page, walker))[1];
  // A jump takes 0.7 s: a slow page may miss one.
  await until('the character jumps', async () => {
    await page.keyboard.up(' ');
    await page.keyboard.down(' ');
    for (let k = 0; k < 6; k++) {
      if ((await poseOf(page, walker))[1] > ground + 0.4) return true;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    return false;
  });
  await page.keyboard.up(' ');
  expect(
    (await page.evaluate(() => window.jostle.moduleSolidCount())) >= 5 * 6,
    `the character walks ${walked.toFixed(1)} m and jumps; all characters have faces`,
  );

  await joinWorld(page, url, 'harbour', until);
  const boat = await takeControl(page, 'boat', until);
  const boatStart = await poseOf(page, boat);
  await page.keyboard.down('w');
  const sailed = await until('the boat moves more than 3 m', async () => {
    const distance = horizontalDistance(await poseOf(page, boat), boatStart);
    return distance > 3 && distance;
  });
  await page.keyboard.up('w');
  if (takeScreenshot) await takeScreenshot('harbour');
  const waterHeights = () => page.evaluate(() => window.jostle.waterHeights(0, 0));
  const [height, ...otherSurfaces] = await waterHeights();
  expect(height !== undefined && otherSurfaces.length === 0, `the boat moves ${sailed.toFixed(1)} m through rendered water`);
  const change = await until('the waves move', async () => {
    const difference = (await waterHeights())[0] - height;
    return Math.abs(difference) > 0.05 && difference;
  });
  expect(true, `the water height changes by ${Math.abs(change).toFixed(2)} m`);
}
