// Clients of server.mjs.
//   node clients.mjs PORT CLIENTS SETTLE SECONDS passive|decoding
// Passive clients are sockets that read the frames of WebSocket and ignore what is in them, so that hundreds fit into one process.
// Decoding clients use the SDK of Colyseus; they measure the age of a state: from the start of its step to its arrival.
// Writes one line of JSON: the states and bytes received in SECONDS, closed connections, and the ages in ms.
import net from 'node:net';
import { Client } from '@colyseus/sdk';

const [port, clients, settle, seconds] = process.argv.slice(2, 6).map(Number);
const decoding = process.argv[6] === 'decoding';
const now = () => Number(process.hrtime.bigint()) / 1e6;
const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const totals = { states: 0, bytes: 0, closed: 0 };
const ages = [];
let measuring = false;

// Message types of Colyseus, the first byte of a message; opcodes of WebSocket.
const JOIN_ROOM = 10;
const STATE_PATCH = 15;
const BINARY = 2;
const PING = 9;
const PONG = 10;

// A frame of a client with the mask 0.
const frame = (opcode, ...payload) => Buffer.from([0x80 | opcode, 0x80 | payload.length, 0, 0, 0, 0, ...payload]);

// Reads the frames of a server: of a payload only the first byte.
function frameReader(onFrame) {
  let head = []; // the header and the first byte of the payload
  let left = 0; // further bytes of the payload
  return (data) => {
    for (let at = 0; at < data.length; ) {
      if (left > 0) {
        const skipped = Math.min(left, data.length - at);
        left -= skipped;
        at += skipped;
        continue;
      }
      head.push(data[at++]);
      if (head.length < 2) continue;
      const short = head[1] & 127;
      const size = short === 126 ? 4 : short === 127 ? 10 : 2;
      if (head.length < size + (short > 0 ? 1 : 0)) continue;
      const length = short < 126 ? short : head.slice(2, size).reduce((value, byte) => value * 256 + byte, 0);
      left = Math.max(0, length - 1);
      onFrame(head[0] & 15, short > 0 ? head[size] : 0);
      head = [];
    }
  };
}

async function joinPassive() {
  const response = await fetch(`http://127.0.0.1:${port}/matchmake/joinOrCreate/pit`, {
    method: 'POST',
    headers: { 'Content-Type': 'application/json' },
    body: '{}',
  });
  if (!response.ok) throw new Error(`no seat: ${response.status} ${await response.text()}`);
  const seat = await response.json();
  const socket = net.connect(port, '127.0.0.1');
  socket.setNoDelay(true);
  await new Promise((resolve, reject) => {
    let header = Buffer.alloc(0);
    const read = frameReader((opcode, first) => {
      if (opcode === PING) socket.write(frame(PONG));
      if (opcode === BINARY && first === JOIN_ROOM) {
        socket.write(frame(BINARY, JOIN_ROOM));
        resolve();
      }
      if (opcode === BINARY && first === STATE_PATCH && measuring) totals.states++;
    });
    const upgrade = (data) => {
      header = Buffer.concat([header, data]);
      const end = header.indexOf('\r\n\r\n');
      if (end < 0) return;
      if (!header.toString('latin1', 0, end).startsWith('HTTP/1.1 101')) return reject(new Error('no upgrade'));
      socket.off('data', upgrade);
      socket.on('data', (bytes) => {
        if (measuring) totals.bytes += bytes.length;
        read(bytes);
      });
      read(header.subarray(end + 4));
    };
    socket.on('data', upgrade);
    socket.on('error', reject);
    socket.on('close', () => {
      totals.closed++;
      reject(new Error('closed'));
    });
    socket.write(
      `GET /${seat.processId}/${seat.roomId}?sessionId=${seat.sessionId} HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\n` +
        'Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n' +
        'Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n',
    );
  });
}

async function joinDecoding() {
  const room = await new Client(`http://127.0.0.1:${port}`).joinOrCreate('pit');
  room.onStateChange((state) => {
    if (!measuring) return;
    totals.states++;
    ages.push(now() - state.time);
  });
}

for (let k = 0; k < clients; k++) await (decoding ? joinDecoding() : joinPassive());
console.error('joined');
await sleep(settle * 1000);
measuring = true;
const began = now();
await sleep(seconds * 1000);
measuring = false;
const took = (now() - began) / 1000;
console.log(JSON.stringify({ ...totals, seconds: took, ages }));
process.exit(0);
