import { readFileSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { connect, ConnectError, type Client } from './client.js';
import { AttributeVisibility, NoticeCode, PlayerEventKind } from './gen/jostle/v1/play_pb.js';
import { RecordedStream } from './recording/recorded_stream.js';
import { Recording } from './recording/recording.js';
import { FakeSocket } from './testing/fake_socket.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe('connect', () => {
  const welcome = { message: { case: 'welcome' as const, value: { clientId: 7, worldName: 'sandbox' } } };

  it('resolves once the server accepts the client', async () => {
    const socket = new FakeSocket();
    const connecting = connect({ url: 'ws://test/play', world: 'sandbox', openSocket: () => socket });
    await Promise.resolve();
    socket.onopen!();
    expect(socket.take()[0]).toMatchObject({ case: 'hello', value: { world: 'sandbox', events: false, channels: [] } });
    socket.deliver(welcome);
    const client = await connecting;
    expect([client.state, client.clientId]).toEqual(['playing', 7]);
    client.close();
  });

  it('rejects with the reason of the server', async () => {
    const socket = new FakeSocket();
    const connecting = connect({ url: 'ws://test/play', openSocket: () => socket });
    const failed = expect(connecting).rejects.toThrow(new ConnectError('ws://test/play: no such world'));
    await Promise.resolve();
    socket.onopen!();
    socket.deliver({ message: { case: 'notice', value: { code: NoticeCode.REFUSED, message: 'no such world' } } });
    socket.onclose!({ code: 1008, reason: 'no such world' });
    await failed;
  });

  it('rejects when the server does not respond in time, and stops reconnecting', async () => {
    const sockets: FakeSocket[] = [];
    const openSocket = () => {
      sockets.push(new FakeSocket());
      return sockets[sockets.length - 1]!;
    };
    const failed = expect(connect({ url: 'ws://test/play', timeoutMs: 300, openSocket })).rejects.toThrow('ws://test/play: the server does not respond');
    await vi.advanceTimersByTimeAsync(301);
    await failed;
    await vi.advanceTimersByTimeAsync(60_000);
    expect(sockets.length).toBe(1);
    expect(sockets[0]!.closed).toBe(true);
  });
});

