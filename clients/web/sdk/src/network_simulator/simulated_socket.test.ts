import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { simulatedSocket } from './simulated_socket.js';
import type { Socket } from '../connection/connection.js';
import { IDEAL_NETWORK } from './network_simulator.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('holds messages both ways for so long and keeps their order, the end last', async () => {
  const sent: number[] = [];
  const heard: (number | string)[] = [];
  const real: Socket = {
    binaryType: '',
    onopen: null,
    onmessage: null,
    onclose: null,
    send: (bytes) => void sent.push(bytes[0]!),
    close: () => {},
  };
  const socket = simulatedSocket(() => real, { ...IDEAL_NETWORK, delay: 80, jitter: 20 })('ws://x');
  socket.onmessage = ({ data }) => void heard.push(new Uint8Array(data)[0]!);
  socket.onclose = ({ reason }) => void heard.push(reason);
  for (let k = 0; k < 5; k++) {
    socket.send(Uint8Array.of(k));
    real.onmessage!({ data: Uint8Array.of(k).buffer });
  }
  await vi.advanceTimersByTimeAsync(79);
  expect(sent).toEqual([]);
  expect(heard).toEqual([]);
  await vi.advanceTimersByTimeAsync(22);
  expect(sent).toEqual([0, 1, 2, 3, 4]);
  real.onclose!({ code: 1000, reason: 'over' });
  await vi.advanceTimersByTimeAsync(101);
  expect(heard).toEqual([0, 1, 2, 3, 4, 'over']);
});

it('sends nothing after it was closed', async () => {
  const sent: Uint8Array[] = [];
  const real: Socket = {
    binaryType: '',
    onopen: null,
    onmessage: null,
    onclose: null,
    send: (bytes) => void sent.push(bytes),
    close: () => {},
  };
  const socket = simulatedSocket(() => real, { ...IDEAL_NETWORK, delay: 80 })('ws://x');
  socket.send(Uint8Array.of(1));
  socket.close();
  await vi.advanceTimersByTimeAsync(200);
  expect(sent).toEqual([]);
});
