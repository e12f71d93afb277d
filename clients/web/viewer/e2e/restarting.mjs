// The server of somebody who plays is killed and started again, and taken back by an operator: the page comes back as who it was,
// with all that it did; what it was a while ago opens as a world of its own.

import { execFileSync, spawn } from 'node:child_process';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';

const ended = (child) => new Promise((done) => (child.exitCode !== null || child.signalCode !== null ? done() : child.on('exit', done)));

export async function restarting({ page, server, folder, webRoot, until, expect, shoot }) {
  const portFile = join(folder, 'kept_ports.json');
  let child;
  const start = async (http, grpc) => {
    rmSync(portFile, { force: true });
    const ways = { '--scene': 'stack', '--listen': `127.0.0.1:${grpc}`, '--http': `127.0.0.1:${http}`, '--web-root': webRoot, '--port-file': portFile };
    const kept = ['persistence.history_retention_hours=1', `persistence.database=${join(folder, 'worlds.db')}`, 'client.resume_timeout_seconds=120'].flatMap((setting) => ['--set', setting]);
    child = spawn(server, [...Object.entries(ways).flat(), ...kept], { stdio: ['ignore', 'inherit', 'inherit'] });
    return until('the kept server writes its ports', () => existsSync(portFile) && JSON.parse(readFileSync(portFile, 'utf8')));
  };
  const look = (what) => page.evaluate((name) => window.jostle?.[name], what);
  const throwBall = async () => {
    const before = await look('entities');
    await page.keyboard.press('2');
    await page.mouse.click(640, 200);
    await until('the thrown ball is there', async () => (await look('entities')) === before + 1);
  };
  try {
    const ports = await start(0, 0);
    await page.goto(`http://127.0.0.1:${ports.http}/?quality=low`);
    await until('the kept world plays', async () => (await look('state')) === 'playing' && (await look('snapshots')) > 30);
    const alone = await look('entities');
    const early = await look('tick');
    for (let k = 0; k < 3; k++) await throwBall();
    const who = await look('client');
    child.kill('SIGKILL');
    await ended(child);
    await start(ports.http, ports.grpc);
    await until('the page comes back by itself', async () => (await look('resumed')) === 1 && (await look('state')) === 'playing');
    expect((await look('client')) === who, `after kill -9 it is client ${who} again`);
    await until('the world is as it was', async () => (await look('entities')) === alone + 3);
    expect(true, 'and its three balls are there');
    await throwBall();
    expect(true, 'and it throws another one');

    const rewind = (tick) =>
      execFileSync(join(dirname(server), 'jostlectl'), ['--server', `127.0.0.1:${ports.grpc}`, 'rewind', 'stack', '--to', String(tick)]);
    rewind(early);
    await until('it comes back to the world of before', async () => (await look('resumed')) === 2 && (await look('entities')) === alone);
    expect((await look('client')) === who, `an operator takes the world back: no ball is there, and it is still client ${who}`);
    await throwBall();

    await page.keyboard.press('w');
    const row = page.locator('#worlds .past');
    await until('the list offers the past', () => row.count());
    await row.locator('input').fill(String(early));
    if (shoot) await shoot('past');
    await row.locator('button', { hasText: 'What if' }).click();
    await until('a moment of the past is joined', async () => (await look('state')) === 'playing' && (await look('entities')) === alone);
    expect(true, `tick ${early} opens as a world of its own`);
    await throwBall();
  } finally {
    child?.kill('SIGTERM');
    if (child) await ended(child);
  }
}
