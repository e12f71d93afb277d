// Prediction over a network with 400 ms latency: with ?predict=1 a dragged box and a walking character
// move before the server can have received the input.

const ROUND_TRIP_MS = 800;
const FRAME_RATE_MIN = 8; // per second: at a lower rate, the measured delays are meaningless
const ATTEMPTS = 3; // the machine may be busy for a short time

const towerBoxes = (page) => page.evaluate(() => window.jostle.dynamicBodies().filter((id) => window.jostle.entityName(id) === 'tower'));

const measureFrameRate = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) => {
        let frames = 0;
        const start = performance.now();
        const count = () => {
          frames++;
          const elapsed = performance.now() - start;
          if (elapsed > 2000) resolve((1000 * frames) / elapsed);
          else requestAnimationFrame(count);
        };
        requestAnimationFrame(count);
      }),
  );

async function joinWithPrediction(page, url, until) {
  await page.goto(`${url}/?quality=low&predict=1&latency_ms=${ROUND_TRIP_MS / 2}`);
  await until('the predictor is loaded', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.prediction));
  await until('the tower is rendered', async () => {
    const ids = await towerBoxes(page);
    return ids.length > 0 && page.evaluate((all) => all.every((id) => window.jostle.poseOf(id)), ids);
  });
  await until('the input clock runs', () => page.evaluate(() => window.jostle.inputTick > 0));
}

/**
 * Stores in window.measured: the time from the next event to the first rendered displacement, and the
 * prediction state then.
 */
const measureResponse = (page, body, event, minDistance) =>
  page.evaluate(
    ([id, eventName, distance]) => {
      const measured = (window.measured = { movedMs: 0, prediction: undefined });
      const start = () => {
        const startMs = performance.now();
        const initial = window.jostle.poseOf(id);
        const check = () => {
          const pose = window.jostle.poseOf(id);
          if (Math.hypot(pose[0] - initial[0], pose[1] - initial[1], pose[2] - initial[2]) <= distance) return requestAnimationFrame(check);
          measured.prediction = window.jostle.prediction;
          measured.movedMs = performance.now() - startMs;
        };
        check();
      };
      addEventListener(eventName, start, { capture: true, once: true });
    },
    [body, event, minDistance],
  );

async function dragTopBox(page, until) {
  const box = (await page.evaluate((ids) => ids.sort((a, b) => window.jostle.poseOf(b)[1] - window.jostle.poseOf(a)[1]), await towerBoxes(page)))[0];
  const position = await page.evaluate((id) => window.jostle.screenPosition(id), box);
  await measureResponse(page, box, 'pointerdown', 0.02);
  await page.mouse.move(position.x, position.y);
  await page.mouse.down();
  for (let i = 1; i <= 30; i++) {
    await page.mouse.move(position.x - 6 * i, position.y - 3 * i);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  const { movedMs, prediction } = await until('the dragged box moves', () => page.evaluate(() => window.measured.movedMs && window.measured));
  await page.mouse.up();
  return { movedMs, prediction, isFollowed: prediction?.followed === box };
}

async function walk(page, url, until) {
  await page.goto(`${url}/?quality=low&predict=1&latency_ms=${ROUND_TRIP_MS / 2}&world=parkour`);
  await until('the predictor is loaded in parkour', () =>
    page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.prediction && window.jostle.controllableEntities().length > 0),
  );
  await until('the input clock runs', () => page.evaluate(() => window.jostle.inputTick > 0));
  await page.keyboard.press('8');
  await page.locator('#driver button', { hasText: /^walker5$/ }).click();
  await until('walker5 is controlled and predicted', () => page.evaluate(() => window.jostle.controlledEntity && window.jostle.prediction.controlUpdates > 3));
  await measureResponse(page, await page.evaluate(() => window.jostle.controlledEntity), 'keydown', 0.05);
  await page.keyboard.down('w');
  const measured = await until('the character walks', () => page.evaluate(() => window.measured.movedMs && window.measured));
  await new Promise((resolve) => setTimeout(resolve, 2 * ROUND_TRIP_MS)); // until the server has sent the motion
  await page.keyboard.up('w');
  return { ...measured, after: await page.evaluate(() => window.jostle.prediction) };
}

export async function testPrediction({ page, url, until, expect }) {
  await joinWithPrediction(page, url, until);
  const frameRate = await measureFrameRate(page);
  if (frameRate < FRAME_RATE_MIN) return console.log(`  skipped: prediction needs ${FRAME_RATE_MIN} frames per second; this machine renders ${frameRate.toFixed(1)}`);
  let dragged = await dragTopBox(page, until);
  for (let attempt = 1; attempt < ATTEMPTS && !(dragged.isFollowed && dragged.movedMs < ROUND_TRIP_MS); attempt++) {
    await joinWithPrediction(page, url, until);
    dragged = await dragTopBox(page, until);
  }
  expect(dragged.isFollowed && dragged.prediction.bodies > 1, `the box and ${dragged.prediction.bodies - 1} other bodies are predicted`);
  expect(dragged.movedMs < ROUND_TRIP_MS, `the box moves ${dragged.movedMs.toFixed(0)} ms after the grab, with a round trip of ${ROUND_TRIP_MS} ms`);
  let walked = await walk(page, url, until);
  for (let attempt = 1; attempt < ATTEMPTS && !(walked.movedMs < ROUND_TRIP_MS); attempt++) walked = await walk(page, url, until);
  const { controlUpdates, controlCorrections } = walked.after;
  expect(
    walked.movedMs < ROUND_TRIP_MS,
    `the character walks ${walked.movedMs.toFixed(0)} ms after the key press; ${controlUpdates - controlCorrections} of ${controlUpdates} states match the prediction`,
  );
}
