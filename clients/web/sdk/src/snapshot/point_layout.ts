// Connections of the points of a point object, and the order in which the points are coded
// (proto/WIRE.md, "Points"), as proto/snapshot/src/point_layout.cpp.

import { DecodeError } from './frame_state.js';

export const POINTS_MAX = 65536; // per object
export const POINT_TRIANGLES_MAX = 131072; // per object
export const POINT_OBJECTS_MAX = 1024; // of a world
export const WORLD_POINTS_MAX = 128 * 1024; // of all objects of a world
export const POINT_LEVELS = 4;

export const enum PointForm {
  Loose = 1,
  Strands = 2,
  Grid = 3,
  Triangles = 4,
  Heights = 5,
}

/** Constant during the lifetime of an object. */
export interface PointLayout {
  readonly form: number;
  /** 0 for loose points. */
  readonly points: number;
  /** Of a grid or of heights. */
  readonly columns: number;
  /** Number of points of each strand. */
  readonly strands: readonly number[];
  /** Three points each. */
  readonly triangles: readonly number[];
}

/** Integers per point. */
export const componentsOf = (form: number): number => (form === PointForm.Heights ? 1 : 3);

/** Throws DecodeError if a layout is invalid. */
export function checkLayout({ form, points, columns, strands, triangles }: PointLayout): void {
  const fail = (what: string): never => {
    throw new DecodeError(`point object: ${what}`);
  };
  if (!(form >= PointForm.Loose && form <= PointForm.Heights)) fail(`unknown form ${form}`);
  if (points > POINTS_MAX) fail(`${points} points; must be at most ${POINTS_MAX}`);
  if ((form === PointForm.Loose) !== (points === 0)) fail(points === 0 ? 'no points' : 'loose points with a fixed number');
  const hasColumns = form === PointForm.Grid || form === PointForm.Heights;
  if (hasColumns && (columns === 0 || points % columns !== 0)) fail(`${columns} columns do not divide ${points} points`);
  if ((!hasColumns && columns !== 0) || (form !== PointForm.Strands && strands.length > 0) || (form !== PointForm.Triangles && triangles.length > 0))
    fail('fields of another form');
  if (form === PointForm.Strands) {
    if (strands.includes(0)) fail('empty strand');
    const sum = strands.reduce((total, size) => total + size, 0);
    if (sum !== points) fail(`strands have ${sum} points; the object has ${points}`);
  }
  if (triangles.length > 3 * POINT_TRIANGLES_MAX) fail(`${triangles.length / 3} triangles; must be at most ${POINT_TRIANGLES_MAX}`);
  if (triangles.length % 3 !== 0) fail('incomplete triangle');
  for (const corner of triangles) if (!(corner >= 0 && corner < points)) fail(`triangle corner ${corner} is not below the number of points, ${points}`);
}

export const SOURCES_MAX = 4;

/** The points of one level in coding order: flat lists, with SOURCES_MAX sources per point. */
export interface PointLevel {
  readonly points: readonly number[];
  readonly sources: readonly number[]; // number of sources of each point
  readonly from: readonly number[];
  readonly weights: readonly number[]; // in sixteenths
}

class LevelBuilder implements PointLevel {
  points: number[] = [];
  sources: number[] = [];
  from: number[] = [];
  weights: number[] = [];

  start(point: number): void {
    this.points.push(point);
    this.sources.push(0);
    for (let k = 0; k < SOURCES_MAX; k++) {
      this.from.push(0);
      this.weights.push(0);
    }
  }
  add(source: number, weight: number): void {
    const last = this.points.length - 1;
    const at = last * SOURCES_MAX + this.sources[last]!;
    this.from[at] = source;
    this.weights[at] = weight;
    this.sources[last]!++;
  }
}

const strideOf = (level: number) => 1 << (POINT_LEVELS - 1 - level);
const belongs = (at: number, size: number, stride: number) => at % stride === 0 || at === size - 1;

/** Adds the sources of position `at`, an odd multiple of `stride`, in a row of `size` points. */
function addNeighbours(level: LevelBuilder, at: number, size: number, stride: number, index: (at: number) => number): void {
  const last = size - 1;
  const before = at - stride;
  if (at + stride > last) {
    const right = Math.trunc((32 * stride + (last - before)) / (2 * (last - before)));
    level.add(index(before), 16 - right);
    level.add(index(last), right);
    return;
  }
  const cubic = at >= 3 * stride && at + 3 * stride <= last;
  level.add(index(before), cubic ? 9 : 8);
  level.add(index(at + stride), cubic ? 9 : 8);
  if (!cubic) return;
  level.add(index(at - 3 * stride), -1);
  level.add(index(at + 3 * stride), -1);
}

