import { describe, expect, it } from 'vitest';
import { bannerOf, shareOfSpeed, type WorldStatus } from './status_banner';

const runs: WorldStatus = { connection: 'playing', reason: '', hasPlayed: true, stats: { paused: '', timeScale: 1 }, mayResume: false, reconnected: undefined };

describe('banner', () => {
  it('is hidden while the world keeps its rate', () => {
    expect(bannerOf(runs)).toBeUndefined();
    expect(bannerOf({ ...runs, stats: { paused: '', timeScale: 0 } })).toBeUndefined();
    expect(bannerOf({ ...runs, connection: 'connecting', hasPlayed: false })).toBeUndefined();
  });
  it('offers to resume a paused world only to users who may', () => {
    const stats = { paused: 'it failed 3 times', timeScale: 0 };
    expect(bannerOf({ ...runs, stats, mayResume: true })).toMatchObject({ text: 'This world is paused: it failed 3 times.', action: 'resume' });
    expect(bannerOf({ ...runs, stats })).toMatchObject({ action: 'worlds', advice: expect.stringContaining('operator') });
  });
  it('does not call slow motion an overload', () => {
    expect(shareOfSpeed(0.1, 10, true)).toBeCloseTo(1);
    expect(shareOfSpeed(0.05, 10, true)).toBeCloseTo(0.5);
    expect(shareOfSpeed(0.4, 100, true)).toBe(0.4);
    expect(shareOfSpeed(0.1, 100, false)).toBe(1);
    expect(shareOfSpeed(0.4, 0, true)).toBe(0.4); // of an older server
  });
  it('explains a pause by a member without the operator', () => {
    const banner = bannerOf({ ...runs, stats: { paused: 'by a member of the room', timeScale: 0 }, mayResume: true });
    expect(banner).toMatchObject({ text: 'This world is paused by a member of the room.', advice: expect.stringContaining('Time') });
    expect(banner!.action).toBeUndefined();
  });
  it('shows the speed of a slow world', () => {
    expect(bannerOf({ ...runs, stats: { paused: '', timeScale: 0.423 } })).toMatchObject({ kind: 'slow', text: expect.stringContaining('42 %') });
  });
  it('explains a lost connection before everything else', () => {
    const stats = { paused: 'x', timeScale: 0 };
    expect(bannerOf({ ...runs, connection: 'waiting', reason: 'the server does not respond', stats })).toMatchObject({ kind: 'disconnected', text: 'The server does not respond.', action: 'reconnect' });
    expect(bannerOf({ ...runs, connection: 'stopped', reason: 'the world was deleted' })).toMatchObject({ kind: 'stopped', action: 'worlds' });
  });
  it('reports whether the session was resumed', () => {
    expect(bannerOf({ ...runs, reconnected: 'session' })?.advice).toContain('resumed');
    expect(bannerOf({ ...runs, reconnected: 'new client' })?.text).toContain('new client');
  });
});
