// Solver state as an overlay: contacts, bounds, joints and the broad phase as lines, islands as tints.
// Rebuilt with each response of the server; rendered frames in between show the same lines.

import type { Vec3 } from '@jostle/client/gen/common_pb';
import type { DebugBox, DebugContact, DebugIsland, DebugJoint, DebugResponse } from '@jostle/client/gen/query_pb';
import * as THREE from 'three';
import { VertexBuffer } from './vertex_buffer';

/** What to request from the server. */
export interface DebugOptions {
  contacts: boolean;
  islands: boolean;
  bounds: boolean;
  joints: boolean;
  broadPhase: boolean;
}

const TOUCHING = new THREE.Color(0xff6b5e);
const NEAR = new THREE.Color(0x7cc4ff); // close, without contact force
const BOUNDS = new THREE.Color(0x7bd88f);
const BROAD_PHASE = new THREE.Color(0xb79cff);
const JOINT = new THREE.Color(0xffd166);
const TO_BODY = new THREE.Color(0x9a8247);

const NORMAL_LENGTH_MIN = 0.12; // m
const NORMAL_LENGTH_MAX = 1.5;
const NORMAL_LENGTH_SCALE = 0.06; // m / sqrt(N s), so that the impulses of bodies of 1 g and of 1 t are both visible

const ZERO: Vec3 = { $typeName: 'jostle.v1.Vec3', x: 0, y: 0, z: 0 };

export class DebugView {
  readonly contactPoints = VertexBuffer.points(7);
  readonly contactLines = VertexBuffer.lines(1);
  readonly boundLines = VertexBuffer.lines(0.55);
  readonly jointPoints = VertexBuffer.points(6);
  readonly jointLines = VertexBuffer.lines(1);
  readonly cellLines = VertexBuffer.lines(0.3);
  private readonly buffers = [
    this.contactPoints,
    this.contactLines,
    this.boundLines,
    this.jointPoints,
    this.jointLines,
    this.cellLines,
  ];

  constructor(scene: THREE.Scene) {
    for (const { object } of this.buffers) scene.add(object);
  }

  /**
   * Draws the enabled layers of the response. Joint lines start at the rendered poses of their bodies.
   */
  show(response: DebugResponse, options: DebugOptions, poseOf: (entity: number) => ArrayLike<number> | undefined): void {
    for (const buffer of this.buffers) buffer.begin();
    if (options.contacts) for (const contact of response.contacts) this.drawContact(contact);
    if (options.bounds) for (const box of response.bounds) drawBox(this.boundLines, box, BOUNDS);
    if (options.broadPhase) for (const box of response.broadPhase) drawBox(this.cellLines, box, BROAD_PHASE);
    if (options.joints) for (const joint of response.joints) this.drawJoint(joint, poseOf);
    for (const buffer of this.buffers) buffer.end();
  }

  clear(): void {
    for (const buffer of this.buffers) {
      buffer.begin();
      buffer.end();
    }
  }

  private drawContact({ point: p = ZERO, normal: n = ZERO, impulse, touching }: DebugContact): void {
    const color = touching ? TOUCHING : NEAR;
    const length = normalLength(impulse);
    this.contactPoints.vertex(p.x, p.y, p.z, color);
    this.contactLines.vertex(p.x, p.y, p.z, color);
    this.contactLines.vertex(p.x + length * n.x, p.y + length * n.y, p.z + length * n.z, color);
  }

  // The anchors of most joints coincide, so a line between them alone would show only their error.
  private drawJoint(
    { anchorA: a = ZERO, anchorB: b = ZERO, entityA, entityB }: DebugJoint,
    poseOf: (entity: number) => ArrayLike<number> | undefined,
  ): void {
    for (const [entity, anchor] of [
      [entityA, a],
      [entityB, b],
    ] as const) {
      this.jointPoints.vertex(anchor.x, anchor.y, anchor.z, JOINT);
      const pose = poseOf(entity);
      if (!pose) continue;
      this.jointLines.vertex(pose[0]!, pose[1]!, pose[2]!, TO_BODY);
      this.jointLines.vertex(anchor.x, anchor.y, anchor.z, TO_BODY);
    }
    this.jointLines.vertex(a.x, a.y, a.z, JOINT);
    this.jointLines.vertex(b.x, b.y, b.z, JOINT);
  }
}

export function normalLength(impulse: number): number {
  return Math.min(NORMAL_LENGTH_MAX, NORMAL_LENGTH_MIN + NORMAL_LENGTH_SCALE * Math.sqrt(Math.max(0, impulse)));
}

function drawBox(to: VertexBuffer, { low: l = ZERO, high: h = ZERO }: DebugBox, color: THREE.Color): void {
  for (const y of [l.y, h.y]) {
    to.vertex(l.x, y, l.z, color);
    to.vertex(h.x, y, l.z, color);
    to.vertex(h.x, y, l.z, color);
    to.vertex(h.x, y, h.z, color);
    to.vertex(h.x, y, h.z, color);
    to.vertex(l.x, y, h.z, color);
    to.vertex(l.x, y, h.z, color);
    to.vertex(l.x, y, l.z, color);
  }
  for (const x of [l.x, h.x])
    for (const z of [l.z, h.z]) {
      to.vertex(x, l.y, z, color);
      to.vertex(x, h.y, z, color);
    }
}

const GOLDEN = 0.618034; // golden ratio: consecutive ids get distant hues

/**
 * A color per body: that of its island, which is stable while the island contains its body with the
 * lowest id.
 */
export function islandTints(islands: readonly DebugIsland[]): Map<number, number> {
  const tints = new Map<number, number>();
  const color = new THREE.Color();
  for (const { entities } of islands) {
    const lowest = entities.reduce((a, b) => Math.min(a, b), Infinity);
    if (lowest === Infinity) continue;
    const tint = color.setHSL((lowest * GOLDEN) % 1, 0.62, 0.58).getHex();
    for (const entity of entities) tints.set(entity, tint);
  }
  return tints;
}
