// Large shapes: the server sends them once, in chunks, and refers to them by id. Bodies with the same
// id share one object.

import { fromBinary } from '@bufbuild/protobuf';
import type { Entity, GeometryChunk } from '../gen/jostle/v1/play_pb.js';
import { ShapeSchema, type Shape } from '../gen/jostle/v1/scene_pb.js';

const SHAPE_BYTES_MAX = 256 * 2 ** 20; // per shape

export class LargeShapes {
  private readonly shapes = new Map<bigint, Shape['kind']>();
  private partial: { id: bigint; bytes: number; chunks: Uint8Array[] } | undefined;

  clear(): void {
    this.shapes.clear();
    this.partial = undefined;
  }

  /** Returns false if the chunk is out of order or the assembled shape is malformed. */
  add({ id, chunk, chunkCount, data }: GeometryChunk): boolean {
    if (chunk === 0) this.partial = { id, bytes: 0, chunks: [] };
    const partial = this.partial;
    this.partial = undefined; // restored below if the chunk is valid
    if (!partial || partial.id !== id || partial.chunks.length !== chunk || chunk >= chunkCount) return false;
    partial.bytes += data.length;
    if (partial.bytes > SHAPE_BYTES_MAX) return false;
    partial.chunks.push(data);
    if (chunk + 1 < chunkCount) {
      this.partial = partial;
      return true;
    }
    try {
      this.shapes.set(id, fromBinary(ShapeSchema, concatenate(partial.chunks, partial.bytes)).kind);
    } catch {
      return false;
    }
    return true;
  }

  /**
   * Replaces geometry ids by their shapes. An unknown id becomes a shape without a kind, which is not
   * rendered.
   */
  resolve(entity: Entity): void {
    for (const shape of entity.shapes)
      if (shape.kind.case === 'geometry') shape.kind = this.shapes.get(shape.kind.value) ?? { case: undefined };
  }
}

function concatenate(chunks: readonly Uint8Array[], bytes: number): Uint8Array {
  const all = new Uint8Array(bytes);
  let at = 0;
  for (const part of chunks) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
