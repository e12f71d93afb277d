import { create } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { PointForm, PointObjectSchema, PointUpdateSchema, SnapshotSchema } from '../gen/jostle/v1/play_pb.js';
import { goldenPoints } from '../testing/golden_points.js';
import { PointObjects } from './point_objects.js';

const golden = goldenPoints();

/** A snapshot with the description of a golden object and its updates from `first` to `last`. */
function snapshot(index: number, first: number, last: number, describe = true) {
  const { layout, updates } = golden[index]!;
  let before = 0;
  const triangles = layout.triangles.map((corner) => {
    const step = corner - before;
    before = corner;
    return step;
  });
  return create(SnapshotSchema, {
    pointObjects: describe
      ? [create(PointObjectSchema, { ...layout, strands: [...layout.strands], triangles, id: index + 1, form: layout.form as PointForm, stepUm: 1000, spacingX: 1, spacingZ: 1 })]
      : [],
    points: updates.slice(first, last).map((update) => create(PointUpdateSchema, { object: index + 1, number: update.number, back: update.back, tick: 3 * update.number, packed: update.packed, crc: update.crc })),
  });
}

describe('point objects', () => {
  it('are sampled between their states, in meters', () => {
    const objects = new PointObjects();
    objects.begin([3]);
    expect(objects.apply(snapshot(2, 0, 8))).toBe(true);
    const view = objects.objects.get(3)!;
    const { updates } = golden[2]!;
    // The interval is three ticks, so tick t shows t - 2; states 5 and 6 are of the ticks 15 and 18.
    view.sample(2 + 15, 60);
    expect(view.count).toBe(88);
    expect(view.positions[4]).toBeCloseTo(updates[6]!.values[4]! / 1000, 5);
    view.sample(2 + 16.5, 60);
    expect(view.positions[4]).toBeCloseTo((updates[6]!.values[4]! + updates[7]!.values[4]!) / 2000, 5);
  });

  it('of heights lie on a horizontal grid', () => {
    const objects = new PointObjects();
    objects.begin([]);
    expect(objects.apply(snapshot(4, 0, 3))).toBe(true);
    objects.sample(3, 60);
    const view = objects.objects.get(5)!;
    const { values } = golden[4]!.updates[2]!;
    expect([...view.positions.subarray(3 * 18, 3 * 19)]).toEqual([1, Math.fround(values[18]! * 1e-3), 1]);
  });

  it('show a new loose point from its first state on', () => {
    const objects = new PointObjects();
    objects.begin([3]);
    objects.apply(snapshot(0, 0, 5));
    const view = objects.objects.get(1)!;
    const { previous } = golden[0]!.updates[4]!;
    const born = previous.filter((index) => index < 0).length;
    view.sample(2 + 3 * 3 - 1, 60);
    expect(view.count).toBe(previous.length - born);
    view.sample(2 + 3 * 3, 60);
    expect(view.count).toBe(previous.length);
  });

  it('need a keyframe after a lost state and end when the server says so', () => {
    const objects = new PointObjects();
    objects.begin([1]);
    expect(objects.apply(snapshot(1, 0, 4))).toBe(true);
    expect(objects.apply(snapshot(1, 5, 6, false))).toBe(false);
    expect(objects.needsKeyframe).toBe(true);
    expect(objects.apply(snapshot(1, 11, 12, false))).toBe(true);
    expect(objects.needsKeyframe).toBe(false);
    expect(objects.apply(create(SnapshotSchema, { pointsEnded: [2] }))).toBe(true);
    expect(objects.objects.size).toBe(0);
  });

  it('are limited in number', () => {
    const objects = new PointObjects();
    objects.begin([]);
    const pointObjects = [1, 2, 3].map((id) => create(PointObjectSchema, { id, form: PointForm.GRID, stepUm: 1000, points: 65536, columns: 256 }));
    expect(objects.apply(create(SnapshotSchema, { pointObjects }))).toBe(false);
    expect(objects.objects.size).toBe(2);
  });
});
