// A mark where something hit: flashes for 0.3 s, larger for harder hits. A fixed number of them; the oldest gives its place to the
// newest.

import * as THREE from 'three';

const MARKS = 64;
const LASTS_MS = 300;
const SMALLEST = 0.06; // m
const LARGEST = 0.4;
const PER_SPEED = 0.03; // m per m/s

const matrix = new THREE.Matrix4();
const NOWHERE = new THREE.Matrix4().makeScale(0, 0, 0);

export class HitMarks {
  readonly mesh: THREE.InstancedMesh;
  private readonly marks = Array.from({ length: MARKS }, () => ({ at: new THREE.Vector3(), size: 0, bornMs: -Infinity }));
  private next = 0;
  private lit = 0;

  constructor(scene: THREE.Scene) {
    const look = { color: 0xfff3c4, transparent: true, opacity: 0.85, depthWrite: false, fog: false, toneMapped: false };
    this.mesh = new THREE.InstancedMesh(new THREE.IcosahedronGeometry(1, 1), new THREE.MeshBasicMaterial(look), MARKS);
    this.mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
    scene.add(this.mesh);
  }

  /** To be seen from a time on: the picture is a little behind what the server told. */
  add(x: number, y: number, z: number, speed: number, fromMs: number): void {
    const mark = this.marks[this.next]!;
    this.next = (this.next + 1) % MARKS;
    mark.at.set(x, y, z);
    mark.size = Math.min(LARGEST, SMALLEST + PER_SPEED * speed);
    mark.bornMs = fromMs;
  }

  get activeCount(): number {
    return this.lit;
  }

  /** Once a picture. */
  update(nowMs: number): void {
    const before = this.lit;
    this.lit = 0;
    for (let i = 0; i < MARKS; i++) {
      const { at, size, bornMs } = this.marks[i]!;
      const age = (nowMs - bornMs) / LASTS_MS;
      if (age < 0 || age >= 1) {
        this.mesh.setMatrixAt(i, NOWHERE);
        continue;
      }
      this.lit++;
      const scale = size * Math.sqrt(1 - age);
      this.mesh.setMatrixAt(i, matrix.makeScale(scale, scale, scale).setPosition(at));
    }
    this.mesh.visible = this.lit > 0;
    if (this.lit > 0 || before > 0) this.mesh.instanceMatrix.needsUpdate = true;
  }
}
