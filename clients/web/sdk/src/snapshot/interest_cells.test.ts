import { describe, expect, it } from 'vitest';
import { DecodeError, frameCrc, type EntityState } from './decode_frame.js';
import { FrameBuffer } from '../interpolation/frame_buffer.js';
import { InterestCells, type CellUpdate } from './interest_cells.js';

const SPEC = { unitsPerMeter: 512, rotationComponent: 511 };

// A cell without entities, with or without baselines; its CRC is 0.
const empty = (cell: number, number: number, baselines = 0): CellUpdate => ({
  cell,
  number,
  baselines,
  packed: new Uint8Array(2),
  crc: 0,
});

describe('interest cells', () => {
  it('are empty at first and known until removed', () => {
    const cells = new InterestCells();
    cells.apply([empty(7, 10), empty(8, 10)], [], SPEC, 1);
    expect(cells.frame(10)).toEqual({ frame: 10, entities: [] });
    cells.apply([empty(7, 12, 2 | (255 << 8))], [8], SPEC, 1);
    expect(() => cells.apply([empty(8, 13, 3 | (255 << 8))], [], SPEC, 1)).toThrow(/cell 8 of tick 13: its state 10/);
  });

  it('that are corrupt change nothing', () => {
    const cells = new InterestCells();
    cells.apply([empty(7, 10)], [], SPEC, 1);
    expect(() => cells.apply([empty(9, 11), { ...empty(7, 11), crc: 5 }], [], SPEC, 1)).toThrow(DecodeError);
    expect(() => cells.apply([empty(9, 12, 1 | (255 << 8))], [], SPEC, 1)).toThrow(/is unknown/);
    expect(() => cells.apply([empty(7, 10, 1 | (255 << 8))], [], SPEC, 1)).toThrow(/not newer/);
    cells.apply([empty(7, 10)], [], SPEC, 1); // without baselines: restarts the history
  });

  it('use the newer state of an entity in two cells', () => {
    const cells = new InterestCells();
    const at = (id: number, x: number): EntityState => ({
      id,
      position: [x, 0, 0],
      largest: 3,
      rotation: [0, 0, 0],
      atRest: false,
    });
    // Inserted as if they had been decoded.
    const states = (cells as unknown as { cells: Map<number, { frame: number; entities: EntityState[] }[]> }).cells;
    states.set(1, [{ frame: 20, entities: [at(3, 100), at(4, 1)] }]);
    states.set(2, [{ frame: 24, entities: [at(2, 7), at(3, 104)] }]);
    expect(cells.frame(25).entities.map((e) => [e.id, e.position[0]])).toEqual([
      [2, 7],
      [3, 104],
      [4, 1],
    ]);
    expect(frameCrc(cells.frame(25))).toBeGreaterThan(0);
  });

  // Same case as in tests/clients/cpp/core/interest_cells_test.cpp: 12 m/s, updated with every fourth
  // snapshot.
  it('with a lower update rate are interpolated', () => {
    const cells = new InterestCells();
    const states = (cells as unknown as { cells: Map<number, { frame: number; entities: EntityState[] }[]> }).cells;
    const frames = new FrameBuffer();
    const at = (id: number, x: number): EntityState => ({ id, position: [Math.round(512 * x), 0, 0], largest: 3, rotation: [0, 0, 0], atRest: false });
    const far: { frame: number; entities: EntityState[] }[] = [];
    const steps: number[] = [];
    let last = 0;
    for (let tick = 1; tick <= 100; tick++) {
      if (tick % 4 === 1) far.push({ frame: tick, entities: [at(2, 0.2 * tick)] });
      states.set(8, far);
      cells.apply([], [], SPEC, 1, tick);
      const { poses } = frames.add(cells.frame(tick), tick * 16_667, SPEC, [], cells.blends(tick), 16_667);
      if (tick > 20) steps.push(poses[0]! - last);
      last = poses[0]!;
    }
    expect(Math.max(...steps)).toBeLessThan(0.204);
    expect(Math.min(...steps)).toBeGreaterThan(0.196);
    expect(last, 'three ticks later').toBeCloseTo(0.2 * 97, 2);
  });
});
