import { expect, it } from 'vitest';
import { Queries, type Post } from './queries.js';

const ray = { rays: [{ origin: { x: 0, y: 5, z: 0 }, motion: { x: 0, y: -10, z: 0 } }] };

function server(...answers: (readonly [number, string])[]) {
  const asked: [string, string][] = [];
  const post: Post = async (path, body) => {
    asked.push([path, body]);
    const [status, text] = answers[Math.min(asked.length, answers.length) - 1]!;
    return { status, text: async () => text };
  };
  return { asked, post };
}

it('names the world, and reads the JSON form', async () => {
  const { asked, post } = server([200, '{"tick":7,"rays":[{"hits":[{"entity":3,"fraction":0.4,"point":{"y":1},"newer":1}]}]}']);
  const answer = await new Queries(() => 'w1', post).castRays(ray);
  expect(asked).toEqual([
    ['api/query/CastRays', '{"world":"w1","rays":[{"origin":{"y":5},"motion":{"y":-10}}]}'],
  ]);
  expect(answer!.tick).toBe(7);
  expect(answer!.rays[0]!.hits[0]).toMatchObject({ entity: 3, fraction: 0.4, shape: 0, point: { x: 0, y: 1 } });
});

it('does not ask an older server twice, until in another world', async () => {
  const { asked, post } = server([404, 'There is no such path']);
  let world = 'w1';
  const queries = new Queries(() => world, post);
  for (let i = 0; i < 5; i++) expect(await queries.castRays(ray)).toBeUndefined();
  expect(asked.length).toBe(1);
  world = 'w2';
  await queries.castRays(ray);
  expect(asked.length).toBe(2);
});

it('asks again after a server that was only busy', async () => {
  const { asked, post } = server([503, 'busy'], [200, '{"tick":1}']);
  const queries = new Queries(() => 'w1', post);
  expect(await queries.debug({ contacts: true })).toBeUndefined();
  expect((await queries.debug({ contacts: true }))!.tick).toBe(1);
  expect(asked.length).toBe(2);
});

it('takes nonsense, silence and a world that was left for no answer', async () => {
  expect(await new Queries(() => 'w1', server([200, '<html>']).post).castRays(ray)).toBeUndefined();
  expect(await new Queries(() => 'w1', () => Promise.reject(new Error('offline'))).castRays(ray)).toBeUndefined();
  expect(await new Queries(() => '', server([200, '{}']).post).castRays(ray)).toBeUndefined();
  let world = 'w1';
  const left: Post = async () => {
    world = 'w2';
    return { status: 200, text: async () => '{"tick":1}' };
  };
  expect(await new Queries(() => world, left).castRays(ray)).toBeUndefined();
});
