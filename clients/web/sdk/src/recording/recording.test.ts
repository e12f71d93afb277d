// Six seconds of the scene `machines`, as jostle-record wrote them: 30 snapshots a second, a keyframe every 2 s.

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { Connection } from '../connection/connection.js';
import { POSE_FLOATS } from '../interpolation/frame_buffer.js';
import { RenderedPoses } from '../interpolation/rendered_poses.js';
import { Recording, RecordingError } from './recording.js';
import { RecordedStream } from './recorded_stream.js';

const bytes = () => new Uint8Array(readFileSync(new URL('../testing/machines.rec', import.meta.url)));

/** A connection that gets the recording, drawn 60 times a second of a clock of its own. */
async function watch(recording: Recording) {
  const stream = new RecordedStream(recording);
  const states: string[] = [];
  const nothing = () => {};
  const connection = new Connection('', { state: (s, why) => states.push(s + why), entityList: nothing, stats: nothing, worldEvents: nothing, inputRejected: nothing, notice: nothing }, () => stream.open());
  connection.join('');
  await Promise.resolve();
  const drawn = new RenderedPoses();
  let us = 1e6;
  const run = (seconds: number) => {
    for (const end = us + seconds * 1e6; us < end; ) {
      us += 1e6 / 60;
      drawn.update(connection.frames, stream.advance(us), us);
    }
  };
  const poses = () => [...drawn.poses.subarray(0, drawn.count * POSE_FLOATS)];
  return { stream, connection, drawn, run, poses, states };
}

describe('recording', () => {
  it('is read whole, by its records and not by its index', () => {
    const recording = new Recording(bytes());
    expect([recording.firstTick, recording.lastTick, recording.truncationReason]).toEqual([191, 550, '']);
    expect(recording.messages.filter(({ keyframe }) => keyframe)).toHaveLength(3);
    expect(recording.welcome.tickHz).toBe(60);
  });

  it('that was cut off at any byte is read as far as it goes', () => {
    const whole = bytes();
    const messages = new Recording(whole).messages.length;
    let last = 0;
    for (let end = whole.length; end > 0; end -= 97) {
      try {
        const truncationReason = new Recording(whole.subarray(0, end));
        expect(truncationReason.messages.length).toBeLessThanOrEqual(messages);
        last = truncationReason.messages.length;
      } catch (error) {
        expect(error).toBeInstanceOf(RecordingError);
      }
    }
    expect(last, 'the Welcome, who is there, a keyframe').toBeLessThan(10);
  });

  it('is played up to what is damaged, and says what that is', () => {
    const damaged = bytes();
    damaged[6000]! ^= 1;
    const recording = new Recording(damaged);
    expect(recording.lastTick).toBeGreaterThan(191);
    expect(recording.lastTick).toBeLessThan(550);
    expect(recording.truncationReason).toMatch(/^byte \d+: the CRC of the record does not match: it is damaged$/);
  });

  it('says what is wrong with what is none', () => {
    expect(() => new Recording(new TextEncoder().encode('nothing of that kind'))).toThrow('byte 0: it is no recording, which begins with the letters JREC; jostle-record makes one');
    const later = bytes();
    later[4] = 2;
    expect(() => new Recording(later)).toThrow('byte 4: it is a recording of version 2; this page plays version 1');
    expect(() => new Recording(bytes().subarray(0, 16))).toThrow('nothing was recorded that could be shown');
  });
});

describe('recorded stream', () => {
  it('plays in real time through the path of a live world, to its end', async () => {
    const { stream, connection, drawn, run, states } = await watch(new Recording(bytes()));
    run(3);
    expect([connection.state, connection.decodeErrors]).toEqual(['playing', 0]);
    expect(stream.seconds).toBeCloseTo(3, 1);
    expect(drawn.count).toBe(connection.entities.size);
    expect(drawn.source!.frame).toBeGreaterThanOrEqual(stream.tick);
    run(4);
    expect([stream.playing, stream.tick, stream.seconds]).toEqual([false, 550, stream.length]);
    expect(states).toEqual(['stopped', 'connecting', 'playing']);
    stream.play();
    run(0.1);
    expect(stream.seconds, 'from the beginning').toBeLessThan(0.2);
    connection.stop();
  });

  it('shows a tick the same, however one came there', async () => {
    const { stream, connection, run, poses } = await watch(new Recording(bytes()));
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
    expect(poses(), 'back, and it stands').toEqual(first);
    expect(connection.decodeErrors).toBe(0);
    connection.stop();
  });

  it('goes at the speed that one wants', async () => {
    const { stream, connection, run } = await watch(new Recording(bytes()));
    stream.speed = 4;
    run(1);
    expect(stream.seconds).toBeCloseTo(4, 0);
    stream.speed = 0.25;
    const before = stream.seconds;
    run(1);
    expect(stream.seconds - before).toBeCloseTo(0.25, 1);
    connection.stop();
  });
});
