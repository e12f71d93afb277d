// Questions to the server about the world one is in: POST /api/query/<Method>, in protobuf's JSON form. No answer is an answer,
// too: it is undefined, and who asked goes on with what it has.

import { create, fromJsonString, toJsonString, type DescMessage, type MessageInitShape, type MessageShape } from '@bufbuild/protobuf';
import {
  CastRaysRequestSchema,
  CastRaysResponseSchema,
  DebugRequestSchema,
  DebugResponseSchema,
  type CastRaysResponse,
  type DebugResponse,
} from '../gen/jostle/v1/query_pb.js';
import { withToken } from './bearer_token.js';

const QUERY_TIMEOUT_MS = 10_000; // a page that draws without a graphics processor may take seconds to look at an answer
const NOT_SERVED = [404, 501];

export type Post = (path: string, body: string, signal: AbortSignal) => Promise<{ status: number; text(): Promise<string> }>;

/** For somebody with that token; empty: for anybody. */
export const postToServer =
  (token: string): Post =>
  (path, body, signal) =>
    fetch(path, { method: 'POST', headers: withToken(token, { 'Content-Type': 'application/json' }), body, signal });

export class Queries {
  // Servers may be older than this page. One that does not know a method is not asked for it again in the same world; in the
  // next world it is, because 404 is also what a world that is gone answers.
  private readonly notServed = new Set<string>();

  constructor(
    private readonly world: () => string,
    private readonly post: Post = postToServer(''),
  ) {}

  castRays(request: MessageInitShape<typeof CastRaysRequestSchema>): Promise<CastRaysResponse | undefined> {
    return this.ask('CastRays', CastRaysRequestSchema, request, CastRaysResponseSchema);
  }

  debug(request: MessageInitShape<typeof DebugRequestSchema>): Promise<DebugResponse | undefined> {
    return this.ask('Debug', DebugRequestSchema, request, DebugResponseSchema);
  }

  private async ask<Request extends DescMessage, Response extends DescMessage>(
    method: string,
    requestSchema: Request,
    request: MessageInitShape<Request>,
    responseSchema: Response,
  ): Promise<MessageShape<Response> | undefined> {
    const world = this.world();
    const here = `${method} in ${world}`;
    if (world === '' || this.notServed.has(here)) return undefined;
    try {
      const message = create(requestSchema, { ...request, world } as MessageInitShape<Request>);
      const response = await this.post(`api/query/${method}`, toJsonString(requestSchema, message), AbortSignal.timeout(QUERY_TIMEOUT_MS));
      if (NOT_SERVED.includes(response.status)) this.notServed.add(here);
      if (response.status !== 200) return undefined;
      const text = await response.text();
      // The world may have been left in the meantime.
      return this.world() === world ? fromJsonString(responseSchema, text, { ignoreUnknownFields: true }) : undefined;
    } catch {
      return undefined; // nobody there, too slow, or no JSON of ours
    }
  }
}
