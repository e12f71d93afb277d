import { describe, expect, it } from 'vitest';
import { goldenPoints } from '../testing/golden_points.js';
import { DecodeError } from './decode_frame.js';
import { POINT_STATES_MAX, PointHistory } from './point_history.js';
import { POINT_LEVELS, pointOrder, type PointLayout } from './point_layout.js';

const NO_POINTS: PointLayout = { form: 1, points: 0, columns: 0, strands: [], triangles: [] };

describe('point objects', () => {
  it('in the golden file decode to the coordinates encoded by C++', () => {
    const objects = goldenPoints();
    expect(objects.map(({ layout }) => layout.form)).toEqual([1, 2, 3, 4, 5]);
    for (const { layout, updates } of objects) {
      const history = new PointHistory(layout);
      for (const update of updates) {
        history.add({ ...update, tick: 7 });
        const { points } = history.states.at(-1)!;
        expect(points.values).toEqual(update.values);
        expect(points.levels).toBe(update.levels);
      }
    }
  });

  it('keep eight states at most', () => {
    const { layout, updates } = goldenPoints()[1]!;
    const history = new PointHistory(layout);
    for (const update of updates.slice(0, 11)) history.add({ ...update, tick: update.number });
    expect(history.states.length).toBe(POINT_STATES_MAX);
    expect(history.states.at(-1)!.tick).toBe(updates[10]!.number);
  });

  it('are rejected when bits are flipped or bytes are missing', () => {
    for (const { layout, updates } of goldenPoints()) {
      const update = updates[0]!;
      const add = (packed: Uint8Array) => {
        const history = new PointHistory(layout);
        history.add({ ...update, tick: 1, packed });
        return history.states[0]!.points.values;
      };
      for (let bit = 0; bit < update.packed.length * 8; bit++) {
        const damaged = update.packed.slice();
        damaged[bit >> 3]! ^= 1 << (bit & 7);
        try {
          expect(add(damaged)).toEqual(update.values); // the last bits may be redundant
        } catch (error) {
          expect(error).toBeInstanceOf(DecodeError);
        }
      }
      for (let size = 0; size + 5 < update.packed.length; size++) expect(() => add(update.packed.subarray(0, size))).toThrow(DecodeError);
    }
  });

  it('are rejected if their baseline is unknown', () => {
    const { layout, updates } = goldenPoints()[2]!;
    const history = new PointHistory(layout);
    expect(() => history.add({ ...updates[4]!, tick: 1 })).toThrow('the newest known one is 0');
  });
});

describe('point layouts', () => {
  it('that no object has are rejected', () => {
    const reject = (layout: Partial<PointLayout>, reason: string) => expect(() => new PointHistory({ ...NO_POINTS, ...layout })).toThrow(reason);
    reject({ form: 9 }, 'unknown form 9');
    reject({ form: 3 }, 'no points');
    reject({ form: 3, points: 160000, columns: 400 }, '160000 points');
    reject({ form: 3, points: 20, columns: 7 }, '7 columns do not divide 20 points');
    reject({ form: 2, points: 9, strands: [4, 4] }, 'strands have 8 points');
    reject({ form: 2, points: 4, strands: [4, 0] }, 'empty strand');
    reject({ form: 4, points: 4, triangles: [0, 1, 4] }, 'corner 4');
    reject({ form: 4, points: 4, triangles: [0, 1] }, 'incomplete triangle');
    reject({ points: 3 }, 'loose points with a fixed number');
    reject({ columns: 3 }, 'fields of another form');
  });

  it('code every point once', () => {
    const strands = [1, 2, 3, 8, 9, 10, 64, 65];
    const points = strands.reduce((a, b) => a + b);
    const order = pointOrder({ ...NO_POINTS, form: 2, points, strands });
    expect(order.length).toBe(POINT_LEVELS);
    expect(order.flatMap((level) => level.points).sort((a, b) => a - b)).toEqual(Array.from({ length: points }, (_, k) => k));
  });
});
