// A scene with every kind of shape on a hilly height field with a hole.

const vec = (x, y, z) => ({ x, y, z });
const COLUMNS = 41;
const ROWS = 41;
const SPACING = 0.5; // m

function hills() {
  const heights = [];
  for (let row = 0; row < ROWS; row++)
    for (let column = 0; column < COLUMNS; column++) {
      const x = (column - (COLUMNS - 1) / 2) * SPACING;
      const z = (row - (ROWS - 1) / 2) * SPACING;
      heights.push(0.5 * Math.sin(x / 2) * Math.cos(z / 2.5) + 0.015 * (x * x + z * z) - 0.6);
    }
  const holes = [];
  for (let row = 30; row < 34; row++) for (let column = 24; column < 28; column++) holes.push(row * (COLUMNS - 1) + column);
  return { columns: COLUMNS, rows: ROWS, spacingX: SPACING, spacingZ: SPACING, heights, holes };
}

// A gem: two rings and a tip.
const gem = [0, 1, 2, 3, 4, 5]
  .flatMap((k) => {
    const [c, s] = [Math.cos((k * Math.PI) / 3), Math.sin((k * Math.PI) / 3)];
    return [vec(0.5 * c, 0.1, 0.5 * s), vec(0.32 * c, 0.32, 0.32 * s)];
  })
  .concat([vec(0, -0.5, 0)]);

// A spiral stair: a mesh with creases and seams.
function stair() {
  const vertices = [];
  const indices = [];
  for (let k = 0; k < 10; k++) {
    const [a, b] = [k * 0.45, (k + 1) * 0.45];
    const y = 0.25 * (k + 1);
    const at = vertices.length;
    for (const height of [y, y - 0.25])
      for (const [angle, radius] of [
        [a, 1],
        [a, 2.6],
        [b, 2.6],
        [b, 1],
      ])
        vertices.push(vec(radius * Math.cos(angle), height, radius * Math.sin(angle)));
    const quad = (p, q, r, s) => indices.push(at + p, at + q, at + r, at + p, at + r, at + s);
    quad(0, 3, 2, 1);
    quad(4, 5, 6, 7);
    quad(0, 1, 5, 4);
    quad(2, 3, 7, 6);
    quad(1, 2, 6, 5);
    quad(3, 0, 4, 7);
  }
  return { vertices, indices };
}

const row = (name, shapes, z, more = {}) => ({
  name,
  position: vec(-4, 3, z),
  shapes,
  repeat: [{ count: 5, offset: vec(1.6, 0.3, 0) }],
  ...more,
});

export const shapesScene = {
  name: 'shapes',
  description: 'Every kind of shape.',
  bodies: [
    { name: 'hills', type: 'BODY_TYPE_FIXED', shapes: [{ heightField: hills() }], color: 0x6f7f63 },
    { name: 'net', type: 'BODY_TYPE_FIXED', position: vec(0, -6, 0), shapes: [{ plane: {} }] },
    { name: 'stair', type: 'BODY_TYPE_FIXED', position: vec(-5, 0.3, -5), shapes: [{ mesh: stair() }], color: 0xb8a58a },
    row('cylinder', [{ cylinder: { radius: 0.4, halfLength: 0.45 } }], -2),
    row('cone', [{ cone: { radius: 0.5, halfLength: 0.5 } }], -0.5),
    row('gem', [{ hull: { points: gem } }], 1),
    row(
      'dumbbell',
      [
        {
          compound: {
            children: [
              { sphere: { radius: 0.35 }, position: vec(-0.5, 0, 0) },
              { box: { halfExtents: vec(0.3, 0.3, 0.3) }, position: vec(0.5, 0, 0) },
              { cylinder: { radius: 0.12, halfLength: 0.4 }, rotation: { x: 0, y: 0, z: Math.SQRT1_2, w: Math.SQRT1_2 } },
            ],
          },
        },
      ],
      2.5,
    ),
    { name: 'post', type: 'BODY_TYPE_FIXED', position: vec(5.5, 4, -2), shapes: [{ box: { halfExtents: vec(0.15, 0.15, 0.15) } }] },
    {
      name: 'link',
      position: vec(5.5, 3.4, -2),
      shapes: [{ capsule: { radius: 0.12, halfLength: 0.22 } }],
      repeat: [{ count: 4, offset: vec(0, -0.7, 0) }],
    },
  ],
  joints: [
    { name: 'hook', bodyA: 'post', bodyB: 'link', frame: { position: vec(5.5, 3.75, -2) }, ball: {} },
    {
      name: 'chain',
      bodyA: 'link',
      bodyB: 'link[1]',
      frame: { position: vec(5.5, 3.05, -2) },
      ball: {},
      repeat: { count: 3, offset: vec(0, -0.7, 0) },
    },
  ],
};
