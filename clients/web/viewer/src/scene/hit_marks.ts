// Hit marks: flashes of 0.3 s, larger for harder hits. The number of marks is fixed; a new mark
// replaces the oldest.

import * as THREE from 'three';

const MARKS = 64;
const DURATION_MS = 300;
const SIZE_MIN = 0.06; // m
const SIZE_MAX = 0.4;
const SIZE_PER_SPEED = 0.03; // m per m/s

const matrix = new THREE.Matrix4();
const HIDDEN = new THREE.Matrix4().makeScale(0, 0, 0);

export class HitMarks {
  readonly mesh: THREE.InstancedMesh;
  private readonly marks = Array.from({ length: MARKS }, () => ({ at: new THREE.Vector3(), size: 0, startMs: -Infinity }));
  private next = 0;
  private active = 0;

  constructor(scene: THREE.Scene) {
    const options = { color: 0xfff3c4, transparent: true, opacity: 0.85, depthWrite: false, fog: false, toneMapped: false };
    this.mesh = new THREE.InstancedMesh(new THREE.IcosahedronGeometry(1, 1), new THREE.MeshBasicMaterial(options), MARKS);
    this.mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
    scene.add(this.mesh);
  }

  /** `fromMs`: when the mark appears, because rendering is behind the server. */
  add(x: number, y: number, z: number, speed: number, fromMs: number): void {
    const mark = this.marks[this.next]!;
    this.next = (this.next + 1) % MARKS;
    mark.at.set(x, y, z);
    mark.size = Math.min(SIZE_MAX, SIZE_MIN + SIZE_PER_SPEED * speed);
    mark.startMs = fromMs;
  }

  get activeCount(): number {
    return this.active;
  }

  /** Call once per rendered frame. */
  update(nowMs: number): void {
    const previouslyActive = this.active;
    this.active = 0;
    for (let i = 0; i < MARKS; i++) {
      const { at, size, startMs } = this.marks[i]!;
      const age = (nowMs - startMs) / DURATION_MS;
      if (age < 0 || age >= 1) {
        this.mesh.setMatrixAt(i, HIDDEN);
        continue;
      }
      this.active++;
      const scale = size * Math.sqrt(1 - age);
      this.mesh.setMatrixAt(i, matrix.makeScale(scale, scale, scale).setPosition(at));
    }
    this.mesh.visible = this.active > 0;
    if (this.active > 0 || previouslyActive > 0) this.mesh.instanceMatrix.needsUpdate = true;
  }
}
