// Solid objects that are not bodies, such as wheels and faces: rewritten with every rendered frame into
// reused instances.

import * as THREE from 'three';
import { Instances } from './instances';
import { UNIT_GEOMETRIES, type UnitKind } from './shape_parts';

interface KindInstances {
  readonly instances: Instances;
  readonly slots: number[];
  usedCount: number;
}

const matrix = new THREE.Matrix4();

export class Solids {
  private readonly kinds = new Map<UnitKind, KindInstances>();
  private readonly material = new THREE.MeshStandardMaterial({ roughness: 0.6 });

  constructor(private readonly scene: THREE.Scene) {}

  begin(): void {
    for (const kind of this.kinds.values()) kind.usedCount = 0;
  }

  /** Adds a unit geometry, scaled, rotated and moved. */
  add(kind: UnitKind, at: THREE.Vector3, turn: THREE.Quaternion, size: THREE.Vector3, color: THREE.Color): void {
    const entry = this.entryOf(kind);
    if (entry.usedCount === entry.slots.length) entry.slots.push(entry.instances.acquire(0));
    const slot = entry.slots[entry.usedCount++]!;
    entry.instances.setMatrix(slot, matrix.compose(at, turn, size));
    entry.instances.setColor(slot, color);
  }

  end(): void {
    for (const { instances, slots, usedCount } of this.kinds.values()) {
      while (slots.length > usedCount) instances.release(slots.pop()!);
      instances.upload();
    }
  }

  countOf(kind: UnitKind): number {
    return this.kinds.get(kind)?.usedCount ?? 0;
  }
  get count(): number {
    return [...this.kinds.values()].reduce((sum, { usedCount }) => sum + usedCount, 0);
  }

  /** For tests: the matrix of an object. */
  matrixOf(kind: UnitKind, number: number): THREE.Matrix4 {
    const { instances, slots } = this.entryOf(kind);
    const found = new THREE.Matrix4();
    instances.mesh.getMatrixAt(slots[number]!, found);
    return found;
  }

  private entryOf(kind: UnitKind): KindInstances {
    const known = this.kinds.get(kind);
    if (known) return known;
    const created: KindInstances = { instances: new Instances(this.scene, kind, UNIT_GEOMETRIES[kind](), this.material, true, 32), slots: [], usedCount: 0 };
    this.kinds.set(kind, created);
    return created;
  }
}
