// Smooth curves and surfaces for rendering point objects, as jostle/client/subdivision.h of the C++
// client library. Positions are flat lists: x y z of each point. Pure functions.

type Positions = ArrayLike<number>;

/** Catmull-Rom spline of one row: `offset`, `stride` and `size` in points. */
function spline(points: Positions, offset: number, stride: number, size: number, parts: number, to: Float32Array, toOffset: number, toStride: number): void {
  const last = size - 1;
  const point = (k: number, c: number) => points[3 * (offset + k * stride) + c]!;
  // Beyond the ends the row continues straight.
  const at = (k: number, c: number) => {
    if (k < 0) return 2 * point(0, c) - point(Math.min(1, last), c);
    if (k > last) return 2 * point(last, c) - point(Math.max(0, last - 1), c);
    return point(k, c);
  };
  let out = toOffset;
  for (let k = 0; k < last; k++)
    for (let part = 0; part < parts; part++, out += toStride) {
      const t = part / parts;
      const [t2, t3] = [t * t, t * t * t];
      for (let c = 0; c < 3; c++)
        to[3 * out + c] =
          0.5 * ((-t3 + 2 * t2 - t) * at(k - 1, c) + (3 * t3 - 5 * t2 + 2) * at(k, c) + (-3 * t3 + 4 * t2 + t) * at(k + 1, c) + (t3 - t2) * at(k + 2, c));
    }
  for (let c = 0; c < 3; c++) to[3 * out + c] = point(last, c);
}

const refined = (size: number, parts: number) => (size - 1) * parts + 1;

/**
 * The Catmull-Rom spline through `count` points from the point `first`, with `parts` pieces between two
 * points.
 */
export function subdivideStrand(points: Positions, parts: number, first = 0, count = points.length / 3): Float32Array {
  if (count === 0) return new Float32Array(0);
  const made = new Float32Array(3 * refined(count, parts));
  spline(points, first, 1, count, parts, made, 0, 1);
  return made;
}

/** The bicubic Catmull-Rom surface through a grid; it has (columns - 1) * parts + 1 columns. */
export function subdivideGrid(points: Positions, columns: number, rows: number, parts: number): Float32Array {
  if (columns === 0 || rows === 0) return new Float32Array(0);
  const wideColumns = refined(columns, parts);
  const wide = new Float32Array(3 * wideColumns * rows);
  for (let row = 0; row < rows; row++) spline(points, row * columns, 1, columns, parts, wide, row * wideColumns, 1);
  const made = new Float32Array(3 * wideColumns * refined(rows, parts));
  for (let column = 0; column < wideColumns; column++) spline(wide, column, wideColumns, rows, parts, made, column, wideColumns);
  return made;
}

export interface TriangleMesh {
  readonly positions: Positions;
  readonly triangles: readonly number[];
}

interface MeshEdge {
  readonly ends: readonly [number, number];
  readonly opposite: number[]; // sum
  triangles: number;
  middle: number;
}

/**
 * One step of Loop's subdivision (C. Loop, "Smooth subdivision surfaces based on triangles", 1987) with
 * the weights of Warren for inner points. Edges of one triangle are borders. Triangles with a point
 * beyond the list are dropped.
 */
export function subdivideMesh({ positions, triangles }: TriangleMesh): { positions: Float32Array; triangles: number[] } {
  const count = Math.floor(positions.length / 3);
  const edges = new Map<number, MeshEdge>();
  const key = (a: number, b: number) => Math.min(a, b) * count + Math.max(a, b);
  const kept: number[] = [];
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const t = triangles.slice(k, k + 3);
    if (Math.max(...t) >= count) continue;
    kept.push(...t);
    for (let side = 0; side < 3; side++) {
      const [a, b, c] = [t[side]!, t[(side + 1) % 3]!, t[(side + 2) % 3]!];
      let edge = edges.get(key(a, b));
      if (!edge) edges.set(key(a, b), (edge = { ends: [Math.min(a, b), Math.max(a, b)], opposite: [0, 0, 0], triangles: 0, middle: 0 }));
      edge.triangles++;
      for (let i = 0; i < 3; i++) edge.opposite[i]! += positions[3 * c + i]!;
    }
  }
  const made = new Float32Array(3 * (count + edges.size));
  const sums = new Float64Array(3 * count);
  const borderSums = new Float64Array(3 * count);
  const neighbours = new Uint32Array(count);
  const borders = new Uint32Array(count);
  let next = count;
  for (const edge of [...edges.values()].sort((a, b) => a.ends[0] - b.ends[0] || a.ends[1] - b.ends[1])) {
    const inner = edge.triangles === 2;
    const [a, b] = edge.ends;
    edge.middle = next++;
    for (let i = 0; i < 3; i++)
      made[3 * edge.middle + i] = (inner ? 0.375 : 0.5) * (positions[3 * a + i]! + positions[3 * b + i]!) + (inner ? 0.125 * edge.opposite[i]! : 0);
    for (const [point, other] of [
      [a, b],
      [b, a],
    ] as const) {
      neighbours[point]!++;
      if (!inner) borders[point]!++;
      for (let i = 0; i < 3; i++) {
        sums[3 * point + i]! += positions[3 * other + i]!;
        if (!inner) borderSums[3 * point + i]! += positions[3 * other + i]!;
      }
    }
  }
  for (let k = 0; k < count; k++) {
    const n = neighbours[k]!;
    const beta = n === 3 ? 3 / 16 : 3 / (8 * n);
    for (let i = 3 * k; i < 3 * k + 3; i++) {
      if (borders[k] === 2) made[i] = 0.75 * positions[i]! + 0.125 * borderSums[i]!;
      else if (borders[k] !== 0 || n === 0) made[i] = positions[i]!;
      else made[i] = (1 - n * beta) * positions[i]! + beta * sums[i]!;
    }
  }
  const out: number[] = [];
  for (let k = 0; k < kept.length; k += 3) {
    const [a, b, c] = [kept[k]!, kept[k + 1]!, kept[k + 2]!];
    const [ab, bc, ca] = [edges.get(key(a, b))!.middle, edges.get(key(b, c))!.middle, edges.get(key(c, a))!.middle];
    out.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
  }
  return { positions: made, triangles: out };
}
