// What the modules of the world tell, by tag, frame by frame (WIRE.md, "Chunks of modules").

import { DecodeError } from './decode_frame';
import type { ModuleChunk } from './gen/jostle/v1/play_pb';

/** By tag; never empty ones. Frames share those that did not change. */
export type Chunks = ReadonlyMap<string, Uint8Array>;

export const NO_CHUNKS: Chunks = new Map();
const CHUNKS_MAX = 64;

/** The chunks of a frame: those of its base, as a snapshot changes them. Foreign: throws DecodeError when they are too many. */
export function changeChunks(base: Chunks, changes: readonly Pick<ModuleChunk, 'tag' | 'data'>[]): Chunks {
  if (changes.length === 0) return base;
  const chunks = new Map(base);
  for (const { tag, data } of changes)
    if (data.length > 0) chunks.set(tag, data.slice()); // not a view that keeps the whole message
    else chunks.delete(tag);
  if (chunks.size > CHUNKS_MAX) throw new DecodeError(`more than ${CHUNKS_MAX} modules`);
  return chunks;
}
