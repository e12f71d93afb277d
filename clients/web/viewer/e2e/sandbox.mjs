// The sandbox tools on a wide page and a phone: pause, single step and slow motion, the inspector of a body
// and of a joint, editing, freezing, cloning and undo, the joint tool, options of spawned bodies, plots with
// a cursor and CSV, a timeline, and a joint that breaks and disappears.

import { readFileSync } from 'node:fs';
import { checkAccessibility, layoutProblems } from './acceptance.mjs';
import { setName } from './chromium.mjs';

const WIDE = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };
const TARGET_MIN = 44; // pixels

const vec = (x, y, z) => ({ x, y, z });
const box = (name, position, half, more = {}) => ({ name, position, shapes: [{ box: { halfExtents: vec(half, half, half) } }], ...more });

/** A crate, a stack, and a weight on a joint that breaks at 2,500 N; builders may do everything. */
export const workshop = (room) => ({
  name: 'workshop',
  view: { eye: vec(0, 4, 12), target: vec(0, 1.5, 0), fieldOfView: 0.8 },
  ...(room ? { room } : {}),
  bodies: [
    { name: 'floor', type: 'BODY_TYPE_STATIC', shapes: [{ plane: {} }] },
    { name: 'beam', type: 'BODY_TYPE_STATIC', position: vec(-3, 4.4, 0), shapes: [{ box: { halfExtents: vec(1.5, 0.15, 0.3) } }] },
    box('crate', vec(0, 0.5, 0), 0.5),
    box('stack', vec(2.5, 0.5, 0), 0.5, { repeat: [{ count: 3, offset: vec(0, 1.01, 0) }] }),
    box('weight', vec(-3, 2, 0), 0.25),
  ],
  joints: [{ bodyA: 'beam', bodyB: 'weight', frame: { position: vec(-3, 3.2, 0) }, ball: {}, breakForce: 2500 }],
});

