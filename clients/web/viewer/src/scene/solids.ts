// Solid things that are no bodies, like wheels and faces: written anew with every picture, into instances that are kept.

import * as THREE from 'three';
import { Instances } from './instances';
import { UNIT_GEOMETRIES, type UnitKind } from './shape_parts';

interface Used {
  readonly instances: Instances;
  readonly slots: number[];
  used: number;
}

const matrix = new THREE.Matrix4();

export class Solids {
  private readonly kinds = new Map<UnitKind, Used>();
  private readonly material = new THREE.MeshStandardMaterial({ roughness: 0.6 });

  constructor(private readonly scene: THREE.Scene) {}

  begin(): void {
    for (const kind of this.kinds.values()) kind.used = 0;
  }

  /** A unit geometry, scaled, turned and moved. */
  add(kind: UnitKind, at: THREE.Vector3, turn: THREE.Quaternion, size: THREE.Vector3, color: THREE.Color): void {
    const of = this.of(kind);
    if (of.used === of.slots.length) of.slots.push(of.instances.take(0));
    const slot = of.slots[of.used++]!;
    of.instances.place(slot, matrix.compose(at, turn, size));
    of.instances.paint(slot, color);
  }

  end(): void {
    for (const { instances, slots, used } of this.kinds.values()) {
      while (slots.length > used) instances.giveBack(slots.pop()!);
      instances.publish();
    }
  }

  countOf(kind: UnitKind): number {
    return this.kinds.get(kind)?.used ?? 0;
  }
  get count(): number {
    return [...this.kinds.values()].reduce((sum, { used }) => sum + used, 0);
  }

  /** For tests: where the thing of that number is. */
  matrixOf(kind: UnitKind, number: number): THREE.Matrix4 {
    const { instances, slots } = this.of(kind);
    const found = new THREE.Matrix4();
    instances.mesh.getMatrixAt(slots[number]!, found);
    return found;
  }

  private of(kind: UnitKind): Used {
    const known = this.kinds.get(kind);
    if (known) return known;
    const made: Used = { instances: new Instances(this.scene, kind, UNIT_GEOMETRIES[kind](), this.material, true, 32), slots: [], used: 0 };
    this.kinds.set(kind, made);
    return made;
  }
}