function addStrands({ strands }: PointLayout, k: number, level: LevelBuilder): void {
  const stride = strideOf(k);
  let first = 0;
  for (const size of strands) {
    const start = first;
    const index = (at: number) => start + at;
    let previous = first - 1; // the end of the previous strand
    for (let at = 0; at < size; at++) {
      if (!belongs(at, size, stride) || (k > 0 && belongs(at, size, 2 * stride))) continue;
      level.start(first + at);
      if (k > 0) addNeighbours(level, at, size, stride, index);
      else if (first + at !== 0) level.add(previous, 16);
      previous = first + at;
    }
    first += size;
  }
}

function addGrid({ points, columns }: PointLayout, k: number, level: LevelBuilder): void {
  const stride = strideOf(k);
  const rows = points / columns;
  const addRow = (row: number, isNewRow: boolean) => {
    for (let column = 0; column < columns; column++) {
      if (!belongs(column, columns, stride)) continue;
      if (k > 0 && !isNewRow && belongs(column, columns, 2 * stride)) continue;
      const point = row * columns + column;
      level.start(point);
      if (k === 0) {
        if (column > 0) level.add(point - (column % stride || stride), 16);
        else if (row > 0) level.add(point - (row % stride || stride) * columns, 16);
      } else if (isNewRow) addNeighbours(level, row, rows, stride, (at) => at * columns + column);
      else addNeighbours(level, column, columns, stride, (at) => row * columns + at);
    }
  };
  // First the new columns of the old rows, from which the new rows are predicted.
  const coarse = k === 0 ? stride : 2 * stride;
  for (let row = 0; row < rows; row++) if (belongs(row, rows, coarse)) addRow(row, false);
  for (let row = 0; k > 0 && row < rows; row++) if (belongs(row, rows, stride) && !belongs(row, rows, coarse)) addRow(row, true);
}

type Graph = readonly (readonly number[])[]; // neighbours of each vertex, ascending
const COARSE_NEIGHBOURS_MAX = 12;

function graphOf(vertices: number, edges: Iterable<readonly [number, number]>): Graph {
  const sets = Array.from({ length: vertices }, () => new Set<number>());
  for (const [a, b] of edges) if (a !== b) sets[a]!.add(b);
  return sets.map((set) => [...set].sort((a, b) => a - b));
}

function* trianglesEdges(triangles: readonly number[]): Generator<[number, number]> {
  for (let k = 0; k < triangles.length; k += 3)
    for (let side = 0; side < 3; side++) {
      const [a, b] = [triangles[k + side]!, triangles[k + ((side + 1) % 3)]!];
      yield [a, b];
      yield [b, a];
    }
}

function* coarseEdges(graph: Graph, dropped: readonly number[], kept: readonly boolean[]): Generator<[number, number]> {
  for (const vertex of dropped) {
    const near = graph[vertex]!.filter((n) => kept[n]).slice(0, COARSE_NEIGHBOURS_MAX);
    for (const a of near) for (const b of near) yield [a, b];
  }
}

function addTriangles({ points, triangles }: PointLayout, levels: LevelBuilder[]): void {
  let graph = graphOf(points, trianglesEdges(triangles));
  let vertices = Array.from({ length: points }, (_, k) => k);
  for (let k = POINT_LEVELS - 1; k > 0; k--) {
    // A maximal independent set is kept; every other vertex has a neighbour in it.
    const kept: boolean[] = new Array(points).fill(false);
    const keptList: number[] = [];
    const dropped: number[] = [];
    for (const vertex of vertices) {
      const covered = graph[vertex]!.some((n) => kept[n]);
      (covered ? dropped : keptList).push(vertex);
      if (!covered) kept[vertex] = true;
    }
    for (const vertex of dropped) {
      const level = levels[k]!;
      level.start(vertex);
      const near = graph[vertex]!.filter((n) => kept[n]).slice(0, SOURCES_MAX);
      near.forEach((n, i) => level.add(n, Math.trunc(16 / near.length) + (i === 0 ? 16 % near.length : 0)));
    }
    graph = graphOf(points, coarseEdges(graph, dropped, kept));
    vertices = keptList;
  }
  const coded: boolean[] = new Array(points).fill(false);
  let previous = -1;
  for (const vertex of vertices) {
    levels[0]!.start(vertex);
    const source = graph[vertex]!.find((n) => coded[n]) ?? previous;
    if (source >= 0) levels[0]!.add(source, 16);
    coded[vertex] = true;
    previous = vertex;
  }
}

/** The levels of a layout; empty for loose points. checkLayout() must accept the layout. */
export function pointOrder(layout: PointLayout): readonly PointLevel[] {
  const levels = Array.from({ length: POINT_LEVELS }, () => new LevelBuilder());
  if (layout.form === PointForm.Triangles) addTriangles(layout, levels);
  levels.forEach((level, k) => {
    if (layout.form === PointForm.Strands) addStrands(layout, k, level);
    if (layout.columns !== 0) addGrid(layout, k, level);
  });
  return levels;
}
