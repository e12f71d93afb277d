// Playback of a recording: by URL and by drop, with seeking and pausing.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const file = readFileSync(fileURLToPath(new URL('../../sdk/src/testing/machines.rec', import.meta.url)));

export async function testRecording({ page, url, until, expect, takeScreenshot }) {
  await page.route('**/machines.rec', (route) => route.fulfill({ body: file, contentType: 'application/octet-stream' }));
  await page.goto(`${url}/?quality=low&recording=machines.rec`);
  const tick = () => page.evaluate(() => window.jostle?.recording?.tick ?? 0);
  await until('the recording plays', async () => (await tick()) > 200);
  const poses = () => page.evaluate(() => JSON.stringify(window.jostle.dynamicBodies().map((id) => window.jostle.poseOf(id))));
  const posesAt = async (seconds) => {
    await page.locator('#timeline input').fill(String(seconds));
    await until(`second ${seconds} is rendered`, () => page.evaluate((s) => Math.abs(window.jostle.recording.seconds - s) < 0.02, seconds));
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    return poses();
  };
  await page.locator('#timeline button', { hasText: 'Pause' }).click();
  const late = await posesAt(5);
  const early = await posesAt(1);
  expect(early !== late, 'the slider changes the rendered time');
  expect((await posesAt(5)) === late, 'seeking back to a time renders the same poses');
  const label = await page.locator('#timeline output').textContent();
  expect(label === '5.0 / 6.0 s · tick 491', `the timeline shows ${label}`);
  expect(await page.locator('#tools').isHidden(), 'tools are hidden during playback');
  if (takeScreenshot) await takeScreenshot('recording');

  await page.goto(`${url}/?quality=low`);
  await until('a live world plays', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.snapshots > 10));
  await page.evaluate((base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], 'machines.rec'));
    dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
  }, file.toString('base64'));
  await until('the dropped recording plays', async () => (await tick()) > 200);
  expect(true, 'a recording dropped on the page plays');
}
