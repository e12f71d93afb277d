// Every tool in two browsers of one world: one acts, the other receives the effect; then the other way round.
// A tool of the viewer without an entry here fails the test.

import { setName } from './chromium.mjs';
import { workshop } from './sandbox.mjs';

const WIDE = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const get = (page, name) => page.evaluate((member) => window.jostle[member], name);
const poseOf = (page, id) => page.evaluate((body) => window.jostle.poseOf(body), id);
const idsOf = (page, name) => page.evaluate((wanted) => window.jostle.dynamicBodies().filter((id) => window.jostle.entityName(id) === wanted).sort((a, b) => a - b), name);
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

async function clickBody(page, id) {
  const at = await page.evaluate((body) => window.jostle.screenPosition(body), id);
  await page.mouse.click(at.x, at.y);
}
async function clickGround(page, x, z) {
  const at = await page.evaluate(([px, pz]) => window.jostle.toScreen(px, 0, pz), [x, z]);
  await page.mouse.click(at.x, at.y);
}

/** Places a body and returns its id. `spot`: x and z on the ground. */
async function spawn({ actor, other, until, spot }) {
  const known = await other.evaluate(() => window.jostle.dynamicBodies());
  await clickGround(actor, ...spot);
  return until('the other browser receives the body', () => other.evaluate((before) => window.jostle.dynamicBodies().find((id) => !before.includes(id) && window.jostle.poseOf(id)), known));
}

/** Each uses the tool, which is selected, and returns what the other browser received. */
const WORKSHOP_TOOLS = {
  async drag({ actor, other, until, name }) {
    const [crate] = await idsOf(actor, 'crate');
    const before = await poseOf(other, crate);
    const at = await actor.evaluate((body) => window.jostle.screenPosition(body), crate);
    await actor.mouse.move(at.x, at.y);
    await actor.mouse.down();
    for (let k = 1; k <= 12; k++) {
      await actor.mouse.move(at.x + (name === 'ann' ? -5 : 3) * k, at.y - 3 * k);
      await wait(40);
    }
    const moved = await until('the other browser sees the drag', async () => {
      const meters = distance(before, await poseOf(other, crate));
      return meters > 0.4 && meters;
    });
    await actor.mouse.up();
    await wait(1500); // it falls
    return `a body that moves ${moved.toFixed(1)} m`;
  },
  async throw({ actor, other, until, spot }) {
    return `ball ${await spawn({ actor, other, until, spot })}`;
  },
  box: async (tools) => `box ${await spawn(tools)}`,
  sphere: async (tools) => `ball ${await spawn(tools)}`,
  capsule: async (tools) => `capsule ${await spawn(tools)}`,
  async delete({ actor, other, until, select, spot }) {
    await select('box');
    const box = await spawn({ actor, other, until, spot });
    await select('delete');
    await until('the actor renders the box', () => poseOf(actor, box));
    await wait(1000);
    await clickBody(actor, box);
    await until('the other browser loses the box', () => other.evaluate((id) => !window.jostle.dynamicBodies().includes(id), box));
    return `that body ${box} is gone`;
  },
  async joint({ actor, other, until }) {
    const known = await other.evaluate(() => window.jostle.jointIds());
    const stack = await idsOf(actor, 'stack');
    const [crate] = await idsOf(actor, 'crate');
    await clickBody(actor, crate);
    await until('the first end is chosen', async () => /from crate/.test(await actor.locator('#tool-hint').textContent()));
    await clickBody(actor, stack[1]);
    const joint = await until('the other browser receives the joint', () => other.evaluate((before) => window.jostle.jointIds().find((id) => !before.includes(id)), known));
    return `joint ${joint}`;
  },
  async inspect({ actor, other, until, name }) {
    const [stack] = await idsOf(actor, 'stack');
    const before = await get(other, 'selected');
    await clickBody(actor, stack);
    await until('the body is inspected', async () => (await get(actor, 'inspected'))?.entity === stack);
    const key = `seen.${name}`;
    const editor = actor.locator('#inspector .attributes');
    await editor.locator('input[name=key]').fill(key);
    await editor.locator('[name=value]').fill(name);
    await editor.locator('button', { hasText: 'Add' }).click();
    await until('the other browser receives the attribute', async () => (await other.evaluate((id) => window.jostle.attributesOf(id), stack))[key] === name);
    await actor.locator('#inspector .close').click();
    if ((await get(other, 'selected'))?.id !== before?.id) throw new Error('the selection of one user changed that of another');
    return `the attribute ${key}`;
  },
  async explode({ actor, other, until }) {
    const [crate] = await idsOf(actor, 'crate');
    await actor.keyboard.press('f'); // an earlier explosion may have blown it away
    await wait(1500);
    const before = await poseOf(other, crate);
    await clickBody(actor, crate);
    const moved = await until('the other browser sees the explosion', async () => {
      const meters = distance(before, await poseOf(other, crate));
      return meters > 0.3 && meters;
    });
    return `a body that is blown ${moved.toFixed(1)} m`;
  },
};

