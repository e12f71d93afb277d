// Colored points or lines that are rewritten many times per second into the same buffers, which only
// grow.

import * as THREE from 'three';

const INITIAL_CAPACITY = 1024; // vertices

export class VertexBuffer {
  count = 0;
  private positions!: THREE.BufferAttribute;
  private colors!: THREE.BufferAttribute;

  constructor(readonly object: THREE.LineSegments | THREE.Points) {
    object.frustumCulled = false; // the bounds change constantly
    object.renderOrder = 1;
    this.reserve(INITIAL_CAPACITY);
    this.end();
  }

  static lines(opacity: number): VertexBuffer {
    const options = { vertexColors: true, depthTest: false, transparent: true, opacity, fog: false, toneMapped: false };
    return new VertexBuffer(new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial(options)));
  }

  static points(pixels: number): VertexBuffer {
    const options = { vertexColors: true, depthTest: false, transparent: true, fog: false, toneMapped: false };
    const material = new THREE.PointsMaterial({ ...options, size: pixels, sizeAttenuation: false });
    return new VertexBuffer(new THREE.Points(new THREE.BufferGeometry(), material));
  }

  get capacity(): number {
    return this.positions.count;
  }

  begin(): void {
    this.count = 0;
  }

  vertex(x: number, y: number, z: number, color: THREE.Color): void {
    if (this.count === this.capacity) this.reserve(this.capacity * 2);
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

  private reserve(capacity: number): void {
    const { geometry } = this.object;
    geometry.dispose(); // frees the smaller GPU buffers
    const grown = (old: THREE.BufferAttribute | undefined) => {
      const array = new Float32Array(capacity * 3);
      if (old) array.set(old.array);
      return new THREE.BufferAttribute(array, 3).setUsage(THREE.DynamicDrawUsage);
    };
    this.positions = grown(this.positions);
    this.colors = grown(this.colors);
    geometry.setAttribute('position', this.positions);
    geometry.setAttribute('color', this.colors);
  }
}
