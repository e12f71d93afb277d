// Server failures: the server is killed and restarted, and an operator rewinds its world. The page
// resumes its session with the same client id. An earlier tick of the world is opened as a new world.

import { execFileSync, spawn } from 'node:child_process';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';

const exited = (child) => new Promise((resolve) => (child.exitCode !== null || child.signalCode !== null ? resolve() : child.on('exit', resolve)));

export async function testResume({ page, server, folder, webRoot, until, expect, takeScreenshot }) {
  const portFile = join(folder, 'persistent_ports.json');
  let child;
  const start = async (http, grpc) => {
    rmSync(portFile, { force: true });
    const options = { '--scene': 'stack', '--listen': `127.0.0.1:${grpc}`, '--http': `127.0.0.1:${http}`, '--web-root': webRoot, '--port-file': portFile };
    const settings = [
      'persistence.history_retention_hours=1',
      `persistence.database=${join(folder, 'worlds.db')}`,
      'client.resume_timeout_seconds=120',
    ].flatMap((setting) => ['--set', setting]);
    child = spawn(server, [...Object.entries(options).flat(), ...settings], { stdio: ['ignore', 'inherit', 'inherit'] });
    return until('the persistent server writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
  };
  const inspect = (name) => page.evaluate((member) => window.jostle?.[member], name);
  const throwBall = async () => {
    const count = await inspect('entityCount');
    await page.keyboard.press('2');
    await page.mouse.click(640, 200);
    await until('the thrown ball exists', async () => (await inspect('entityCount')) === count + 1);
  };
  try {
    const ports = await start(0, 0);
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=low`);
    await until('the persistent world plays', async () => (await inspect('state')) === 'playing' && (await inspect('snapshots')) > 30);
    const initialCount = await inspect('entityCount');
    const earlyTick = await inspect('tick');
    for (let k = 0; k < 3; k++) await throwBall();
    const clientId = await inspect('clientId');
    child.kill('SIGKILL');
    await exited(child);
    await start(ports.http, ports.grpc);
    await until('the page resumes its session', async () => (await inspect('resumed')) === 1 && (await inspect('state')) === 'playing');
    expect((await inspect('clientId')) === clientId, `after kill -9 the page is client ${clientId} again`);
    await until('the world is restored', async () => (await inspect('entityCount')) === initialCount + 3);
    expect(true, 'its three balls are restored');
    await throwBall();
    expect(true, 'it can throw another ball');

    const rewind = (tick) =>
      execFileSync(join(dirname(server), 'jostlectl'), ['--server', `127.0.0.1:${ports.grpc}`, 'rewind', 'stack', '--to', String(tick)]);
    rewind(earlyTick);
    await until('the page resumes in the rewound world', async () => (await inspect('resumed')) === 2 && (await inspect('entityCount')) === initialCount);
    expect((await inspect('clientId')) === clientId, `after a rewind without balls it is still client ${clientId}`);
    await throwBall();

    await page.keyboard.press('w');
    const row = page.locator('#worlds .restore');
    await until('the list offers restorable ticks', () => row.count());
    await row.locator('input').fill(String(earlyTick));
    if (takeScreenshot) await takeScreenshot('restore');
    await row.locator('button', { hasText: 'Restore copy' }).click();
    await until('the restored copy is joined', async () => (await inspect('state')) === 'playing' && (await inspect('entityCount')) === initialCount);
    expect(true, `tick ${earlyTick} opens as a new world`);
    await throwBall();
  } finally {
    child?.kill('SIGTERM');
    if (child) await exited(child);
  }
}
