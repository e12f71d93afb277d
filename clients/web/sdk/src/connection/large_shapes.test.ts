import { create, toBinary } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { EntitySchema, GeometryChunkSchema } from '../gen/jostle/v1/play_pb.js';
import { ShapeSchema } from '../gen/jostle/v1/scene_pb.js';
import { LargeShapes } from './large_shapes.js';

const vertices = Array.from({ length: 100 }, (_, i) => ({ x: i, y: 0, z: 0 }));
const mesh = create(ShapeSchema, { kind: { case: 'mesh', value: { vertices, indices: [0, 1, 2] } } });
const bytes = toBinary(ShapeSchema, mesh);
const chunkOf = (chunk: number, chunkCount: number, data: Uint8Array, id = 7n) =>
  create(GeometryChunkSchema, { id, chunk, chunkCount, data });
const entityWith = (id: bigint) => create(EntitySchema, { id: 1, shapes: [{ kind: { case: 'geometry', value: id } }] });

describe('large shapes', () => {
  it('are assembled from parts and shared by the bodies that reference them', () => {
    const shapes = new LargeShapes();
    expect(shapes.add(chunkOf(0, 2, bytes.subarray(0, 500)))).toBe(true);
    expect(shapes.add(chunkOf(1, 2, bytes.subarray(500)))).toBe(true);
    const [one, two] = [entityWith(7n), entityWith(7n)];
    shapes.resolve(one);
    shapes.resolve(two);
    const kind = one.shapes[0]!.kind;
    expect(kind.case === 'mesh' && kind.value.vertices.length).toBe(100);
    expect(two.shapes[0]!.kind).toBe(kind);
  });

  it('reject out-of-order parts and malformed bytes, and render nothing for an unknown id', () => {
    const shapes = new LargeShapes();
    expect(shapes.add(chunkOf(1, 2, bytes))).toBe(false);
    expect(shapes.add(chunkOf(0, 2, bytes.subarray(0, 500)))).toBe(true);
    expect(shapes.add(chunkOf(1, 2, bytes.subarray(500), 8n))).toBe(false);
    expect(shapes.add(chunkOf(0, 1, new Uint8Array([255, 255])))).toBe(false);
    const entity = entityWith(7n);
    shapes.resolve(entity);
    expect(entity.shapes[0]!.kind.case).toBeUndefined();
  });
});
