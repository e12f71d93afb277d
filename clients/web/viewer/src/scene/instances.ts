// Instances of one geometry: slots are taken and given back, so that a body that comes or goes costs its own parts only.

import * as THREE from 'three';
import type { Kind } from './shape_parts';

const NOWHERE = new THREE.Matrix4().makeScale(0, 0, 0);

export class Instances {
  mesh: THREE.InstancedMesh;
  private entities: Uint32Array;
  private shapes: Uint32Array;
  private free: number[] = [];
  private used = 0;
  private moved = false;
  private painted = false;

  constructor(
    private readonly scene: THREE.Scene,
    readonly kind: Kind,
    geometry: THREE.BufferGeometry,
    material: THREE.Material,
    private readonly castShadow: boolean,
    room = 64,
  ) {
    this.entities = new Uint32Array(room);
    this.shapes = new Uint32Array(room);
    this.mesh = this.makeMesh(geometry, material, room);
  }

  private makeMesh(geometry: THREE.BufferGeometry, material: THREE.Material, room: number): THREE.InstancedMesh {
    const mesh = new THREE.InstancedMesh(geometry, material, room);
    mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    mesh.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(room * 3).fill(1), 3);
    mesh.castShadow = this.castShadow;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false; // instances are all over the place
    mesh.count = 0;
    mesh.userData['instances'] = this;
    this.scene.add(mesh);
    return mesh;
  }

  /** How many slots are taken. */
  get size(): number {
    return this.used;
  }

  /** A slot for a part of that entity's shape; invisible until it is placed. */
  take(entity: number, shape = 0): number {
    const slot = this.free.pop() ?? this.mesh.count;
    if (slot === this.mesh.instanceMatrix.count) this.grow();
    if (slot === this.mesh.count) this.mesh.count++;
    this.used++;
    this.entities[slot] = entity;
    this.shapes[slot] = shape;
    this.place(slot, NOWHERE);
    return slot;
  }

  giveBack(slot: number): void {
    this.place(slot, NOWHERE);
    this.entities[slot] = 0;
    this.used--;
    this.free.push(slot);
    if (this.used > 0) return;
    this.free = [];
    this.mesh.count = 0;
  }

  entityAt(slot: number): number {
    return this.entities[slot] ?? 0;
  }

  shapeAt(slot: number): number {
    return this.shapes[slot] ?? 0;
  }

  place(slot: number, matrix: THREE.Matrix4): void {
    matrix.toArray(this.mesh.instanceMatrix.array, slot * 16);
    this.moved = true;
  }

  paint(slot: number, color: THREE.Color): void {
    color.toArray(this.mesh.instanceColor!.array, slot * 3);
    this.painted = true;
  }

  colorAt(slot: number): THREE.Color {
    return new THREE.Color().fromArray(this.mesh.instanceColor!.array, slot * 3);
  }

  /** Tells the graphics processor what changed since the last picture. */
  publish(): void {
    if (this.moved) {
      this.mesh.instanceMatrix.needsUpdate = true;
      this.mesh.boundingSphere = null; // picking computes it anew
    }
    if (this.painted) this.mesh.instanceColor!.needsUpdate = true;
    this.moved = this.painted = false;
  }

  /** Gives the graphics processor its memory back; not to be used after. The material may be shared and stays. */
  dispose(): void {
    this.scene.remove(this.mesh);
    this.mesh.geometry.dispose();
    this.mesh.dispose();
  }

  private grow(): void {
    const old = this.mesh;
    const room = old.instanceMatrix.count * 2;
    this.scene.remove(old);
    this.mesh = this.makeMesh(old.geometry, old.material as THREE.Material, room);
    this.mesh.count = old.count;
    this.mesh.instanceMatrix.array.set(old.instanceMatrix.array);
    this.mesh.instanceColor!.array.set(old.instanceColor!.array);
    this.entities = longer(this.entities, room);
    this.shapes = longer(this.shapes, room);
    this.moved = this.painted = true;
    old.dispose();
  }
}

function longer(old: Uint32Array, room: number): Uint32Array {
  const out = new Uint32Array(room);
  out.set(old);
  return out;
}
