// What the solver sees, drawn over the bodies: contacts, bounds, joints, the broad phase as lines, islands as tints. Written anew
// with every answer of the server; in between the pictures show the same lines.

import { create } from '@bufbuild/protobuf';
import * as THREE from 'three';
import { Vec3Schema } from '@jostle/client/gen/common_pb';
import type { DebugBox, DebugContact, DebugIsland, DebugJoint, DebugResponse } from '@jostle/client/gen/query_pb';
import { VertexBuffer } from './vertex_buffer';

/** What is asked of the server. */
export interface DebugOptions {
  contacts: boolean;
  islands: boolean;
  bounds: boolean;
  joints: boolean;
  broadPhase: boolean;
}

const TOUCHING = new THREE.Color(0xff6b5e);
const NEAR = new THREE.Color(0x7cc4ff); // close, but nothing presses
const BOUNDS = new THREE.Color(0x7bd88f);
const CELLS = new THREE.Color(0xb79cff);
const JOINT = new THREE.Color(0xffd166);
const TO_BODY = new THREE.Color(0x9a8247);

const SHORTEST_NORMAL = 0.12; // m
const LONGEST_NORMAL = 1.5;
const PER_ROOT_IMPULSE = 0.06; // m / sqrt(N s): a body of a gram and one of a ton both show

const nothing = create(Vec3Schema);

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

  /** Draws what is wished for and in the answer. Joints are tied to where their bodies are drawn. */
  show(response: DebugResponse, options: DebugOptions, poseOf: (entity: number) => ArrayLike<number> | undefined): void {
    for (const buffer of this.buffers) buffer.begin();
    if (options.contacts) for (const contact of response.contacts) this.drawContact(contact);
    if (options.bounds) for (const box of response.bounds) drawBox(this.boundLines, box, BOUNDS);
    if (options.broadPhase) for (const box of response.broadPhase) drawBox(this.cellLines, box, CELLS);
    if (options.joints) for (const joint of response.joints) this.drawJoint(joint, poseOf);
    for (const buffer of this.buffers) buffer.end();
  }

  clear(): void {
    for (const buffer of this.buffers) {
      buffer.begin();
      buffer.end();
    }
  }

  private drawContact({ point: p = nothing, normal: n = nothing, impulse, touching }: DebugContact): void {
    const color = touching ? TOUCHING : NEAR;
    const length = normalLength(impulse);
    this.contactPoints.vertex(p.x, p.y, p.z, color);
    this.contactLines.vertex(p.x, p.y, p.z, color);
    this.contactLines.vertex(p.x + length * n.x, p.y + length * n.y, p.z + length * n.z, color);
  }

  // The anchors of most joints lie together, so that a line between them alone would show nothing but their error.
  private drawJoint(
    { anchorA: a = nothing, anchorB: b = nothing, entityA, entityB }: DebugJoint,
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
  return Math.min(LONGEST_NORMAL, SHORTEST_NORMAL + PER_ROOT_IMPULSE * Math.sqrt(Math.max(0, impulse)));
}

function drawBox(to: VertexBuffer, { low: l = nothing, high: h = nothing }: DebugBox, color: THREE.Color): void {
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

const GOLDEN = 0.618034; // neighbours in number are far apart in hue

/** A colour per body: that of its island, which is the same as long as its body with the lowest id stays. */
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
