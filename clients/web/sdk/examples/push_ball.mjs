// Joins a world, spawns a ball, pushes it and prints its pose four times per second.
// Usage: node examples/push_ball.mjs [URL]   (Node 22 or newer; Node 20 needs --experimental-websocket)
import { connect } from '@jostle/client';

const url = process.argv[2] ?? 'ws://127.0.0.1:8080/play';
const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

const client = await connect({
  url,
  listener: {
    inputRejected: ({ message }) => console.error(`input rejected: ${message}`),
    notice: (text) => console.error(`notice: ${text}`),
  },
});
console.log(`client ${client.clientId}, ${client.entities.size} entities`);

client.send({
  case: 'spawn',
  value: { shape: { kind: { case: 'sphere', value: { radius: 0.3 } } }, position: { x: 0, y: 2, z: 6 } },
});
const ownBall = () => [...client.entities.values()].find(({ owner }) => owner === client.clientId);
while (!ownBall()) await sleep(20);
const { id, mass } = ownBall();

for (let k = 0; k < 12; k++) {
  if (k === 4) client.applyImpulse(id, { x: 3 * mass, y: 0, z: 0 }); // 3 m/s
  client.sample();
  const pose = client.poseOf(id);
  if (pose) console.log([...pose.subarray(0, 3)].map((meters) => meters.toFixed(2)).join(' '));
  await sleep(250);
}
client.close();
