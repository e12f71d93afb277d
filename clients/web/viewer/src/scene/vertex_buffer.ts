// Coloured points or lines that are written anew many times a second into the same memory, which only ever grows.

import * as THREE from 'three';

const FIRST_ROOM = 1024; // vertices

export class VertexBuffer {
  count = 0;
  private positions!: THREE.BufferAttribute;
  private colors!: THREE.BufferAttribute;

  constructor(readonly object: THREE.LineSegments | THREE.Points) {
    object.frustumCulled = false; // its bounds change all the time
    object.renderOrder = 1;
    this.makeRoom(FIRST_ROOM);
    this.end();
  }

  static lines(opacity: number): VertexBuffer {
    const look = { vertexColors: true, depthTest: false, transparent: true, opacity, fog: false, toneMapped: false };
    return new VertexBuffer(new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial(look)));
  }

  static points(pixels: number): VertexBuffer {
    const look = { vertexColors: true, depthTest: false, transparent: true, fog: false, toneMapped: false };
    const material = new THREE.PointsMaterial({ ...look, size: pixels, sizeAttenuation: false });
    return new VertexBuffer(new THREE.Points(new THREE.BufferGeometry(), material));
  }

  get room(): number {
    return this.positions.count;
  }

  begin(): void {
    this.count = 0;
  }

  vertex(x: number, y: number, z: number, color: THREE.Color): void {
    if (this.count === this.room) this.makeRoom(this.room * 2);
    this.positions.setXYZ(this.count, x, y, z);
    this.colors.setXYZ(this.count, color.r, color.g, color.b);
    this.count++;
  }

  end(): void {
    const { geometry } = this.object;
    geometry.setDrawRange(0, this.count);
    this.object.visible = this.count > 0;
    if (this.count === 0) return;
    for (const attribute of [this.positions, this.colors]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.count * 3);
      attribute.needsUpdate = true;
    }
  }

  private makeRoom(room: number): void {
    const { geometry } = this.object;
    geometry.dispose(); // what the graphics processor holds of the smaller ones
    const longer = (old: THREE.BufferAttribute | undefined) => {
      const array = new Float32Array(room * 3);
      if (old) array.set(old.array);
      return new THREE.BufferAttribute(array, 3).setUsage(THREE.DynamicDrawUsage);
    };
    this.positions = longer(this.positions);
    this.colors = longer(this.colors);
    geometry.setAttribute('position', this.positions);
    geometry.setAttribute('color', this.colors);
  }
}
