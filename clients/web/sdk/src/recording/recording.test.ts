// Six seconds of the scene `machines`, recorded by jostle-record: 30 snapshots per second, a keyframe
// every 2 s.

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { Connection } from '../connection/connection.js';
import { POSE_FLOATS } from '../interpolation/frame_buffer.js';
import { RenderedPoses } from '../interpolation/rendered_poses.js';
import { Recording, RecordingError } from './recording.js';
import { RecordedStream } from './recorded_stream.js';

const bytes = () => new Uint8Array(readFileSync(new URL('../testing/machines.rec', import.meta.url)));

/** A connection that plays the recording, rendered 60 times per second of a simulated clock. */
async function play(recording: Recording) {
  const stream = new RecordedStream(recording);
  const states: string[] = [];
  const nothing = () => {};
  const connection = new Connection({
    url: '',
    listener: { state: (s, why) => states.push(s + why), entityList: nothing, stats: nothing, worldEvents: nothing, inputRejected: nothing, notice: nothing },
    openSocket: () => stream.open(),
  });
  connection.join('');
  await Promise.resolve();
  const rendered = new RenderedPoses();
  let us = 1e6;
  const run = (seconds: number) => {
    for (const end = us + seconds * 1e6; us < end; ) {
      us += 1e6 / 60;
      rendered.update(connection.frames, stream.advance(us), us);
    }
  };
  const poses = () => [...rendered.poses.subarray(0, rendered.count * POSE_FLOATS)];
  return { stream, connection, rendered, run, poses, states };
}

describe('recording', () => {
  it('is read by its records, not by its index', () => {
    const recording = new Recording(bytes());
    expect([recording.firstTick, recording.lastTick, recording.truncationReason]).toEqual([191, 550, '']);
    expect(recording.messages.filter(({ keyframe }) => keyframe)).toHaveLength(3);
    expect(recording.welcome.tickHz).toBe(60);
  });

  it('truncated at any byte is read up to the cut', () => {
    const complete = bytes();
    const messages = new Recording(complete).messages.length;
    let last = 0;
    for (let end = complete.length; end > 0; end -= 97) {
      try {
        const truncated = new Recording(complete.subarray(0, end));
        expect(truncated.messages.length).toBeLessThanOrEqual(messages);
        last = truncated.messages.length;
      } catch (error) {
        expect(error).toBeInstanceOf(RecordingError);
      }
    }
    expect(last, 'Welcome, entity updates and a keyframe').toBeLessThan(10);
  });

  it('skips a damaged record and the snapshots up to the next keyframe', () => {
    const whole = new Recording(bytes());
    const damaged = bytes();
    damaged[6000]! ^= 1;
    const recording = new Recording(damaged);
    expect([recording.firstTick, recording.lastTick, recording.truncationReason]).toEqual([191, 550, '']);
    expect(recording.damage).toHaveLength(1);
    const [range] = recording.damage;
    expect(range!.byte).toBeLessThanOrEqual(6000);
    expect(range!.byte + range!.length).toBeGreaterThan(6000);
    expect(range!.reason).toBe(`byte ${range!.byte}: CRC mismatch: the record is damaged`);
    expect(range!.snapshotsSkipped).toBeGreaterThan(0);
    expect(recording.messages.length, 'the record and the snapshots that refer to it').toBe(whole.messages.length - 1 - range!.snapshotsSkipped);
    const frames = recording.messages.filter(({ frame }) => frame > 0);
    const after = frames.findIndex(({ frame }, i) => i > 0 && frame - frames[i - 1]!.frame > 10);
    expect(frames[after]!.keyframe).toBe(true);
  });

  it('finds the next record if lengths are damaged as well', () => {
    const damaged = bytes();
    damaged.fill(0x5a, 5900, 6100);
    const recording = new Recording(damaged);
    expect(recording.lastTick).toBe(550);
    expect(recording.damage).toHaveLength(1);
    expect(recording.damage[0]!.length).toBeGreaterThanOrEqual(100);
    expect(recording.damage[0]!.reason).toMatch(/^byte \d+: (invalid message length|truncated message|CRC mismatch)/);
  });

  it('reports damage that nothing follows as the end', () => {
    const damaged = bytes();
    damaged.fill(0x5a, 6000);
    const recording = new Recording(damaged);
    expect(recording.lastTick).toBeLessThan(550);
    expect(recording.damage).toEqual([]);
    expect(recording.truncationReason).toMatch(/^byte \d+: /);
  });

  it('shows the same state before and after the damage as the whole recording', async () => {
    const damaged = bytes();
    damaged[6000]! ^= 1;
    const poses: number[][] = [];
    for (const recording of [new Recording(bytes()), new Recording(damaged)]) {
      const { stream, connection, run, poses: current } = await play(recording);
      run(5.5);
      stream.playing = false;
      run(0.05);
      stream.seek(5);
      run(0.05);
      poses.push(current());
      expect([connection.state, connection.decodeErrors]).toEqual(['playing', 0]);
      connection.stop();
    }
    expect(poses[1]).toEqual(poses[0]);
  });

  it('rejects other files with an error message', () => {
    expect(() => new Recording(new TextEncoder().encode('nothing of that kind'))).toThrow('byte 0: not a recording: must start with "JREC"; create one with jostle-record');
    const later = bytes();
    later[4] = 2;
    expect(() => new Recording(later)).toThrow('byte 4: unsupported version 2; supported: 1');
    expect(() => new Recording(bytes().subarray(0, 16))).toThrow('the recording has no keyframe');
  });
});

describe('recorded stream', () => {
  it('plays in real time through the live connection path', async () => {
    const { stream, connection, rendered, run, states } = await play(new Recording(bytes()));
    run(3);
    expect([connection.state, connection.decodeErrors]).toEqual(['playing', 0]);
    expect(stream.seconds).toBeCloseTo(3, 1);
    expect(rendered.count).toBe(connection.entities.size);
    expect(rendered.source!.frame).toBeGreaterThanOrEqual(stream.tick);
    run(4);
    expect([stream.playing, stream.tick, stream.seconds]).toEqual([false, 550, stream.length]);
    expect(states).toEqual(['stopped', 'connecting', 'playing']);
    stream.play();
    run(0.1);
    expect(stream.seconds, 'from the start').toBeLessThan(0.2);
    connection.stop();
  });

  it('shows the same state of a tick after seeking and after playing', async () => {
    const { stream, connection, run, poses } = await play(new Recording(bytes()));
    stream.playing = false;
    run(0.05);
    const first = poses();
    stream.seek(4.5);
    run(0.05);
    const jumped = poses();
    expect(jumped).not.toEqual(first);
    stream.seek(1);
    run(0.05);
    for (let s = 1.1; s < 4.5; s += 0.25) {
      stream.seek(s);
      run(0.05);
    }
    stream.seek(4.5);
    run(0.05);
    expect(poses(), 'in steps').toEqual(jumped);
    stream.seek(0);
    run(1);
    expect(poses(), 'back at the start, paused').toEqual(first);
    expect(connection.decodeErrors).toBe(0);
    connection.stop();
  });

  it('plays at the selected speed', async () => {
    const { stream, connection, run } = await play(new Recording(bytes()));
    stream.speed = 4;
    run(1);
    expect(stream.seconds).toBeCloseTo(4, 0);
    stream.speed = 0.25;
    const previous = stream.seconds;
    run(1);
    expect(stream.seconds - previous).toBeCloseTo(0.25, 1);
    connection.stop();
  });
});
