import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { simulatedSocket } from './simulated_socket.js';
import type { Socket } from '../connection/connection.js';
import { IDEAL_NETWORK } from './network_simulator.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('delays messages in both directions and preserves their order, with the close last', async () => {
  const sent: number[] = [];
  const received: (number | string)[] = [];
  const real: Socket = {
    binaryType: '',
    onopen: null,
    onmessage: null,
    onclose: null,
    send: (bytes) => void sent.push(bytes[0]!),
    close: () => {},
  };
  const socket = simulatedSocket(() => real, { ...IDEAL_NETWORK, latencyMs: 80, jitterMs: 20 })('ws://x');
  socket.onmessage = ({ data }) => void received.push(new Uint8Array(data)[0]!);
  socket.onclose = ({ reason }) => void received.push(reason);
  for (let k = 0; k < 5; k++) {
    socket.send(Uint8Array.of(k));
    real.onmessage!({ data: Uint8Array.of(k).buffer });
  }
  await vi.advanceTimersByTimeAsync(79);
  expect(sent).toEqual([]);
  expect(received).toEqual([]);
  await vi.advanceTimersByTimeAsync(22);
  expect(sent).toEqual([0, 1, 2, 3, 4]);
  real.onclose!({ code: 1000, reason: 'closed' });
  await vi.advanceTimersByTimeAsync(101);
  expect(received).toEqual([0, 1, 2, 3, 4, 'closed']);
});

it('sends nothing after close', async () => {
  const sent: Uint8Array[] = [];
  const real: Socket = {
    binaryType: '',
    onopen: null,
    onmessage: null,
    onclose: null,
    send: (bytes) => void sent.push(bytes),
    close: () => {},
  };
  const socket = simulatedSocket(() => real, { ...IDEAL_NETWORK, latencyMs: 80 })('ws://x');
  socket.send(Uint8Array.of(1));
  socket.close();
  await vi.advanceTimersByTimeAsync(200);
  expect(sent).toEqual([]);
});
