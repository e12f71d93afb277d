// The example of the SDK's documentation: joins a world, spawns a ball, pushes it and prints its positions.

import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const example = fileURLToPath(new URL('../../sdk/examples/push_ball.mjs', import.meta.url));

export async function testSdkExample({ url, expect }) {
  // Node 20 needs the flag; later versions accept it.
  const { stdout } = await promisify(execFile)(process.execPath, ['--experimental-websocket', example, `${url.replace('http', 'ws')}/play`], {
    timeout: 60_000,
  });
  const positions = stdout
    .split('\n')
    .map((line) => line.split(' ').map(Number))
    .filter((numbers) => numbers.length === 3 && numbers.every(Number.isFinite));
  expect(positions.length > 4 && positions.at(-1)[0] - positions[0][0] > 1, `the example of the SDK pushes a ball by more than 1 m: ${stdout}`);
}
