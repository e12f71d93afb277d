import { create, fromBinary, toBinary } from '@bufbuild/protobuf';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Connection, type Socket, type State } from './connection';
import { ClientMessageSchema, ServerMessageSchema } from './gen/jostle/v1/play_pb';

class FakeSocket implements Socket {
  binaryType = '';
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  sent: Uint8Array[] = [];
  send(bytes: Uint8Array) {
    this.sent.push(bytes);
  }
  close() {}
  take() {
    return this.sent.splice(0).map((bytes) => fromBinary(ClientMessageSchema, bytes).message);
  }
  give(message: Parameters<typeof create<typeof ServerMessageSchema>>[1]) {
    const bytes = toBinary(ServerMessageSchema, create(ServerMessageSchema, message));
    this.onmessage?.({ data: bytes.slice().buffer as ArrayBuffer });
  }
}

describe('connection', () => {
  let sockets: FakeSocket[];
  let states: [State, string][];
  let connection: Connection;

  beforeEach(() => {
    vi.useFakeTimers();
    sockets = [];
    states = [];
    connection = new Connection(
      'ws://test/play',
      { state: (s, why) => states.push([s, why]), roster: () => {}, stats: () => {}, refused: () => {} },
      () => {
        sockets.push(new FakeSocket());
        return sockets[sockets.length - 1]!;
      },
    );
    connection.join('sandbox');
    sockets[0]!.onopen?.();
  });
  afterEach(() => {
    connection.stop();
    vi.useRealTimers();
  });

  const welcome = () =>
    sockets[sockets.length - 1]!.give({ message: { case: 'welcome', value: { clientId: 7 } } });

  it('says hello first and names the world', () => {
    const [hello] = sockets[0]!.take();
    expect(hello).toMatchObject({ case: 'hello', value: { protocol: 1, world: 'sandbox' } });
  });

  it('numbers inputs from 1 without gaps, at most 30 batches a second', () => {
    welcome();
    sockets[0]!.take();
    for (let i = 0; i < 40; i++) connection.send({ kind: { case: 'release', value: {} } });
    vi.advanceTimersByTime(34);
    vi.advanceTimersByTime(34);
    const batches = sockets[0]!.take().filter((m) => m.case === 'input');
    expect(batches.map((b) => [b.value.firstSequence, b.value.inputs.length])).toEqual([
      [1, 32],
      [33, 8],
    ]);
  });

  it('sends only the newest target of a drag', () => {
    welcome();
    sockets[0]!.take();
    for (let x = 0; x < 10; x++)
      connection.send({ kind: { case: 'drag', value: { target: { x, y: 0, z: 0 } } } });
    vi.advanceTimersByTime(34);
    const [batch] = sockets[0]!.take().filter((m) => m.case === 'input');
    expect(batch!.value.inputs.length).toBe(1);
    expect(batch!.value.inputs[0]!.kind).toMatchObject({ case: 'drag', value: { target: { x: 9 } } });
  });

  it('asks for a keyframe when it does not know the base, and counts it once', () => {
    welcome();
    sockets[0]!.take();
    for (const frame of [50, 51])
      sockets[0]!.give({ message: { case: 'snapshot', value: { frame, baseFrame: 49, packed: new Uint8Array(1) } } });
    const acks = sockets[0]!.take().filter((m) => m.case === 'ack');
    expect(acks[0]!.value.needKeyframe).toBe(true);
    expect(connection.decodeErrors).toBe(1);
  });

  it('comes back after a loss, with growing pauses, and says why', () => {
    welcome();
    sockets[0]!.give({ message: { case: 'notice', value: { code: 1, message: 'going down' } } });
    sockets[0]!.onclose?.({ code: 1006, reason: '' });
    expect(states[states.length - 1]).toEqual(['waiting', 'going down']);
    vi.advanceTimersByTime(249);
    expect(sockets.length).toBe(1);
    vi.advanceTimersByTime(2);
    expect(sockets.length).toBe(2);
    sockets[1]!.onclose?.({ code: 1006, reason: '' });
    vi.advanceTimersByTime(400);
    expect(sockets.length).toBe(2);
    vi.advanceTimersByTime(200);
    expect(sockets.length).toBe(3);
  });
});
