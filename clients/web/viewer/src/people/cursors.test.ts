import * as THREE from 'three';
import { describe, expect, it } from 'vitest';
import { CursorSender, decodeCursor, encodeCursor, RemoteCursors } from './cursors';
import { MessageBudget } from './message_budget';

const bytes = (value: unknown) => new TextEncoder().encode(typeof value === 'string' ? value : JSON.stringify(value));
const at = (x: number) => ({ x, y: 0, z: 0 });

function sender() {
  const sent: { atMs: number; message: ReturnType<typeof decodeCursor> }[] = [];
  let now = 0;
  const one = new CursorSender(new MessageBudget(), (data) => sent.push({ atMs: now, message: decodeCursor(data, now) }));
  const run = (toMs: number, others: number, x: (ms: number) => number | undefined) => {
    for (; now < toMs; now += 16) {
      const position = x(now);
      one.update(now, others, position === undefined ? undefined : at(position), undefined);
    }
  };
  return { one, sent, run };
}

describe('CursorSender', () => {
  it('samples a moving cursor 10 times per second in 3 messages per second', () => {
    const { sent, run } = sender();
    run(10_000, 1, (ms) => ms / 100);
    expect(sent.length).toBeGreaterThan(26);
    expect(sent.length).toBeLessThanOrEqual(31);
    const samples = sent.flatMap(({ message }) => message!.samples);
    expect(samples.length).toBeLessThanOrEqual(100);
    expect(samples.length).toBeGreaterThan(80);
  });

  it('sends nothing while the cursor rests or the client is alone', () => {
    const { sent, run } = sender();
    run(5000, 0, (ms) => ms);
    expect(sent.length).toBe(0);
    run(10_000, 1, () => 3);
    expect(sent.length).toBe(1);
  });

  it('sends once that the cursor left the view, and a resting one to clients that join', () => {
    const { one, sent, run } = sender();
    run(1000, 1, () => 3);
    run(3000, 1, () => undefined);
    expect(sent.map(({ message }) => message!.samples.length)).toEqual([1, 0]);
    run(5000, 1, () => 3);
    one.resend();
    run(7000, 2, () => 3);
    expect(sent.length).toBe(4);
  });

  it('sends less often to many players', () => {
    const { sent, run } = sender();
    run(12_000, 40, (ms) => ms);
    expect(sent.length).toBeLessThanOrEqual(11);
  });

  it('sends the grabbed body', () => {
    const sent: ReturnType<typeof decodeCursor>[] = [];
    const one = new CursorSender(new MessageBudget(), (data) => sent.push(decodeCursor(data, 0)));
    one.update(0, 1, at(1), { entity: 7, point: new THREE.Vector3(0.1, 0.2, 0.3), target: new THREE.Vector3(1, 0, 0) });
    expect(sent[0]!.grab).toEqual({ entity: 7, point: { x: 0.1, y: 0.2, z: 0.3 } });
  });
});

describe('decodeCursor', () => {
  it('reads what encodeCursor wrote, to 1 mm', () => {
    const message = { samples: [{ atMs: 50, x: 1.23456, y: -2, z: 3e5 }], grab: { entity: 4, point: at(0.5) } };
    expect(decodeCursor(encodeCursor(message, 100), 100)).toEqual({ ...message, samples: [{ atMs: 50, x: 1.235, y: -2, z: 3e5 }] });
  });

  it('rejects malformed messages', () => {
    const malformed: unknown[] = ['', '{', 'null', '[]', {}, { p: 3 }, { p: [[0, 1, 2]] }, { p: [[0, 1, 2, 'x']] }, { p: [[-1, 0, 0, 0]] }, { p: [[9e9, 0, 0, 0]] },
      { p: [[0, 1e7, 0, 0]] }, { p: [[0, null, 0, 0]] }, { p: Array.from({ length: 9 }, () => [0, 0, 0, 0]) }, { p: [], g: 1 }, { p: [], g: [1.5, 0, 0, 0] }, { p: [], g: [-1, 0, 0, 0] }, { p: [], g: null }];
    for (const one of malformed) expect(decodeCursor(bytes(one), 0), JSON.stringify(one)).toBeUndefined();
  });
});

describe('RemoteCursors', () => {
  it('plays samples back evenly, 0.45 s later, and hides a cursor that left', () => {
    const cursors = new RemoteCursors();
    cursors.receive(3, encodeCursor({ samples: [{ atMs: 700, ...at(0) }, { atMs: 900, ...at(2) }], grab: undefined }, 1000), 1000);
    expect(cursors.shown(1250)[0]!.position.x).toBeCloseTo(1);
    expect(cursors.shown(5000)[0]!.position.x).toBe(2);
    expect(cursors.shown(25_000)).toEqual([]);
    cursors.receive(3, bytes({ p: [] }), 5000);
    expect(cursors.shown(5000)).toEqual([]);
  });

  it('ignores samples that are older than those it has', () => {
    const cursors = new RemoteCursors();
    cursors.receive(3, bytes({ p: [[0, 5, 0, 0]] }), 1000);
    cursors.receive(3, bytes({ p: [[500, 9, 0, 0]] }), 1100);
    expect(cursors.shown(2000)[0]!.position.x).toBe(5);
  });
});