const PLAYGROUND_TOOLS = {
  async drive({ actor, other, until }) {
    await actor.locator('#driver button').first().click();
    const entity = await until('an entity is controlled', () => get(actor, 'controlledEntity'));
    const before = await until('the other browser renders it', () => poseOf(other, entity));
    await actor.evaluate(() => document.activeElement?.blur());
    await actor.keyboard.down('w');
    const moved = await until('the other browser sees it move', async () => {
      const meters = distance(before, await poseOf(other, entity));
      return meters > 1 && meters;
    });
    await actor.keyboard.up('w');
    await actor.keyboard.press('Escape');
    await until('the entity is released', async () => (await get(actor, 'controlledEntity')) === 0);
    return `an entity that walks ${moved.toFixed(1)} m`;
  },
  async cut({ actor, other, until }) {
    await actor.keyboard.press('f');
    await wait(1500);
    const before = await get(other, 'pointObjectCount');
    let attempt = 0;
    // Ropes swing, so that a click may miss.
    await until('the other browser receives the parts of a rope', async () => {
      const at = await actor.evaluate((first) => {
        const inside = ({ x, y }) => x > 20 && x < innerWidth - 20 && y > 90 && y < innerHeight - 120;
        const count = window.jostle.pointObjectCount;
        for (let k = 0; k < count; k++) {
          const points = window.jostle.pointsOf((first + k) % count);
          if (!points || points.length < 24) continue;
          const middle = 3 * Math.floor(points.length / 6);
          const spot = window.jostle.toScreen(points[middle], points[middle + 1], points[middle + 2]);
          if (inside(spot)) return spot;
        }
        return undefined;
      }, attempt++);
      if (at) await actor.mouse.click(at.x, at.y);
      await wait(700);
      return (await get(other, 'pointObjectCount')) > before;
    });
    return `${await get(other, 'pointObjectCount')} parts of ropes instead of ${before}`;
  },
};

export async function testTools({ browser, url, post, until, expect }) {
  const permissions = Object.fromEntries(['delete', 'joints', 'edit', 'drag'].map((action) => [`builder.${action}`, 'any']));
  const room = { title: 'Tools', initialRole: 'builder', permissions };
  for (const world of [{ name: 'tools', scene: workshop(room) }, { name: 'ropes', sceneName: 'swings' }]) {
    const created = await post('/api/worlds', world);
    expect(created.ok, `the world ${world.name} is created: ${created.status}`);
  }
  const errors = [];
  const open = async (name, options) => {
    const context = await browser.newContext(options);
    await setName(context, name);
    const page = await context.newPage();
    page.setDefaultTimeout(60_000);
    page.on('pageerror', (error) => errors.push(String(error)));
    return page;
  };
  const wide = await open('ann', { viewport: WIDE });
  const phone = await open('bob', { viewport: PHONE, hasTouch: true, isMobile: true, deviceScaleFactor: 1 });
  try {
    const tested = [];
    for (const [world, tools] of [['tools', WORKSHOP_TOOLS], ['ropes', PLAYGROUND_TOOLS]]) {
      for (const page of [wide, phone]) {
        await page.goto(`${url}/?world=${world}&quality=low`);
        await until(`the world ${world} is rendered`, () => page.evaluate(() => window.jostle?.state === 'playing' && window.jostle.dynamicBodies().length > 4 && window.jostle.dynamicBodies().every((id) => window.jostle.poseOf(id))));
      }
      if (await wide.locator('#stats').isVisible()) await wide.keyboard.press('s');
      await wait(1500); // the camera follows the closed panel
      for (const [tool, use] of Object.entries(tools)) {
        for (const [name, actor, other, spot] of [['ann', wide, phone, [-2.2, 3]], ['bob', phone, wide, [-1.4, 4.5]]]) {
          // Clicks, because a slow page takes a touch for a long press.
          const select = (wanted) => actor.locator(`#tools button[data-tool=${wanted}]`).click();
          await select(tool);
          const received = await use({ actor, other, until, select, spot, name });
          expect(true, `${tool}: ${name === 'ann' ? 'the phone' : 'the wide page'} receives ${received}`);
        }
        tested.push(tool);
      }
    }
    const offered = await wide.locator('#tools button').evaluateAll((buttons) => buttons.map(({ dataset }) => dataset.tool));
    const missing = offered.filter((tool) => !tested.includes(tool));
    expect(missing.length === 0 && offered.length === tested.length, `all ${offered.length} tools are tested in both browsers${missing.length > 0 ? `; not ${missing.join(', ')}` : ''}`);
    expect(errors.length === 0, `both pages have no errors ${errors.join('; ')}`);
  } finally {
    await wide.context().close();
    await phone.context().close();
  }
}
