// Instances of one geometry. Slots are acquired and released, so that adding or removing a body updates
// only its own parts.

import * as THREE from 'three';
import type { Kind } from './shape_parts';

const HIDDEN = new THREE.Matrix4().makeScale(0, 0, 0);

export class Instances {
  mesh: THREE.InstancedMesh;
  private entities: Uint32Array;
  private shapes: Uint32Array;
  private free: number[] = [];
  private used = 0;
  private order = 0;
  private matricesChanged = false;
  private colorsChanged = false;

  constructor(
    private readonly scene: THREE.Scene,
    readonly kind: Kind,
    geometry: THREE.BufferGeometry,
    material: THREE.Material,
    private readonly castShadow: boolean,
    capacity = 64,
  ) {
    this.entities = new Uint32Array(capacity);
    this.shapes = new Uint32Array(capacity);
    this.mesh = this.makeMesh(geometry, material, capacity);
  }

  set renderOrder(order: number) {
    this.mesh.renderOrder = this.order = order;
  }

  private makeMesh(geometry: THREE.BufferGeometry, material: THREE.Material, capacity: number): THREE.InstancedMesh {
    const mesh = new THREE.InstancedMesh(geometry, material, capacity);
    mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    mesh.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(capacity * 3).fill(1), 3);
    mesh.castShadow = this.castShadow;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false; // instances are spread over the world
    mesh.count = 0;
    mesh.renderOrder = this.order;
    mesh.userData['instances'] = this;
    this.scene.add(mesh);
    return mesh;
  }

  /** Number of acquired slots. */
  get size(): number {
    return this.used;
  }

  /** Acquires a slot for a part of the entity's shape; invisible until its matrix is set. */
  acquire(entity: number, shape = 0): number {
    const slot = this.free.pop() ?? this.mesh.count;
    if (slot === this.mesh.instanceMatrix.count) this.grow();
    if (slot === this.mesh.count) this.mesh.count++;
    this.used++;
    this.entities[slot] = entity;
    this.shapes[slot] = shape;
    this.setMatrix(slot, HIDDEN);
    return slot;
  }

  release(slot: number): void {
    this.setMatrix(slot, HIDDEN);
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

  setMatrix(slot: number, matrix: THREE.Matrix4): void {
    matrix.toArray(this.mesh.instanceMatrix.array, slot * 16);
    this.matricesChanged = true;
  }

  setColor(slot: number, color: THREE.Color): void {
    color.toArray(this.mesh.instanceColor!.array, slot * 3);
    this.colorsChanged = true;
  }

  colorAt(slot: number): THREE.Color {
    return new THREE.Color().fromArray(this.mesh.instanceColor!.array, slot * 3);
  }

  /** Uploads what changed since the last rendered frame. */
  upload(): void {
    if (this.matricesChanged) {
      this.mesh.instanceMatrix.needsUpdate = true;
      this.mesh.boundingSphere = null; // recomputed by picking
    }
    if (this.colorsChanged) this.mesh.instanceColor!.needsUpdate = true;
    this.matricesChanged = this.colorsChanged = false;
  }

  /**
   * Releases GPU memory; the object must not be used afterwards. The material may be shared and is not
   * disposed.
   */
  dispose(): void {
    this.scene.remove(this.mesh);
    this.mesh.geometry.dispose();
    this.mesh.dispose();
  }

  private grow(): void {
    const old = this.mesh;
    const capacity = old.instanceMatrix.count * 2;
    this.scene.remove(old);
    this.mesh = this.makeMesh(old.geometry, old.material as THREE.Material, capacity);
    this.mesh.count = old.count;
    this.mesh.instanceMatrix.array.set(old.instanceMatrix.array);
    this.mesh.instanceColor!.array.set(old.instanceColor!.array);
    this.entities = grown(this.entities, capacity);
    this.shapes = grown(this.shapes, capacity);
    this.matricesChanged = this.colorsChanged = true;
    old.dispose();
  }
}

function grown(old: Uint32Array, capacity: number): Uint32Array {
  const out = new Uint32Array(capacity);
  out.set(old);
  return out;
}
