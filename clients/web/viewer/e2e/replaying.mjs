// Somebody opens a recording: it plays, the slider goes to another moment and back, space holds it; dropped as a file it plays as well.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const file = readFileSync(fileURLToPath(new URL('../../sdk/src/testing/machines.rec', import.meta.url)));

export async function replaying({ page, url, until, expect, shoot }) {
  await page.route('**/machines.rec', (route) => route.fulfill({ body: file, contentType: 'application/octet-stream' }));
  await page.goto(`${url}/?quality=low&recording=machines.rec`);
  const tick = () => page.evaluate(() => window.jostle?.recording?.tick ?? 0);
  await until('the recording plays', async () => (await tick()) > 200);
  const poses = () => page.evaluate(() => JSON.stringify(window.jostle.loose().map((id) => window.jostle.pose(id))));
  const at = async (seconds) => {
    await page.locator('#timeline input').fill(String(seconds));
    await until(`second ${seconds} is shown`, () => page.evaluate((s) => Math.abs(window.jostle.recording.seconds - s) < 0.02, seconds));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    return poses();
  };
  await page.locator('#timeline button', { hasText: 'Pause' }).click();
  const late = await at(5);
  const early = await at(1);
  expect(early !== late, 'the slider shows other moments');
  expect((await at(5)) === late, 'and the same moment again');
  const words = await page.locator('#timeline output').textContent();
  expect(words === '5.0 / 6.0 s · tick 491', `the timeline says ${words}`);
  expect(await page.locator('#tools').isHidden(), 'what was recorded cannot be pushed');
  if (shoot) await shoot('recording');

  await page.goto(`${url}/?quality=low`);
  await until('a live world plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 10));
  await page.evaluate((base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], 'machines.rec'));
    dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
  }, file.toString('base64'));
  await until('the dropped recording plays', async () => (await tick()) > 200);
  expect(true, 'a recording that is dropped on the page plays');
}
