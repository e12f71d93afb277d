// Shapes that the server tells once, in parts, and names by their id afterwards. All bodies that have one share one object.

import { fromBinary } from '@bufbuild/protobuf';
import type { Entity, GeometryChunk } from '../gen/jostle/v1/play_pb.js';
import { ShapeSchema, type Shape } from '../gen/jostle/v1/scene_pb.js';

const MOST_BYTES = 256 * 2 ** 20; // of one shape

export class LargeShapes {
  private readonly known = new Map<bigint, Shape['kind']>();
  private unfinished: { id: bigint; bytes: number; pieces: Uint8Array[] } | undefined;

  clear(): void {
    this.known.clear();
    this.unfinished = undefined;
  }

  /** False: the part does not follow the one before, or the whole is no shape. */
  add({ id, chunk, chunkCount, data }: GeometryChunk): boolean {
    if (chunk === 0) this.unfinished = { id, bytes: 0, pieces: [] };
    const whole = this.unfinished;
    this.unfinished = undefined; // until this part turns out to be good
    if (!whole || whole.id !== id || whole.pieces.length !== chunk || chunk >= chunkCount) return false;
    whole.bytes += data.length;
    if (whole.bytes > MOST_BYTES) return false;
    whole.pieces.push(data);
    if (chunk + 1 < chunkCount) {
      this.unfinished = whole;
      return true;
    }
    try {
      this.known.set(id, fromBinary(ShapeSchema, joined(whole.pieces, whole.bytes)).kind);
    } catch {
      return false;
    }
    return true;
  }

  /** Puts what they name in the place of names. A name that was never told leaves a shape that is not drawn. */
  fillIn(entity: Entity): void {
    for (const shape of entity.shapes)
      if (shape.kind.case === 'geometry') shape.kind = this.known.get(shape.kind.value) ?? { case: undefined };
  }
}

function joined(pieces: readonly Uint8Array[], bytes: number): Uint8Array {
  const all = new Uint8Array(bytes);
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}
