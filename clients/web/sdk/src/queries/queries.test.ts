import { expect, it, vi } from 'vitest';
import { Queries, withToken, type Post } from './queries.js';

const ray = { rays: [{ origin: { x: 0, y: 5, z: 0 }, motion: { x: 0, y: -10, z: 0 } }] };

function server(...responses: (readonly [number, string])[]) {
  const requests: [string, string][] = [];
  const post: Post = async (path, body) => {
    requests.push([path, body]);
    const [status, text] = responses[Math.min(requests.length, responses.length) - 1]!;
    return { status, text: async () => text };
  };
  return { requests, post };
}

it('sends the world id and parses the JSON response', async () => {
  const { requests, post } = server([200, '{"tick":7,"rays":[{"hits":[{"entity":3,"fraction":0.4,"point":{"y":1},"newer":1}]}]}']);
  const response = await new Queries(() => 'w1', post).castRays(ray);
  expect(requests).toEqual([
    ['api/query/CastRays', '{"world":"w1","rays":[{"origin":{"y":5},"motion":{"y":-10}}]}'],
  ]);
  expect(response!.tick).toBe(7);
  expect(response!.rays[0]!.hits[0]).toMatchObject({ entity: 3, fraction: 0.4, shape: 0, point: { x: 0, y: 1 } });
});

it('does not repeat unsupported queries until the world changes', async () => {
  const { requests, post } = server([404, 'There is no such path']);
  let world = 'w1';
  const queries = new Queries(() => world, post);
  for (let i = 0; i < 5; i++) expect(await queries.castRays(ray)).toBeUndefined();
  expect(requests.length).toBe(1);
  world = 'w2';
  await queries.castRays(ray);
  expect(requests.length).toBe(2);
});

it('inspects again after a body that does not exist', async () => {
  const { requests, post } = server([404, '{"code":"NOT_FOUND","message":"entity 9 does not exist"}'], [200, '{"tick":3,"body":{"entity":4,"mass":2}}'], [404, 'There is no such path']);
  const queries = new Queries(() => 'w1', post);
  expect(await queries.inspect({ entity: 9 })).toBeUndefined();
  expect((await queries.inspect({ entity: 4 }))!.body!.mass).toBe(2);
  expect(requests[0]).toEqual(['api/query/Inspect', '{"world":"w1","entity":9}']);
  for (let k = 0; k < 3; k++) expect(await queries.inspect({ joint: 1 })).toBeUndefined();
  expect(requests.length).toBe(3);
});

it('retries after a busy server', async () => {
  const { requests, post } = server([503, 'busy'], [200, '{"tick":1}']);
  const queries = new Queries(() => 'w1', post);
  expect(await queries.debug({ contacts: true })).toBeUndefined();
  expect((await queries.debug({ contacts: true }))!.tick).toBe(1);
  expect(requests.length).toBe(2);
});

it('sends no queries until a server that refused one accepts them again', async () => {
  vi.useFakeTimers();
  const { requests, post } = server([429, '{"code":"RESOURCE_EXHAUSTED","retryAfterMs":1500}'], [200, '{"tick":1}']);
  const queries = new Queries(() => 'w1', post);
  expect(await queries.castRays(ray)).toBeUndefined();
  vi.advanceTimersByTime(1400);
  expect(await queries.castRays(ray)).toBeUndefined();
  expect(requests.length).toBe(1);
  vi.advanceTimersByTime(200);
  expect((await queries.castRays(ray))!.tick).toBe(1);
  vi.useRealTimers();
});

it('treats malformed responses, failed requests and left worlds as no response', async () => {
  expect(await new Queries(() => 'w1', server([200, '<html>']).post).castRays(ray)).toBeUndefined();
  expect(await new Queries(() => 'w1', () => Promise.reject(new Error('offline'))).castRays(ray)).toBeUndefined();
  expect(await new Queries(() => '', server([200, '{}']).post).castRays(ray)).toBeUndefined();
  let world = 'w1';
  const leaving: Post = async () => {
    world = 'w2';
    return { status: 200, text: async () => '{"tick":1}' };
  };
  expect(await new Queries(() => world, leaving).castRays(ray)).toBeUndefined();
});

it('adds the token as a header, and no header without a token', () => {
  expect(withToken('a.b.c', { Accept: 'x' })).toEqual({ Accept: 'x', Authorization: 'Bearer a.b.c' });
  expect(withToken('')).toEqual({});
});

it('inspects an entity or a joint, and continues after one that does not exist', async () => {
  const { requests, post } = server(
    [404, '{"code":"NOT_FOUND","message":"entity 9 does not exist"}'],
    [200, '{"tick":5,"joint":{"id":3,"force":12.5,"joint":{"hinge":{}}}}'],
  );
  const queries = new Queries(() => 'w1', post);
  expect(await queries.inspect({ entity: 9 })).toBeUndefined();
  const response = await queries.inspect({ joint: 3 });
  expect(requests).toEqual([
    ['api/query/Inspect', '{"world":"w1","entity":9}'],
    ['api/query/Inspect', '{"world":"w1","joint":3}'],
  ]);
  expect(response!.joint).toMatchObject({ id: 3, force: 12.5, joint: { kind: { case: 'hinge' } } });
});
