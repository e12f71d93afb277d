import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Connection, type ConnectionState } from './connection.js';
import { FakeSocket } from '../testing/fake_socket.js';
import { goldenChannels } from '../testing/golden_channels.js';
import { InputCode, NoticeCode } from '../gen/jostle/v1/play_pb.js';

describe('connection', () => {
  let sockets: FakeSocket[];
  let states: [ConnectionState, string][];
  let messages: string[];
  let connection: Connection;

  beforeEach(() => {
    vi.useFakeTimers();
    sockets = [];
    states = [];
    messages = [];
    connection = new Connection({
      url: 'ws://test/play',
      listener: {
        state: (s, reason) => states.push([s, reason]),
        entityList: () => {},
        stats: () => {},
        worldEvents: (events) => messages.push(`tick ${events.tick}`),
        inputRejected: (result) => messages.push(result.message),
        notice: (text) => messages.push(text),
      },
      openSocket: () => {
        sockets.push(new FakeSocket());
        return sockets[sockets.length - 1]!;
      },
    });
    connection.join('sandbox');
    sockets[0]!.onopen?.();
  });
  afterEach(() => {
    connection.stop();
    vi.useRealTimers();
  });

  const welcome = () =>
    sockets[sockets.length - 1]!.deliver({ message: { case: 'welcome', value: { clientId: 7 } } });

  it('sends hello first and names the world', () => {
    const [hello] = sockets[0]!.take();
    expect(hello).toMatchObject({ case: 'hello', value: { protocol: 1, world: 'sandbox' } });
  });

  it('numbers inputs from 1 without gaps, in at most 30 batches per second', () => {
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

  it('sends the first input after a pause at once, and the following ones with the next batch', async () => {
    welcome();
    vi.advanceTimersByTime(100);
    sockets[0]!.take();
    connection.send({ kind: { case: 'release', value: {} } });
    await Promise.resolve();
    expect(sockets[0]!.take().filter((m) => m.case === 'input').map((b) => b.value.firstSequence)).toEqual([1]);
    connection.send({ kind: { case: 'release', value: {} } });
    await Promise.resolve();
    expect(sockets[0]!.take()).toEqual([]);
    vi.advanceTimersByTime(67);
    expect(sockets[0]!.take().filter((m) => m.case === 'input').map((b) => b.value.firstSequence)).toEqual([2]);
  });

  it('returns the sequence number of an input, and 0 while it is not connected', () => {
    const release = { kind: { case: 'release' as const, value: {} } };
    expect(connection.send(release)).toBe(0);
    welcome();
    expect([connection.send(release), connection.send(release)]).toEqual([1, 2]);
  });

  it('changes the name in the current world and the identity of the next one', () => {
    welcome();
    sockets[0]!.take();
    connection.setIdentity('Ann', 0xff8000);
    connection.setIdentity('Ann', 0x00ff00); // no second rename
    vi.advanceTimersByTime(34);
    const inputs = sockets[0]!.take().flatMap((m) => (m.case === 'input' ? m.value.inputs : []));
    expect(inputs.map(({ kind }) => kind)).toMatchObject([{ case: 'rename', value: { name: 'Ann' } }]);
    connection.join('den', 'sesame');
    const socket = sockets.at(-1)!;
    socket.onopen!();
    expect(socket.take()[0]).toMatchObject({ case: 'hello', value: { world: 'den', joinCode: 'sesame', name: 'Ann', color: 0x00ff00 } });
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

  it('sets input ticks, sends immediately and notifies the predictor once the input clock runs', () => {
    welcome();
    const calls: unknown[] = [];
    const nothing = () => {};
    connection.enablePrediction({ begin: () => calls.push('begin'), entityAdded: nothing, entityRemoved: nothing, frame: nothing, controlledEntity: nothing, result: nothing,
      input: (sequence, tick, input) => calls.push([sequence, tick, input.kind?.case]),
    });
    const target = (x: number) => ({ kind: { case: 'drag' as const, value: { target: { x, y: 0, z: 0 } } } });
    connection.send(target(0));
    vi.advanceTimersByTime(70); // sent with its batch
    sockets[0]!.take();
    connection.inputClock.onFrame(100, 0, 0, performance.now() * 1000);
    const tick = connection.inputClock.tick(performance.now() * 1000);
    connection.send(target(1));
    const [batch] = sockets[0]!.take().filter((m) => m.case === 'input');
    expect(batch!.value).toMatchObject({ firstSequence: 2, inputs: [{ tick }] });
    connection.send(target(2));
    connection.send(target(3)); // replaces the previous target
    expect(sockets[0]!.take(), 'the next batch').toEqual([]);
    expect(calls).toEqual(['begin', [1, 0, 'drag'], [2, tick, 'drag'], [3, tick, 'drag'], [3, tick, 'drag']]);
  });

  it('notifies the predictor of the controlled entity, also when it is enabled later', () => {
    welcome();
    const calls: unknown[] = [];
    const nothing = () => {};
    const controlledEntity = (state: unknown) => calls.push(state);
    const state = { entity: 5, module: 'character', tick: 9, words: 1, keyframe: true, changedMask: Uint8Array.of(1), values: Uint8Array.of(7, 0, 0, 0) };
    sockets[0]!.deliver({ message: { case: 'snapshot', value: { frame: 9, packed: new Uint8Array(2), controlledEntity: state } } });
    connection.enablePrediction({ begin: nothing, entityAdded: nothing, entityRemoved: nothing, frame: nothing, result: nothing, input: nothing, controlledEntity });
    sockets[0]!.deliver({ message: { case: 'snapshot', value: { frame: 13, packed: new Uint8Array(2), controlledEntity: { ...state, tick: 13, keyframe: false, values: Uint8Array.of(8, 0, 0, 0) } } } });
    const controlled = (tick: number, word: number) => ({ entity: 5, module: 'character', tick, words: Uint32Array.of(word) });
    expect(calls).toEqual([controlled(9, 7), controlled(13, 8)]);
  });

  it('requests a keyframe for an unknown baseline and counts one decode error', () => {
    welcome();
    sockets[0]!.take();
    for (const frame of [50, 51])
      sockets[0]!.deliver({ message: { case: 'snapshot', value: { frame, baselines: frame - 49, packed: new Uint8Array(1) } } });
    const acks = sockets[0]!.take().filter((m) => m.case === 'ack');
    expect(acks[0]!.value.needKeyframe).toBe(true);
    expect(connection.decodeErrors).toBe(1);
  });

  it('acknowledges decoded frames and recovers after a keyframe', () => {
    welcome();
    sockets[0]!.take();
    const emptyFrame = new Uint8Array(2); // its CRC is 0
    const deliver = (frame: number, crc: number) =>
      sockets[0]!.deliver({ message: { case: 'snapshot', value: { frame, packed: emptyFrame, crc } } });
    deliver(50, 1);
    deliver(51, 0);
    const acks = sockets[0]!.take().flatMap((m) => (m.case === 'ack' ? [m.value] : []));
    expect(acks.map((a) => [a.frame, a.needKeyframe])).toEqual([
      [0, true],
      [51, false],
    ]);
    expect(connection.snapshots).toBe(1);
  });

  it('detects a flipped bit by the CRC, requests one keyframe and recovers', () => {
    welcome();
    sockets[0]!.take();
    const deliver = (frame: number, baselines: number, bytes: number[], crc = 0) =>
      sockets[0]!.deliver({ message: { case: 'snapshot', value: { frame, baselines, packed: new Uint8Array(bytes), crc } } });
    deliver(50, 0, [0, 0]); // a world without bodies
    deliver(51, 1 | (255 << 8), [0, 0x40]); // one flipped bit
    deliver(52, 1 | (255 << 8), [0, 0]); // against the frame that was not decoded
    expect(connection.decodeErrors).toBe(1);
    expect(connection.frames.newest?.frame).toBe(50);
    const keyframeRequests = sockets[0]!.take().flatMap((m) => (m.case === 'ack' && m.value.needKeyframe ? [m.value.frame] : []));
    expect(keyframeRequests).toEqual([50, 50]);
    deliver(53, 0, [0, 0]);
    expect(connection.frames.newest?.frame).toBe(53);
    expect(connection.decodeErrors).toBe(1);
  });

  it('stores the channels of each frame and discards stale ones after a loss', () => {
    welcome();
    const golden = goldenChannels();
    const k = golden.findIndex((frame) => frame.baseline !== 0 && golden[frame.baseline - 1]!.baseline === 0);
    const [first, second, empty] = [golden[golden[k]!.baseline - 1]!, golden[k]!, { packed: new Uint8Array(), crc: 0 }];
    const deliver = (frame: number, baselineFrame: number, data: { packed: Uint8Array; crc: number }) => {
      const packed = new Uint8Array(2); // a world without bodies, with or without a baseline; its CRC is 0
      const baselines = baselineFrame === 0 ? 0 : (frame - baselineFrame) | (255 << 8);
      const value = { frame, baselines, packed, crc: 0, channels: data.packed, channelsCrc: data.crc };
      sockets[0]!.deliver({ message: { case: 'snapshot', value } });
    };
    const channels = () => connection.frames.newest?.channels;
    deliver(50, 0, first);
    expect(channels()).toEqual(first.channels);
    deliver(51, 50, second);
    expect(channels()).toEqual(second.channels);
    deliver(52, 50, { packed: second.packed, crc: second.crc + 1 }); // damaged
    expect(connection.frames.newest?.frame).toBe(51);
    deliver(53, 50, empty);
    expect(channels()).toEqual(first.channels);
    deliver(54, 0, empty);
    expect(channels()).toEqual([]);
    expect(connection.decodeErrors).toBe(1);
  });

  it('reports rejected inputs and notices', () => {
    welcome();
    const inputRejected = { sequence: 2, code: InputCode.LIMIT, message: 'you own 64 bodies already' };
    sockets[0]!.deliver({
      message: {
        case: 'snapshot',
        value: { frame: 1, clientUpdate: { results: [{ sequence: 1, code: InputCode.APPLIED }, inputRejected] } },
      },
    });
    sockets[0]!.deliver({ message: { case: 'notice', value: { code: NoticeCode.RATE_LIMIT, message: 'slow down' } } });
    expect(messages).toEqual(['you own 64 bodies already', 'slow down']);
  });

  it('reconnects with increasing delays and reports the reason', () => {
    welcome();
    sockets[0]!.deliver({ message: { case: 'notice', value: { code: NoticeCode.DRAINING, message: 'going down' } } });
    sockets[0]!.onclose?.({ code: 1006, reason: '' });
    expect(states[states.length - 1]).toEqual(['waiting', 'going down']);
    vi.advanceTimersByTime(249);
    expect(sockets.length).toBe(1);
    vi.advanceTimersByTime(2);
    expect(sockets.length).toBe(2);
    sockets[1]!.onclose?.({ code: 1006, reason: '' });
    expect(states[states.length - 1]).toEqual(['waiting', 'the server does not respond']);
    vi.advanceTimersByTime(400);
    expect(sockets.length).toBe(2);
    vi.advanceTimersByTime(200);
    expect(sockets.length).toBe(3);
  });

  it('resumes its session with its frames and unconfirmed inputs', () => {
    const token = new Uint8Array([1, 2, 3]);
    sockets[0]!.deliver({ message: { case: 'welcome', value: { clientId: 7, resumeToken: token } } });
    sockets[0]!.deliver({ message: { case: 'snapshot', value: { frame: 50, packed: new Uint8Array(2) } } });
    for (let i = 0; i < 3; i++) connection.send({ kind: { case: 'release', value: {} } });
    vi.advanceTimersByTime(34);
    sockets[0]!.onclose?.({ code: 1006, reason: '' });
    vi.advanceTimersByTime(251);
    sockets[1]!.onopen?.();
    expect(sockets[1]!.take()[0]).toMatchObject({
      case: 'hello',
      value: { resumable: true, resume: { token, frame: 50 } },
    });
    const resumed = { clientId: 7, resumeToken: token, resumed: true, statePreserved: true, lastSequence: 1 };
    sockets[1]!.deliver({ message: { case: 'welcome', value: resumed } });
    vi.advanceTimersByTime(34);
    const [batch] = sockets[1]!.take().filter((m) => m.case === 'input');
    expect([batch!.value.firstSequence, batch!.value.inputs.length]).toEqual([2, 2]);
    sockets[1]!.deliver({ message: { case: 'snapshot', value: { frame: 53, baselines: 3 | (255 << 8), packed: new Uint8Array(2) } } });
    expect(connection.frames.newest?.frame).toBe(53);
    expect([connection.decodeErrors, connection.resumed]).toEqual([0, 1]);
    connection.join('pyramid'); // leaving ends the session
    sockets[2]!.onopen?.();
    const [hello] = sockets[2]!.take().flatMap((m) => (m.case === 'hello' ? [m.value] : []));
    expect([hello!.world, hello!.resume]).toEqual(['pyramid', undefined]);
  });

  it('treats five seconds of silence as a lost connection', () => {
    welcome();
    vi.advanceTimersByTime(4900);
    expect(connection.state).toBe('playing');
    vi.advanceTimersByTime(200);
    expect(states[states.length - 1]).toEqual(['waiting', 'the server does not respond']);
    expect(sockets[0]!.closed).toBe(true);
    vi.advanceTimersByTime(300);
    expect(sockets.length).toBe(2);
  });

  it('does not reconnect to a closed or unknown world', () => {
    welcome();
    sockets[0]!.deliver({ message: { case: 'notice', value: { code: NoticeCode.WORLD_CLOSED, message: 'closed' } } });
    sockets[0]!.onclose?.({ code: 1001, reason: 'closed' });
    expect(states[states.length - 1]).toEqual(['stopped', 'closed']);
    connection.join('nowhere');
    sockets[1]!.onopen?.();
    sockets[1]!.deliver({ message: { case: 'notice', value: { code: NoticeCode.REFUSED, message: 'no such world' } } });
    sockets[1]!.onclose?.({ code: 1008, reason: 'no such world' });
    expect(states[states.length - 1]).toEqual(['stopped', 'no such world']);
    vi.advanceTimersByTime(60_000);
    expect(sockets.length).toBe(2);
  });

  it('reconnects when the server is full', () => {
    sockets[0]!.deliver({ message: { case: 'notice', value: { code: NoticeCode.REFUSED, message: 'full' } } });
    sockets[0]!.onclose?.({ code: 1013, reason: 'full' });
    expect(states[states.length - 1]).toEqual(['waiting', 'full']);
    connection.retryNow();
    expect(sockets.length).toBe(2);
  });

  it('survives malformed messages', () => {
    welcome();
    sockets[0]!.onmessage?.({ data: new Uint8Array([0xff, 0xff, 0xff]).buffer });
    expect(connection.state).toBe('waiting');
  });

  it('leaves a world before joining another', () => {
    welcome();
    sockets[0]!.take();
    connection.join('pyramid');
    expect(sockets[0]!.take().map((m) => m.case)).toEqual(['leave']);
    expect(sockets[0]!.closed).toBe(true);
    sockets[1]!.onopen?.();
    expect(sockets[1]!.take()[0]).toMatchObject({ case: 'hello', value: { world: 'pyramid' } });
  });

  it('rejoins the world to subscribe to events and reports them', () => {
    welcome();
    expect(sockets[0]!.take()[0]).toMatchObject({ case: 'hello', value: { events: false } });
    connection.setEventsEnabled(false);
    expect(sockets.length).toBe(1);
    connection.setEventsEnabled(true);
    expect(sockets.length).toBe(2);
    sockets[1]!.onopen?.();
    expect(sockets[1]!.take()[0]).toMatchObject({ case: 'hello', value: { world: 'sandbox', events: true } });
    welcome();
    sockets[1]!.deliver({ message: { case: 'snapshot', value: { frame: 31, events: [{ tick: 31 }] } } });
    expect(messages).toEqual(['tick 31']);
  });
});
