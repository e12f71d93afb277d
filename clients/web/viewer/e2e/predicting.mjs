// Somebody drags a box over a link of 400 ms each way, and with ?predict=1 sees it move before the server can have heard of it.

const ROUND_TRIP_MS = 800;
const PICTURES_LEAST = 8; // a second: with fewer, seeing at once means nothing, and what is sent is late by any amount
const ATTEMPTS = 3; // a machine may be busy for a moment

const towers = (page) => page.evaluate(() => window.jostle.loose().filter((id) => window.jostle.nameOf(id) === 'tower'));

const picturesPerSecond = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        let pictures = 0;
        const began = performance.now();
        const count = () => {
          pictures++;
          const passed = performance.now() - began;
          if (passed > 2000) done((1000 * pictures) / passed);
          else requestAnimationFrame(count);
        };
        requestAnimationFrame(count);
      }),
  );

async function enter(page, url, until) {
  await page.goto(`${url}/?quality=low&predict=1&delay=${ROUND_TRIP_MS / 2}`);
  await until('the viewer plays and has its predictor', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.prediction));
  await until('the tower is drawn', async () => {
    const ids = await towers(page);
    return ids.length > 0 && page.evaluate((all) => all.every((id) => window.jostle.pose(id)), ids);
  });
  await until('the clock of inputs runs', () => page.evaluate(() => window.jostle.inputTick > 0));
}

/** In window.seen: how long after the next event of that kind a body was first drawn so many m from where it was, and what was foreseen then. */
const watch = (page, body, event, least) =>
  page.evaluate(
    ([id, kind, way]) => {
      const seen = (window.seen = { movedMs: 0, prediction: undefined });
      const begin = () => {
        const began = performance.now();
        const stood = window.jostle.pose(id);
        const look = () => {
          const now = window.jostle.pose(id);
          if (Math.hypot(now[0] - stood[0], now[1] - stood[1], now[2] - stood[2]) <= way) return requestAnimationFrame(look);
          seen.prediction = window.jostle.prediction;
          seen.movedMs = performance.now() - began;
        };
        look();
      };
      addEventListener(kind, begin, { capture: true, once: true });
    },
    [body, event, least],
  );

/** How long after it was taken the box was seen to move, and what was foreseen then. */
async function drag(page, until) {
  const box = (await page.evaluate((ids) => ids.sort((a, b) => window.jostle.pose(b)[1] - window.jostle.pose(a)[1]), await towers(page)))[0];
  const at = await page.evaluate((id) => window.jostle.screen(id), box);
  await watch(page, box, 'pointerdown', 0.02);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  for (let i = 1; i <= 30; i++) {
    await page.mouse.move(at.x - 6 * i, at.y - 3 * i);
    await new Promise((done) => setTimeout(done, 30));
  }
  const { movedMs, prediction } = await until('the dragged box moves', () => page.evaluate(() => window.seen.movedMs && window.seen));
  await page.mouse.up();
  return { movedMs, prediction, isOurs: prediction?.followed === box };
}

/** How long after the key the character was seen to walk, and what was foreseen then. */
async function walk(page, url, until) {
  await page.goto(`${url}/?quality=low&predict=1&delay=${ROUND_TRIP_MS / 2}&world=parkour`);
  await until('the viewer plays parkour and has its predictor', () =>
    page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.prediction && window.jostle.controllable().length > 0),
  );
  await until('the clock of inputs runs', () => page.evaluate(() => window.jostle.inputTick > 0));
  await page.keyboard.press('8');
  await page.locator('#driver button', { hasText: /^walker5$/ }).click();
  await until('walker5 is driven and foreseen', () => page.evaluate(() => window.jostle.driven && window.jostle.prediction.drives > 3));
  await watch(page, await page.evaluate(() => window.jostle.driven), 'keydown', 0.05);
  await page.keyboard.down('w');
  const seen = await until('it walks', () => page.evaluate(() => window.seen.movedMs && window.seen));
  await new Promise((done) => setTimeout(done, 2 * ROUND_TRIP_MS)); // until the server has told of it
  await page.keyboard.up('w');
  return { ...seen, after: await page.evaluate(() => window.jostle.prediction) };
}

export async function predicting({ page, url, until, expect }) {
  await enter(page, url, until);
  const pictures = await picturesPerSecond(page);
  if (pictures < PICTURES_LEAST) return console.log(`  skipped: ${pictures.toFixed(1)} pictures a second are too few to see at once what is dragged`);
  let seen = await drag(page, until);
  for (let attempt = 1; attempt < ATTEMPTS && !(seen.isOurs && seen.movedMs < ROUND_TRIP_MS); attempt++) {
    await enter(page, url, until);
    seen = await drag(page, until);
  }
  expect(seen.isOurs && seen.prediction.bodies > 1, `the box and ${seen.prediction.bodies - 1} others are prediction`);
  expect(seen.movedMs < ROUND_TRIP_MS, `the box moved ${seen.movedMs.toFixed(0)} ms after it was taken, over a round trip of ${ROUND_TRIP_MS} ms`);
  let walked = await walk(page, url, until);
  for (let attempt = 1; attempt < ATTEMPTS && !(walked.movedMs < ROUND_TRIP_MS); attempt++) walked = await walk(page, url, until);
  const { drives, controlCorrections } = walked.after;
  expect(walked.movedMs < ROUND_TRIP_MS, `the character walked ${walked.movedMs.toFixed(0)} ms after the key; ${drives - controlCorrections} of ${drives} times the server said what was prediction`);
}