describe('client', () => {
  /** A client that plays a recording for `seconds`, rendered at 60 Hz. */
  async function playRecording(seconds: number): Promise<{ client: Client; rendered: number[] }> {
    const file = readFileSync(new URL('./testing/machines.rec', import.meta.url));
    const stream = new RecordedStream(new Recording(new Uint8Array(file)));
    const connecting = connect({ url: '', openSocket: () => stream.open() });
    let client: Client | undefined;
    void connecting.then((connected) => (client = connected));
    const rendered: number[] = [];
    for (let us = 1e6; us < 1e6 + seconds * 1e6; us += 1e6 / 60) {
      await vi.advanceTimersByTimeAsync(1000 / 60);
      stream.advance(us);
      rendered.push(client?.sample().count ?? 0);
    }
    return { client: await connecting, rendered };
  }

  it('samples interpolated poses of all entities', async () => {
    const { client, rendered } = await playRecording(1);
    expect(rendered.at(-1)).toBe(client.entities.size);
    const [id] = client.entities.keys();
    expect(client.poseOf(id!)).toHaveLength(7);
    expect(client.poseOf(999_999)).toBeUndefined();
    client.close();
  });

  it('sends inputs in the form of the protocol', async () => {
    const socket = new FakeSocket();
    const connecting = connect({ url: 'ws://test/play', openSocket: () => socket });
    await Promise.resolve();
    socket.onopen!();
    socket.deliver({ message: { case: 'welcome', value: {} } });
    const client = await connecting;
    socket.take();
    client.applyImpulse(5, { x: 1, y: 2, z: 3 });
    client.grab(5, { x: 0, y: 1, z: 0 });
    client.drag({ x: 0, y: 2, z: 0 });
    client.release();
    client.takeControl(6);
    client.control([0.5, -1], 3);
    vi.advanceTimersByTime(34);
    const inputs = socket.take().flatMap((message) => (message.case === 'input' ? message.value.inputs : []));
    client.edit(5, { mass: 3, frozen: true, position: { x: 0, y: 9, z: 0 } });
    client.clone(5, { offset: { x: 1, y: 0, z: 0 }, jointed: true });
    client.createJoint({ entityB: 5, joint: { kind: { case: 'ball', value: {} }, breakForce: 100 } });
    client.deleteJoint(8);
    client.undo();
    client.stepRoom(2);
    client.setRoomSpeed(25);
    client.rewindRoom(600);
    vi.advanceTimersByTime(34);
    const tools = socket.take().flatMap((message) => (message.case === 'input' ? message.value.inputs : [])).map(({ kind }) => kind);
    expect(tools.map((kind) => kind.case)).toEqual(['edit', 'clone', 'createJoint', 'deleteJoint', 'undo', 'room', 'room', 'room']);
    expect(tools[0]!.value).toMatchObject({ entity: 5, mass: 3, frozen: true, position: { y: 9 } });
    expect((tools[0]!.value as { density?: number }).density).toBeUndefined();
    expect(tools[1]!.value).toMatchObject({ entity: 5, offset: { x: 1 }, jointed: true });
    expect(tools[2]!.value).toMatchObject({ entityA: 0, entityB: 5, joint: { kind: { case: 'ball' }, breakForce: 100 } });
    expect(tools.slice(5).map((kind) => (kind.value as { kind: unknown }).kind)).toMatchObject([
      { case: 'step', value: { steps: 2 } },
      { case: 'speed', value: { percent: 25 } },
      { case: 'rewind', value: { tick: 600 } },
    ]);
    expect(inputs.map(({ kind }) => kind.case)).toEqual(['impulse', 'grab', 'drag', 'release', 'possess', 'control']);
    expect(inputs[0]!.kind.value).toMatchObject({ entity: 5, impulse: { x: 1, y: 2, z: 3 } });
    expect(inputs[5]!.kind.value).toMatchObject({ axes: [500, -1000], buttons: 3 });
    client.close();
  });

  it('subscribes to players, attributes and topics, and resumes after the last message', async () => {
    const sockets: FakeSocket[] = [];
    const openSocket = () => {
      sockets.push(new FakeSocket());
      return sockets.at(-1)!;
    };
    const received: unknown[] = [];
    const connecting = connect({
      url: 'ws://test/play', openSocket, name: 'ann', color: 0xff8000, players: true, attributes: true, topics: ['chat'],
      listener: {
        userMessage: ({ from, data }) => received.push([from, new TextDecoder().decode(data)]),
        playerEvent: ({ kind, player }) => received.push([PlayerEventKind[kind], player?.name]),
        dataChanged: (data) => received.push(data.value({ kind: 'world' }, 'round')),
      },
    });
    await Promise.resolve();
    sockets[0]!.onopen!();
    expect(sockets[0]!.take()[0]).toMatchObject({ value: { name: 'ann', color: 0xff8000, players: true, attributes: true, topics: ['chat'] } });
    sockets[0]!.deliver({ message: { case: 'welcome', value: { clientId: 7, resumeToken: new Uint8Array([1, 2]) } } });
    const client = await connecting;
    const players = [{ events: [{ tick: 9, kind: PlayerEventKind.JOINED, player: { client: 8, name: 'bob' } }] }];
    const sets = [{ target: { case: 'world' as const, value: true }, attributes: [{ key: 'round', value: { case: 'integer' as const, value: 2n } }] }];
    const messages = [{ number: 41, from: 8, topic: 'chat', data: new TextEncoder().encode('hi') }];
    sockets[0]!.deliver({ message: { case: 'snapshot', value: { frame: 9, players, attributes: [{ sets }], messages } } });
    expect(received).toEqual([['JOINED', 'bob'], 2n, [8, 'hi']]);
    expect(client.data.players.get(8)?.name).toBe('bob');

    client.sendMessage('chat', 'hello', [8]);
    client.sendToServer('game', new Uint8Array([1, 255]));
    client.setAttributes({ kind: 'player', id: 7 }, { ready: true, score: 5n, gone: undefined }, AttributeVisibility.OWNER);
    client.rename('anna');
    vi.advanceTimersByTime(34);
    const inputs = sockets[0]!.take().flatMap((message) => (message.case === 'input' ? message.value.inputs : []));
    expect(inputs.map(({ kind }) => kind.case)).toEqual(['sendMessage', 'sendMessage', 'setAttributes', 'rename']);
    expect(inputs[0]!.kind.value).toMatchObject({ topic: 'chat', data: new TextEncoder().encode('hello'), to: [8], toServer: false });
    expect(inputs[1]!.kind.value).toMatchObject({ topic: 'game', data: new Uint8Array([1, 255]), to: [], toServer: true });
    expect(inputs[2]!.kind.value).toMatchObject({
      set: {
        target: { case: 'player', value: 7 },
        attributes: [
          { key: 'ready', value: { case: 'boolean', value: true }, visibility: AttributeVisibility.OWNER },
          { key: 'score', value: { case: 'integer', value: 5n } },
          { key: 'gone', value: { case: undefined } },
        ],
      },
    });

    sockets[0]!.onclose!({ code: 1006, reason: '' });
    await vi.advanceTimersByTimeAsync(300);
    sockets[1]!.onopen!();
    expect(sockets[1]!.take()[0]).toMatchObject({ value: { resume: { message: 41 } } });
    client.close();
  });
});
