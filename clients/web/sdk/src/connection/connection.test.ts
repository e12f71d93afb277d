import { create, fromBinary, toBinary } from '@bufbuild/protobuf';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Connection, type Socket, type State } from './connection.js';
import { goldenChannels } from '../testing/golden_channels.js';
import { ClientMessageSchema, InputCode, NoticeCode, ServerMessageSchema } from '../gen/jostle/v1/play_pb.js';

class FakeSocket implements Socket {
  binaryType = '';
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  sent: Uint8Array[] = [];
  send(bytes: Uint8Array) {
    this.sent.push(bytes);
  }
  closed = false;
  close() {
    this.closed = true;
  }
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
  let said: string[];
  let connection: Connection;

  beforeEach(() => {
    vi.useFakeTimers();
    sockets = [];
    states = [];
    said = [];
    connection = new Connection(
      'ws://test/play',
      {
        state: (s, why) => states.push([s, why]),
        entityList: () => {},
        stats: () => {},
        worldEvents: (events) => said.push(`tick ${events.tick}`),
        inputRejected: (result) => said.push(result.message),
        notice: (text) => said.push(text),
      },
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

  it('names ticks, sends at once and tells who foresees, once the input clock runs', () => {
    welcome();
    const heard: unknown[] = [];
    const nothing = () => {};
    connection.enablePrediction({ begin: () => heard.push('begin'), entityAdded: nothing, entityRemoved: nothing, frame: nothing, controlledEntity: nothing, result: nothing,
      input: (sequence, tick, input) => heard.push([sequence, tick, input.kind?.case]),
    });
    const target = (x: number) => ({ kind: { case: 'drag' as const, value: { target: { x, y: 0, z: 0 } } } });
    connection.send(target(0));
    vi.advanceTimersByTime(70); // it left with its batch
    sockets[0]!.take();
    connection.inputClock.onFrame(100, 0, 0, performance.now() * 1000);
    const tick = connection.inputClock.tick(performance.now() * 1000);
    connection.send(target(1));
    const [batch] = sockets[0]!.take().filter((m) => m.case === 'input');
    expect(batch!.value).toMatchObject({ firstSequence: 2, inputs: [{ tick }] });
    connection.send(target(2));
    connection.send(target(3)); // in its place
    expect(sockets[0]!.take(), 'the next batch').toEqual([]);
    expect(heard).toEqual(['begin', [1, 0, 'drag'], [2, tick, 'drag'], [3, tick, 'drag'], [3, tick, 'drag']]);
  });

  it('tells who foresees what is driven, also when he comes later', () => {
    welcome();
    const heard: unknown[] = [];
    const nothing = () => {};
    const driven = (thing: unknown) => heard.push(thing);
    const told = { entity: 5, module: 'character', tick: 9, words: 1, keyframe: true, changedMask: Uint8Array.of(1), values: Uint8Array.of(7, 0, 0, 0) };
    sockets[0]!.give({ message: { case: 'snapshot', value: { frame: 9, packed: new Uint8Array(2), controlledEntity: told } } });
    connection.enablePrediction({ begin: nothing, entityAdded: nothing, entityRemoved: nothing, frame: nothing, result: nothing, input: nothing, controlledEntity: driven });
    sockets[0]!.give({ message: { case: 'snapshot', value: { frame: 13, packed: new Uint8Array(2), controlledEntity: { ...told, tick: 13, keyframe: false, values: Uint8Array.of(8, 0, 0, 0) } } } });
    const thing = (tick: number, word: number) => ({ entity: 5, module: 'character', tick, words: Uint32Array.of(word) });
    expect(heard).toEqual([thing(9, 7), thing(13, 8)]);
  });

  it('asks for a keyframe when it does not know the base, and counts it once', () => {
    welcome();
    sockets[0]!.take();
    for (const frame of [50, 51])
      sockets[0]!.give({ message: { case: 'snapshot', value: { frame, baselines: frame - 49, packed: new Uint8Array(1) } } });
    const acks = sockets[0]!.take().filter((m) => m.case === 'ack');
    expect(acks[0]!.value.needKeyframe).toBe(true);
    expect(connection.decodeErrors).toBe(1);
  });

  it('acknowledges what it decoded, and is whole again after a keyframe', () => {
    welcome();
    sockets[0]!.take();
    const emptyWorld = new Uint8Array(2); // its CRC is 0
    const give = (frame: number, crc: number) =>
      sockets[0]!.give({ message: { case: 'snapshot', value: { frame, packed: emptyWorld, crc } } });
    give(50, 1);
    give(51, 0);
    const acks = sockets[0]!.take().flatMap((m) => (m.case === 'ack' ? [m.value] : []));
    expect(acks.map((a) => [a.frame, a.needKeyframe])).toEqual([
      [0, true],
      [51, false],
    ]);
    expect(connection.snapshots).toBe(1);
  });

  it('sees a flipped bit by the CRC, asks for a keyframe once and is right again', () => {
    welcome();
    sockets[0]!.take();
    const give = (frame: number, baselines: number, bytes: number[], crc = 0) =>
      sockets[0]!.give({ message: { case: 'snapshot', value: { frame, baselines, packed: new Uint8Array(bytes), crc } } });
    give(50, 0, [0, 0]); // a world without bodies
    give(51, 1 | (255 << 8), [0, 0x40]); // one bit of its zeros
    give(52, 1 | (255 << 8), [0, 0]); // against the one that was not understood
    expect(connection.decodeErrors).toBe(1);
    expect(connection.frames.newest?.frame).toBe(50);
    const asked = sockets[0]!.take().flatMap((m) => (m.case === 'ack' && m.value.needKeyframe ? [m.value.frame] : []));
    expect(asked).toEqual([50, 50]);
    give(53, 0, [0, 0]);
    expect(connection.frames.newest?.frame).toBe(53);
    expect(connection.decodeErrors).toBe(1);
  });

  it('keeps what modules tell with each frame, and nothing stale after a loss', () => {
    welcome();
    const golden = goldenChannels();
    const k = golden.findIndex((frame) => frame.base !== 0 && golden[frame.base - 1]!.base === 0);
    const [first, second, empty] = [golden[golden[k]!.base - 1]!, golden[k]!, { packed: new Uint8Array(), crc: 0 }];
    const give = (frame: number, baseFrame: number, told: { packed: Uint8Array; crc: number }) => {
      const packed = new Uint8Array(2); // a world without bodies, absolute or against another; its CRC is 0
      const baselines = baseFrame === 0 ? 0 : (frame - baseFrame) | (255 << 8);
      const value = { frame, baselines, packed, crc: 0, channels: told.packed, channelsCrc: told.crc };
      sockets[0]!.give({ message: { case: 'snapshot', value } });
    };
    const told = () => connection.frames.newest?.channels;
    give(50, 0, first);
    expect(told()).toEqual(first.channels);
    give(51, 50, second);
    expect(told()).toEqual(second.channels);
    give(52, 50, { packed: second.packed, crc: second.crc + 1 }); // damaged
    expect(connection.frames.newest?.frame).toBe(51);
    give(53, 50, empty);
    expect(told()).toEqual(first.channels);
    give(54, 0, empty);
    expect(told()).toEqual([]);
    expect(connection.decodeErrors).toBe(1);
  });

  it('hands on what the server refused and what it has to say', () => {
    welcome();
    const inputRejected = { sequence: 2, code: InputCode.LIMIT, message: 'you own 64 bodies already' };
    sockets[0]!.give({
      message: {
        case: 'snapshot',
        value: { frame: 1, clientUpdate: { results: [{ sequence: 1, code: InputCode.APPLIED }, inputRejected] } },
      },
    });
    sockets[0]!.give({ message: { case: 'notice', value: { code: NoticeCode.RATE_LIMIT, message: 'slow down' } } });
    expect(said).toEqual(['you own 64 bodies already', 'slow down']);
  });

  it('comes back after a loss, with growing pauses, and says why', () => {
    welcome();
    sockets[0]!.give({ message: { case: 'notice', value: { code: NoticeCode.DRAINING, message: 'going down' } } });
    sockets[0]!.onclose?.({ code: 1006, reason: '' });
    expect(states[states.length - 1]).toEqual(['waiting', 'going down']);
    vi.advanceTimersByTime(249);
    expect(sockets.length).toBe(1);
    vi.advanceTimersByTime(2);
    expect(sockets.length).toBe(2);
    sockets[1]!.onclose?.({ code: 1006, reason: '' });
    expect(states[states.length - 1]).toEqual(['waiting', 'the server does not answer']);
    vi.advanceTimersByTime(400);
    expect(sockets.length).toBe(2);
    vi.advanceTimersByTime(200);
    expect(sockets.length).toBe(3);
  });

  it('comes back as the client that it was: its frames, and the inputs that did not come', () => {
    const token = new Uint8Array([1, 2, 3]);
    sockets[0]!.give({ message: { case: 'welcome', value: { clientId: 7, resumeToken: token } } });
    sockets[0]!.give({ message: { case: 'snapshot', value: { frame: 50, packed: new Uint8Array(2) } } });
    for (let i = 0; i < 3; i++) connection.send({ kind: { case: 'release', value: {} } });
    vi.advanceTimersByTime(34);
    sockets[0]!.onclose?.({ code: 1006, reason: '' });
    vi.advanceTimersByTime(251);
    sockets[1]!.onopen?.();
    expect(sockets[1]!.take()[0]).toMatchObject({
      case: 'hello',
      value: { resumable: true, resume: { token, frame: 50 } },
    });
    const back = { clientId: 7, resumeToken: token, resumed: true, statePreserved: true, lastSequence: 1 };
    sockets[1]!.give({ message: { case: 'welcome', value: back } });
    vi.advanceTimersByTime(34);
    const [batch] = sockets[1]!.take().filter((m) => m.case === 'input');
    expect([batch!.value.firstSequence, batch!.value.inputs.length]).toEqual([2, 2]);
    sockets[1]!.give({ message: { case: 'snapshot', value: { frame: 53, baselines: 3 | (255 << 8), packed: new Uint8Array(2) } } });
    expect(connection.frames.newest?.frame).toBe(53);
    expect([connection.decodeErrors, connection.resumed]).toEqual([0, 1]);
    connection.join('pyramid'); // who leaves has no place to come back to
    sockets[2]!.onopen?.();
    const [hello] = sockets[2]!.take().flatMap((m) => (m.case === 'hello' ? [m.value] : []));
    expect([hello!.world, hello!.resume]).toEqual(['pyramid', undefined]);
  });

  it('takes five seconds of silence for a loss', () => {
    welcome();
    vi.advanceTimersByTime(4900);
    expect(connection.state).toBe('playing');
    vi.advanceTimersByTime(200);
    expect(states[states.length - 1]).toEqual(['waiting', 'the server does not answer']);
    expect(sockets[0]!.closed).toBe(true);
    vi.advanceTimersByTime(300);
    expect(sockets.length).toBe(2);
  });

  it('does not knock again where the world was closed or never was', () => {
    welcome();
    sockets[0]!.give({ message: { case: 'notice', value: { code: NoticeCode.WORLD_CLOSED, message: 'closed' } } });
    sockets[0]!.onclose?.({ code: 1001, reason: 'closed' });
    expect(states[states.length - 1]).toEqual(['stopped', 'closed']);
    connection.join('nowhere');
    sockets[1]!.onopen?.();
    sockets[1]!.give({ message: { case: 'notice', value: { code: NoticeCode.REFUSED, message: 'no such world' } } });
    sockets[1]!.onclose?.({ code: 1008, reason: 'no such world' });
    expect(states[states.length - 1]).toEqual(['stopped', 'no such world']);
    vi.advanceTimersByTime(60_000);
    expect(sockets.length).toBe(2);
  });

  it('knocks again where the server is full', () => {
    sockets[0]!.give({ message: { case: 'notice', value: { code: NoticeCode.REFUSED, message: 'full' } } });
    sockets[0]!.onclose?.({ code: 1013, reason: 'full' });
    expect(states[states.length - 1]).toEqual(['waiting', 'full']);
    connection.retryNow();
    expect(sockets.length).toBe(2);
  });

  it('survives bytes that are no message', () => {
    welcome();
    sockets[0]!.onmessage?.({ data: new Uint8Array([0xff, 0xff, 0xff]).buffer });
    expect(connection.state).toBe('waiting');
  });

  it('leaves one world before it joins another', () => {
    welcome();
    sockets[0]!.take();
    connection.join('pyramid');
    expect(sockets[0]!.take().map((m) => m.case)).toEqual(['leave']);
    expect(sockets[0]!.closed).toBe(true);
    sockets[1]!.onopen?.();
    expect(sockets[1]!.take()[0]).toMatchObject({ case: 'hello', value: { world: 'pyramid' } });
  });

  it('asks for events by coming back to the same world, and hands them on', () => {
    welcome();
    expect(sockets[0]!.take()[0]).toMatchObject({ case: 'hello', value: { events: false } });
    connection.setEventsEnabled(false);
    expect(sockets.length).toBe(1);
    connection.setEventsEnabled(true);
    expect(sockets.length).toBe(2);
    sockets[1]!.onopen?.();
    expect(sockets[1]!.take()[0]).toMatchObject({ case: 'hello', value: { world: 'sandbox', events: true } });
    welcome();
    sockets[1]!.give({ message: { case: 'snapshot', value: { frame: 31, events: [{ tick: 31 }] } } });
    expect(said).toEqual(['tick 31']);
  });
});
