// A Colyseus room that steps the scene of balls.json in Rapier and sends the poses that changed after each step, as a game
// developer would write it: a schema with single-precision numbers.
//   node server.mjs PORT
import { Room, Server } from '@colyseus/core';
import { schema, t } from '@colyseus/schema';
import { WebSocketTransport } from '@colyseus/ws-transport';
import { buildWorld } from './pit.mjs';

const SCENE = new URL('balls.json', import.meta.url).pathname;

const Body = schema({
  x: t.float32(),
  y: t.float32(),
  z: t.float32(),
  qx: t.float32(),
  qy: t.float32(),
  qz: t.float32(),
  qw: t.float32(),
});
// `time`: the start of the step, ms of the monotonic clock of this machine, for the age of a state at its client.
const State = schema({ time: t.float64(), bodies: t.array(Body) });

// The same clock in every process of a machine.
const now = () => Number(process.hrtime.bigint()) / 1e6;

class PitRoom extends Room {
  maxClients = 1000;
  autoDispose = false;
  patchRate = null; // broadcastPatch() below, after each step

  async onCreate() {
    this.seatReservationTimeout = 60;
    const { world, moving, hz } = await buildWorld(SCENE);
    this.state = new State();
    for (const _ of moving) this.state.bodies.push(new Body());
    const step = () => {
      this.state.time = now();
      world.step();
      moving.forEach((body, k) => {
        const to = this.state.bodies[k];
        const p = body.translation();
        const q = body.rotation();
        to.x = p.x;
        to.y = p.y;
        to.z = p.z;
        to.qx = q.x;
        to.qy = q.y;
        to.qz = q.z;
        to.qw = q.w;
      });
      this.broadcastPatch();
    };
    // Timers of Node have a resolution of 1 ms, so the next step is scheduled from the start.
    const start = now();
    let steps = 0;
    const wait = () => {
      const left = start + ((steps + 1) * 1000) / hz - now();
      this.timer = setTimeout(() => {
        step();
        steps = Math.max(steps + 1, Math.floor(((now() - start) * hz) / 1000)); // skips late steps
        wait();
      }, Math.max(0, left));
    };
    wait();
  }
}

const server = new Server({ transport: new WebSocketTransport({ pingInterval: 6000 }), greet: false });
server.define('pit', PitRoom);
await server.listen(Number(process.argv[2]), '127.0.0.1');
console.log('ready');
