// Queries about the joined world: POST /api/query/<Method> in protobuf's JSON form. Without a response,
// the result is undefined, and callers use their local data.

import { create, fromJsonString, toJsonString, type DescMessage, type MessageInitShape, type MessageShape } from '@bufbuild/protobuf';
import {
  CastRaysRequestSchema,
  CastRaysResponseSchema,
  DebugRequestSchema,
  DebugResponseSchema,
  InspectRequestSchema,
  InspectResponseSchema,
  type CastRaysResponse,
  type DebugResponse,
  type InspectResponse,
} from '../gen/jostle/v1/query_pb.js';

const QUERY_TIMEOUT_MS = 10_000; // a page without a graphics processor may be busy for seconds
const NOT_SERVED = [404, 501];
const TOO_MANY = 429;

/** The time to retry in an error response, ms. */
function retryAfterMs(text: string): number {
  const { retryAfterMs } = JSON.parse(text) as { retryAfterMs?: unknown };
  return typeof retryAfterMs === 'number' ? retryAfterMs : 0;
}

/** Whether Inspect is served, but its entity or joint does not exist. */
function isMissingTarget(method: string, text: string): boolean {
  return method === 'Inspect' && text.startsWith('{') && (JSON.parse(text) as { code?: unknown }).code === 'NOT_FOUND';
}

export type Post = (path: string, body: string, signal: AbortSignal) => Promise<{ status: number; text(): Promise<string> }>;

/** HTTP headers with the bearer token of a user; an empty token adds no header. */
export function withToken(token: string, headers: Record<string, string> = {}): Record<string, string> {
  return token === '' ? headers : { ...headers, Authorization: `Bearer ${token}` };
}

/** Posts with a bearer token; an empty token sends none. */
export const postToServer =
  (token: string): Post =>
  (path, body, signal) =>
    fetch(path, { method: 'POST', headers: withToken(token, { 'Content-Type': 'application/json' }), body, signal });

export class Queries {
  // A server may be older than this client. A method that it does not serve is not requested again in
  // the same world. It is requested in the next world, because 404 also means that the world is gone.
  private readonly notServed = new Set<string>();
  private notBeforeMs = 0; // performance.now() before which the server refuses queries

  constructor(
    private readonly world: () => string,
    private readonly post: Post = postToServer(''),
  ) {}

  castRays(request: MessageInitShape<typeof CastRaysRequestSchema>): Promise<CastRaysResponse | undefined> {
    return this.call('CastRays', CastRaysRequestSchema, request, CastRaysResponseSchema);
  }

  debug(request: MessageInitShape<typeof DebugRequestSchema>): Promise<DebugResponse | undefined> {
    return this.call('Debug', DebugRequestSchema, request, DebugResponseSchema);
  }

  /** The state of an entity or joint between two ticks. Undefined also if it does not exist. */
  inspect(target: { readonly entity: number } | { readonly joint: number }): Promise<InspectResponse | undefined> {
    const [kind, value] = 'entity' in target ? (['entity', target.entity] as const) : (['joint', target.joint] as const);
    return this.call('Inspect', InspectRequestSchema, { target: { case: kind, value } }, InspectResponseSchema);
  }

  private async call<Request extends DescMessage, Response extends DescMessage>(
    method: string,
    requestSchema: Request,
    request: MessageInitShape<Request>,
    responseSchema: Response,
  ): Promise<MessageShape<Response> | undefined> {
    const world = this.world();
    const key = `${method} in ${world}`;
    if (world === '' || this.notServed.has(key) || performance.now() < this.notBeforeMs) return undefined;
    try {
      const message = create(requestSchema, { ...request, world } as MessageInitShape<Request>);
      const response = await this.post(`api/query/${method}`, toJsonString(requestSchema, message), AbortSignal.timeout(QUERY_TIMEOUT_MS));
      const text = await response.text();
      if (NOT_SERVED.includes(response.status) && !isMissingTarget(method, text)) this.notServed.add(key);
      if (response.status === TOO_MANY) this.notBeforeMs = performance.now() + retryAfterMs(text);
      if (response.status !== 200) return undefined;
      // The client may have left the world meanwhile.
      return this.world() === world ? fromJsonString(responseSchema, text, { ignoreUnknownFields: true }) : undefined;
    } catch {
      return undefined; // no connection, a timeout or malformed JSON
    }
  }
}