export async function testSandbox({ browser, url, post, until, expect, screenshot }) {
  const permissions = Object.fromEntries(['reset', 'rewind', 'edit', 'clone', 'joints', 'delete', 'speed', 'pause'].map((action) => [`builder.${action}`, 'any']));
  const room = { title: 'Workshop', initialRole: 'builder', permissions, timelineSeconds: 60 };
  const created = await post('/api/worlds', { name: 'workshop', scene: workshop(room) });
  expect(created.ok, `the workshop is created${created.ok ? '' : `: ${await created.text()}`}`);
  const errors = [];
  const open = async (options) => {
    const context = await browser.newContext({ acceptDownloads: true, ...options });
    await setName(context);
    const page = await context.newPage();
    page.setDefaultTimeout(60_000);
    page.on('pageerror', (error) => errors.push(String(error)));
    await page.goto(`${url}/?world=workshop&quality=low`);
    await until('the workshop is rendered', () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.dynamicBodies().length >= 5 && window.jostle.dynamicBodies().every((id) => window.jostle.poseOf(id))));
    return page;
  };
  const wide = await open({ viewport: WIDE });
  const take = async (page, name) => screenshot && (await page.screenshot({ path: screenshot(name), timeout: 60_000 }));
  try {
    const tools = { page: wide, until, expect, take, ...helpersOf(wide, until) };
    await testInspector(tools);
    await testAttributes(tools);
    await testEditing(tools);
    await testJointTool(tools);
    await testBreakingJoint(tools);
    await testPlots(tools);
    await testTime(tools);
    const phone = await open({ viewport: PHONE, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
    await testPhonePanels({ page: phone, until, expect, take, ...helpersOf(phone, until) });
    await phone.context().close();
    expect(errors.length === 0, `both pages have no errors ${errors.join('; ')}`);
  } finally {
    await wide.context().close();
  }
}

export function helpersOf(page, until) {
  const idsOf = (name) => page.evaluate((wanted) => window.jostle.dynamicBodies().filter((id) => window.jostle.entityName(id) === wanted).sort((a, b) => a - b), name);
  const get = (name) => page.evaluate((member) => window.jostle[member], name);
  const clickBody = async (id) => {
    const at = await page.evaluate((body) => window.jostle.screenPosition(body), id);
    await page.mouse.click(at.x, at.y);
  };
  /** The value of a row of the inspector. */
  const row = (label) => page.evaluate((wanted) => [...document.querySelectorAll('#inspector dt')].find((dt) => dt.textContent === wanted)?.nextElementSibling.textContent, label);
  const openPanel = async (key, id) => {
    if (!(await page.locator(`#${id}`).isVisible())) await page.keyboard.press(key);
    await until(`the panel ${id} is loaded`, () => page.locator(`#${id} .body > div`).count());
  };
  return { idsOf, get, clickBody, row, openPanel };
}

export async function testInspector({ page, until, expect, take, idsOf, get, clickBody, row }) {
  const [lowest] = await idsOf('stack');
  await page.keyboard.press('0');
  await clickBody(lowest);
  await until('the body is selected', async () => (await get('selected'))?.id === lowest);
  await until('the server sends its state', async () => (await get('inspected'))?.mass > 0);
  expect((await row('Mass')) === '1000 kg', `the inspector shows the mass ${await row('Mass')}`);
  // The ground carries three boxes, the lowest box carries two.
  const ratio = await until('the contact forces are those of the stack', async () => {
    const sums = ((await get('inspected'))?.contacts ?? []).map(({ points }) => points.reduce((sum, { impulse }) => sum + impulse, 0)).sort((a, b) => b - a);
    return sums.length === 2 && Math.abs(sums[0] / sums[1] - 1.5) < 0.05 && sums[0] / sums[1];
  });
  expect(/^2 · [\d.]+ N in total$/.test(await row('Contacts')), `the ground carries ${ratio.toFixed(2)} times the load of the lowest box: ${await row('Contacts')}`);
  await until('arrows are drawn', async () => (await get('selectionVertexCount')) >= 24 + 8 * 6);
  expect(true, 'an outline and eight arrows mark the body and its contact forces');
  await take(page, 'sandbox-inspector');
  for (const theme of ['light', 'dark']) {
    await page.keyboard.press('t');
    await checkAccessibility(page, `inspector, ${theme} theme`, expect);
  }
}

/** Attributes of each type: added, changed, refused at their field, and removed. */
export async function testAttributes({ page, until, expect, idsOf, get, clickBody, take }) {
  const [crate] = await idsOf('crate');
  await page.keyboard.press('0');
  await clickBody(crate);
  await until('the crate is selected', async () => (await get('selected'))?.id === crate);
  const editor = page.locator('#inspector .attributes');
  expect(/no attributes/.test(await editor.locator('.note').textContent()), 'a body without attributes says so');
  const attributes = () => page.evaluate((id) => window.jostle.attributesOf(id), crate);
  const add = async (key, type, value) => {
    await editor.locator('input[name=key]').fill(key);
    await editor.locator('select[name=type]').selectOption(type);
    const field = editor.locator('[name=value]');
    if (type === 'boolean') await field.selectOption(value);
    else await field.fill(value);
    await editor.locator('button', { hasText: 'Add' }).click();
  };
  await add('open', 'boolean', 'true');
  await add('hp', 'integer', '40');
  await add('weight.factor', 'number', '0.25');
  await add('label', 'text', 'fragile שביר');
  await add('home', 'vector', '1, 2.5, -3');
  const expected = { open: true, hp: 40, 'weight.factor': 0.25, label: 'fragile שביר', home: { x: 1, y: 2.5, z: -3 } };
  const same = (got) => Object.entries(expected).every(([key, value]) => (typeof value === 'object' ? ['x', 'y', 'z'].every((axis) => got[key]?.[axis] === value[axis]) : got[key] === value));
  await until('attributes of five types are set', async () => same(await attributes()));
  expect((await editor.locator('.attribute').count()) === 5, 'the inspector shows five attributes');
  await add('hp', 'integer', '7');
  expect(/exists/.test(await editor.locator('form .problem').first().textContent()), 'a key that exists is refused at its field');
  await editor.locator('input[name=key]').fill('');
  const hp = editor.locator(`[id="attribute-${crate}-hp"]`);
  await hp.fill('many');
  await hp.press('Tab');
  expect(/whole number/.test(await editor.locator('.attribute .problem').filter({ hasText: /./ }).textContent()) && (await hp.getAttribute('aria-invalid')) === 'true', 'a value of another type is refused at its field');
  await take(page, 'sandbox-attributes');
  await checkAccessibility(page, 'attributes with a problem', expect);
  await hp.fill('41');
  await hp.press('Tab');
  await until('the server changes the integer', async () => (await attributes()).hp === 41);
  const label = editor.locator(`[id="attribute-${crate}-label"]`);
  await label.fill('w'.repeat(300));
  await label.press('Tab');
  const problem = await until('the server refuses the text', () => editor.locator('.attribute .problem').filter({ hasText: /./ }).first().textContent({ timeout: 500 }).catch(() => ''));
  expect(/300/.test(problem) && /256/.test(problem), `its reason is at the field: ${problem}`);
  expect((await label.getAttribute('aria-invalid')) === 'true' && (await attributes()).label === expected.label, 'and the attribute is unchanged');
  await label.press('Escape');
  expect((await label.inputValue()) === expected.label, 'Esc restores the value');
  for (const key of Object.keys(expected)) await editor.locator(`button[aria-label="Remove ${key}"]`).click();
  await until('the attributes are removed', async () => Object.keys(await attributes()).length === 0);
  expect((await editor.locator('.attribute').count()) === 0, 'attributes are added, changed and removed');
  await page.evaluate(() => document.activeElement?.blur());
}

export async function testEditing({ page, until, expect, idsOf, get, clickBody, take }) {
  const [crate] = await idsOf('crate');
  const yOf = (id) => page.evaluate((body) => window.jostle.poseOf(body)?.[1], id);
  await page.keyboard.press('0');
  await clickBody(crate);
  await until('the crate is selected', async () => (await get('selected'))?.id === crate);
  await until('the crate is inspected', async () => (await get('inspected'))?.mass === 1000);
  await page.locator('#inspector summary').click();
  const mass = page.locator('#inspector details input').first();
  await mass.fill('250');
  await mass.press('Enter');
  await until('the server changes the mass', async () => (await get('inspected'))?.mass === 250);
  await take(page, 'sandbox-edit');
  await page.locator('#inspector summary').click();
  await page.evaluate(() => document.activeElement?.blur());
  const count = (await get('entityCount'));
  await page.keyboard.press('v');
  await until('the clone appears', async () => (await get('entityCount')) === count + 1);
  const clone = await until('the clone is above the crate', async () => {
    const ids = await page.evaluate(() => window.jostle.dynamicBodies());
    return Math.max(...ids);
  });
  await page.keyboard.press('z');
  await until('undo removes the clone', async () => (await get('entityCount')) === count);
  expect(clone > crate, 'undo reverts the clone');
  await page.keyboard.press('z');
  await until('undo restores the mass', async () => (await get('inspected'))?.mass === 1000);
  expect(true, 'undo reverts the edit of the mass');
  await page.keyboard.press('x');
  await until('the crate is frozen', async () => (await get('inspected'))?.frozen === true);
  expect((await page.locator('#inspector button', { hasText: 'Unfreeze' }).count()) === 1, 'a frozen body can be unfrozen');
  await page.keyboard.press('x');
  await until('the crate moves again', async () => (await get('inspected'))?.frozen === false);
  // A changed entity has no pose until the next rendered frame.
  const y = await until('the crate is rendered', () => yOf(crate));
  expect(Math.abs(y - 0.5) < 0.05, 'freezing does not move the crate');

  // A spawned body has the chosen size, mass and material.
  await page.keyboard.press('b');
  await until('the options are loaded', () => page.locator('#build input[name=size]').count());
  await page.locator('#build input[name=size]').fill('1.2');
  await page.locator('#build select[name=material]').selectOption('steel');
  await page.locator('#build input[name=mass]').fill('77');
  await page.locator('#build input[name=mass]').press('Tab');
  await take(page, 'sandbox-build');
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press('3');
  const at = await page.evaluate(() => window.jostle.toScreen(0, 0, 3));
  await page.mouse.click(at.x, at.y);
  const spawned = await until('a box is spawned', () => page.evaluate((n) => window.jostle.entityCount === n + 1 && Math.max(...window.jostle.dynamicBodies()), count));
  await page.keyboard.press('0');
  await until('the box is rendered', () => page.evaluate((id) => window.jostle.poseOf(id) !== undefined, spawned));
  await clickBody(spawned);
  await until('the box is inspected', async () => (await get('inspected'))?.entity === spawned);
  const { mass: spawnedMass, materials } = await get('inspected');
  expect(Math.abs(spawnedMass - 77) < 1e-6 && Math.abs(materials[0].friction - 0.3) < 1e-6, `the spawned box has ${spawnedMass} kg and friction ${materials[0].friction}`);
  await checkAccessibility(page, 'options of bodies and joints', expect);
  await page.keyboard.press('b');
}

export async function testJointTool({ page, until, expect, idsOf, get, clickBody, take, row }) {
  const before = await page.evaluate(() => window.jostle.jointIds());
  await page.keyboard.press('b');
  await page.locator('#build select[name=joint]').selectOption('rope');
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press('b');
  await page.keyboard.press('j');
  expect(/choose the first point/.test(await page.locator('#tool-hint').textContent()), 'the joint tool tells what to choose');
  const [crate] = await idsOf('crate');
  const stack = await idsOf('stack');
  await clickBody(crate);
  await until('the first end is chosen', async () => /from crate/.test(await page.locator('#tool-hint').textContent()));
  await take(page, 'sandbox-joint-tool');
  await clickBody(stack[0]);
  const created = await until('the joint is created', async () => (await page.evaluate((known) => window.jostle.jointIds().filter((id) => !known.includes(id)), before))[0]);
  // The anchor of the rope is where the stack was clicked.
  await page.keyboard.press('0');
  await clickBody(stack[0]);
  await until('the inspector shows the joint', async () => (await get('selected'))?.id === created || (await page.locator(`#inspector [data-joint="${created}"]`).count()));
  if ((await get('selected')).kind !== 'joint') await page.locator(`#inspector [data-joint="${created}"]`).click();
  await until('the joint is inspected', async () => (await get('inspected'))?.joint?.kind?.case === 'distance');
  expect(/^distance joint/.test(await page.locator('#inspector .title').textContent()), `the inspector shows ${await page.locator('#inspector .title').textContent()}`);
  expect(/you/.test(await row('Owner')), 'the client owns the joint');
  await take(page, 'sandbox-joint');
  await page.locator('#inspector button', { hasText: 'Delete joint' }).click();
  await until('the joint is deleted', () => page.evaluate((id) => !window.jostle.jointIds().includes(id), created));
  expect(true, 'the joint tool joins two bodies, and the inspector deletes the joint');
}

/** Drags the weight, whose joint breaks at 2,500 N, until its joint is gone. */
export async function testBreakingJoint({ page, until, expect, idsOf, get, take }) {
  const [weight] = await idsOf('weight');
  const drawn = await get('jointCount');
  expect(drawn === 1, `${drawn} joint is drawn`);
  await page.keyboard.press('1');
  const at = await page.evaluate((id) => window.jostle.screenPosition(id), weight);
  for (let attempt = 0; attempt < 5 && (await get('jointCount')) > 0; attempt++) {
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    for (let k = 1; k <= 25; k++) {
      await page.mouse.move(at.x - 14 * k, at.y + 4 * k);
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
    await new Promise((resolve) => setTimeout(resolve, 1500));
    await page.mouse.up();
  }
  await until('the joint breaks and disappears', async () => (await get('jointCount')) === 0);
  expect((await page.evaluate(() => window.jostle.jointIds().length)) === 0, 'a joint that breaks is no longer drawn');
  await take(page, 'sandbox-broken-joint');
}

export async function testPlots({ page, until, expect, idsOf, get, clickBody, take }) {
  const [crate] = await idsOf('crate');
  await page.keyboard.press('0');
  await clickBody(crate);
  await until('the crate is selected', async () => (await get('selected'))?.id === crate);
  await page.keyboard.press('g');
  await until('the plots are shown', async () => (await page.locator('#plots figure').count()) === 7);
  const height = page.locator('#plots figure', { hasText: 'Height (m)' });
  await until('the height is plotted', async () => Math.abs(Number(await height.locator('output').textContent()) - 0.5) < 0.02);
  await new Promise((resolve) => setTimeout(resolve, 3000));
  const area = await height.locator('canvas').boundingBox();
  await page.mouse.move(area.x + area.width - 20, area.y + 40);
  await until('the cursor reads a value at a time', async () => /at -\d+\.\d\d s$/.test(await height.locator('output').textContent()));
  await take(page, 'sandbox-plots');
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#plots button', { hasText: 'CSV' }).click()]);
  const lines = readFileSync(await download.path(), 'utf8').trim().split('\r\n');
  expect(lines[0].startsWith('time (s),Height (m),Speed (m/s),Kinetic energy (J),Contact force (N)'), `the CSV file has the columns ${lines[0]}`);
  const forces = lines.slice(1).map((line) => Number(line.split(',')[4])).filter((value) => value > 0);
  expect(forces.length > 3 && forces.at(-1) > 100, `the CSV file has ${lines.length - 1} rows; the last contact force is ${forces.at(-1)} N`);
  await checkAccessibility(page, 'plots', expect);
  await page.mouse.move(700, 300);
  await page.keyboard.press('g');
}

export async function testTime({ page, until, expect, get, openPanel, take, idsOf, clickBody }) {
  await openPanel('y', 'time');
  await page.locator('#time select').selectOption('10');
  await until('the world runs at 10 % speed', async () => (await get('stats')).speedPercent === 10);
  await page.evaluate(() => document.activeElement?.blur());
  const [tick, ms] = [await get('tick'), Date.now()];
  await new Promise((resolve) => setTimeout(resolve, 4000));
  const hz = (1000 * ((await get('tick')) - tick)) / (Date.now() - ms);
  expect(hz > 3 && hz < 9, `slow motion of 10 % simulates ${hz.toFixed(1)} ticks per second`);

  // A clone of the crate falls slowly until the pause.
  const [crate] = await idsOf('crate');
  await page.keyboard.press('0');
  await clickBody(crate);
  await until('the crate is selected', async () => (await get('selected'))?.id === crate);
  const newest = () => page.evaluate(() => Math.max(...window.jostle.dynamicBodies()));
  const before = await newest();
  await page.keyboard.press('v');
  const clone = await until('the crate is cloned', async () => (await newest()) > before && newest());
  const heightOf = () => page.evaluate((id) => window.jostle.poseOf(id)?.[1], clone);
  await until('the clone falls', async () => (await heightOf()) < 1.95);
  await page.keyboard.press('k');
  await until('the world is paused', async () => (await get('stats')).paused !== '');
  const settled = async () => {
    await new Promise((resolve) => setTimeout(resolve, 1000));
    return heightOf();
  };
  const paused = await settled();
  expect((await settled()) === paused && paused > 1.45, `the clone stays at ${paused.toFixed(3)} m in the paused world`);
  await page.locator('#time button', { hasText: 'Step' }).click();
  await until('the clone moves', async () => (await heightOf()) < paused);
  const step = paused - (await settled());
  expect(step < 4.5 / 60, `a single step moves the falling clone by ${(1000 * step).toFixed(1)} mm`);
  await take(page, 'sandbox-paused');
  await checkAccessibility(page, 'time', expect);
  await page.locator('#time button', { hasText: 'Resume' }).click();
  await until('the world runs again', async () => (await get('stats')).paused === '');
  await page.locator('#time select').selectOption('100');
  await until('the world runs in real time', async () => (await get('stats')).speedPercent === 100);

  await until('the timeline has more than 3 s', async () => (await get('stats')).restorableTicks.length > 3);
  const entities = await get('entityCount');
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press('4');
  const at = await page.evaluate(() => window.jostle.toScreen(-1, 0, 4));
  await page.mouse.click(at.x, at.y);
  await until('a ball is spawned', async () => (await get('entityCount')) === entities + 1);
  await page.locator('#time input[type=range]').fill('0');
  await take(page, 'sandbox-time');
  await page.locator('#time button', { hasText: 'Rewind' }).click();
  await until('the ball is gone after the rewind', async () => (await get('state')) === 'playing' && (await get('entityCount')) <= entities);
  expect(true, 'rewinding removes a ball that was spawned later');
  const reset = page.locator('#time .danger');
  await reset.click();
  expect(/again/.test(await reset.textContent()), 'a reset asks for a second click');
  await reset.click();
  await until('the reset restores the joint of the weight', async () => (await get('state')) === 'playing' && (await idsOf('weight')).length === 1 && (await get('jointCount')) === 1);
  expect(true, 'a reset starts the world from its scene');
  await page.keyboard.press('y');
}

export async function testPhonePanels({ page, until, expect, take }) {
  for (const [title, id, ready] of [
    ['Inspector', 'inspector', '.title'],
    ['Time', 'time', 'select'],
    ['Build', 'build', 'input'],
    ['Plots', 'plots', 'figure'],
  ]) {
    // Clicks, because a slow page takes a touch for a long press.
    await page.locator('#panel-buttons [aria-controls=menu]').click();
    await page.locator(`#menu .menu button[aria-label="${title}"]`).click();
    await until(`the panel ${id} is loaded`, () => page.locator(`#${id} ${ready}`).count());
    const problems = await layoutProblems(page, TARGET_MIN);
    expect(problems.length === 0, `phone, ${id}: targets have 44 pixels and fit the page ${problems.join('; ')}`);
    await checkAccessibility(page, `phone, ${id}`, expect);
    await take(page, `sandbox-phone-${id}`);
    await page.locator(`#${id} .close`).click();
  }
  await page.locator('#tools button[data-tool=inspect]').click();
  const [crate] = await page.evaluate(() => window.jostle.dynamicBodies().filter((id) => window.jostle.entityName(id) === 'crate'));
  await until('a tap inspects the crate', async () => {
    if ((await page.evaluate(() => window.jostle.inspected?.mass)) === 1000) return true;
    await page.keyboard.press('Escape'); // the menu of a long press
    const at = await page.evaluate((id) => window.jostle.screenPosition(id), crate);
    await page.touchscreen.tap(at.x, at.y);
    await new Promise((resolve) => setTimeout(resolve, 2000));
    return false;
  });
  const problems = await layoutProblems(page, TARGET_MIN);
  expect(problems.length === 0, `phone, inspected body: targets have 44 pixels and fit the page ${problems.join('; ')}`);
  await take(page, 'sandbox-phone-inspected');
}
