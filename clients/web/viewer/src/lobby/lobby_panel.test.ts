import { expect, it } from 'vitest';
import { aboutWorld, matches } from './lobby_panel';
import { ApiError, ServerApi, type WorldInfo } from './server_api';

const world: WorldInfo = { id: 'w1', name: 'track', scene: 'race_track', bodies: 1, awake: 0, clients: 6, hz: 60, tick: 0, paused: '', oldestRestorableTick: 0 };
const room = { title: 'Night race', description: 'Six cars', tags: ['cars'], capacity: 6, isPrivate: true, players: 6, spectators: 0 };

it('describes worlds and rooms', () => {
  expect(aboutWorld(world)).toBe('6\u00a0players · 1\u00a0body');
  expect(aboutWorld({ ...world, room, paused: 'by the owner' })).toBe('6\u00a0of\u00a06\u00a0players · 1\u00a0body · private · full · paused');
});

it('searches name, title, description, scene and tags', () => {
  const found = ['TRACK', 'night', 'six', 'race_track', 'cars', '', 'boat'].map((text) => matches({ ...world, room }, text));
  expect(found).toEqual([true, true, true, true, true, true, false]);
});

it('reports the reason of a refusal', async () => {
  const respond = (status: number, body: string) => new ServerApi('', async () => new Response(body, { status }));
  await expect(respond(400, '{"message": "line 1, column 2: x"}').list()).rejects.toThrow(new ApiError('line 1, column 2: x', 400));
  await expect(respond(502, '').list()).rejects.toThrow('the server responded with HTTP status 502');
  const unreachable = new ServerApi('', async () => {
    throw new TypeError('fetch failed');
  });
  await expect(unreachable.list()).rejects.toThrow('the server does not respond');
});
