// Somebody plays: takes the wheel of a car by its button, brakes it, pulls away and sees its wheels turn; walks a character and
// jumps; sees the water of the harbour and drives a boat.

const pose = (page, id) => page.evaluate((of) => window.jostle.pose(of), id);
const apart = (a, b) => Math.hypot(a[0] - b[0], a[2] - b[2]);

async function enter(page, url, world, until) {
  await page.goto(`${url}/?quality=low&world=${world}`);
  await until(`${world} plays and is drawn`, () =>
    page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.controllable().length > 0 && window.jostle.controllable().every((id) => window.jostle.pose(id))),
  );
}

async function takeControl(page, name, until) {
  await page.keyboard.press('8');
  await page.locator('#driver button', { hasText: new RegExp(`^${name}$`) }).click();
  const id = await until(`${name} is driven`, () => page.evaluate(() => window.jostle.driven));
  await until('the line says what the keys do', async () => / · Esc lets go/.test(await page.locator('#driver').textContent()));
  return id;
}

export async function playing({ page, url, until, expect, shoot }) {
  await enter(page, url, 'race_track', until);
  expect((await page.evaluate(() => window.jostle.controllable().length)) === 6, 'six cars can be driven');
  const car = await takeControl(page, 'car', until);
  await page.keyboard.down(' ');
  await until('the hand brake stops the car', async () => /· [0-2] km\/h/.test(await page.locator('#driver').textContent()));
  await page.keyboard.up(' ');
  const stood = await pose(page, car);
  // A spoke of its first wheel against the car's own up: it goes round.
  const spoke = () =>
    page.evaluate((id) => {
      const m = window.jostle.solid('box', 0);
      const [, , , x, y, z, w] = window.jostle.pose(id);
      const up = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
      return (m[4] * up[0] + m[5] * up[1] + m[6] * up[2]) / Math.hypot(m[4], m[5], m[6]);
    }, car);
  let [low, high] = [1, -1];
  await page.keyboard.down('w');
  const way = await until('the car is driven more than 5 m, and its wheels turn', async () => {
    const angle = await spoke();
    [low, high] = [Math.min(low, angle), Math.max(high, angle)];
    const now = apart(await pose(page, car), stood);
    return now > 5 && high - low > 0.5 && now;
  });
  if (shoot) await shoot('driving');
  await page.keyboard.up('w');
  expect(true, `the throttle moved the car ${way.toFixed(1)} m, and its wheels turned`);
  await page.keyboard.press('Escape');
  await until('Esc lets go', () => page.evaluate(() => window.jostle.driven === 0));

  await enter(page, url, 'parkour', until);
  const walker = await takeControl(page, 'walker1', until);
  const began = await pose(page, walker);
  await page.keyboard.down('w');
  const walked = await until('the character walks more than 3 m', async () => {
    const now = apart(await pose(page, walker), began);
    return now > 3 && now;
  });
  await page.keyboard.up('w');
  const ground = (await pose(page, walker))[1];
  await page.keyboard.down(' ');
  await until('it jumps', async () => (await pose(page, walker))[1] > ground + 0.4);
  await page.keyboard.up(' ');
  expect((await page.evaluate(() => window.jostle.moduleSolids())) >= 5 * 6, `the character walked ${walked.toFixed(1)} m and jumped; all have faces`);

  await enter(page, url, 'harbour', until);
  const boat = await takeControl(page, 'boat', until);
  const moored = await pose(page, boat);
  await page.keyboard.down('w');
  const out = await until('the boat leaves by more than 3 m', async () => {
    const now = apart(await pose(page, boat), moored);
    return now > 3 && now;
  });
  await page.keyboard.up('w');
  if (shoot) await shoot('harbour');
  const waters = () => page.evaluate(() => window.jostle.waters(0, 0));
  const [height, ...others] = await waters();
  expect(height !== undefined && others.length === 0, `the boat went ${out.toFixed(1)} m through water that is drawn`);
  const rose = await until('the waves move', async () => {
    const now = (await waters())[0] - height;
    return Math.abs(now) > 0.05 && now;
  });
  expect(true, `the waves rose or fell by ${Math.abs(rose).toFixed(2)} m`);
}
