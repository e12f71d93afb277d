// Explosion marks: spheres of light that grow and fade within 0.55 s.

import * as THREE from 'three';

const MARKS = 8;
const DURATION_MS = 550;
const DUPLICATE_DISTANCE_M = 0.05; // several rendered frames show the same tick: a mark closer than this to a recent one is the same blast

const matrix = new THREE.Matrix4();
const color = new THREE.Color();
const FLAME = new THREE.Color(0xffa640);

export class BlastMarks {
  private readonly ball: THREE.InstancedMesh;
  private readonly marks = Array.from({ length: MARKS }, () => ({ at: new THREE.Vector3(), radius: 0, startMs: -Infinity }));
  private next = 0;
  private active = 0;

  constructor(scene: THREE.Scene) {
    const options = { transparent: true, blending: THREE.AdditiveBlending, depthWrite: false, fog: false, toneMapped: false };
    this.ball = new THREE.InstancedMesh(new THREE.IcosahedronGeometry(1, 3), new THREE.MeshBasicMaterial(options), MARKS);
    this.ball.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    this.ball.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(MARKS * 3), 3);
    this.ball.frustumCulled = false;
    this.ball.visible = false;
    scene.add(this.ball);
  }

  add(x: number, y: number, z: number, radius: number, nowMs: number): void {
    const duplicate = this.marks.some(({ at, startMs }) => nowMs - startMs < DURATION_MS && Math.hypot(at.x - x, at.y - y, at.z - z) < DUPLICATE_DISTANCE_M);
    if (duplicate) return;
    const mark = this.marks[this.next]!;
    this.next = (this.next + 1) % MARKS;
    mark.at.set(x, y, z);
    mark.radius = radius;
    mark.startMs = nowMs;
  }

  get activeCount(): number {
    return this.active;
  }

  /** Call once per rendered frame. */
  update(nowMs: number): void {
    const wasActive = this.active;
    this.active = 0;
    this.marks.forEach(({ at, radius, startMs }, k) => {
      const age = (nowMs - startMs) / DURATION_MS;
      const visible = age >= 0 && age < 1;
      if (visible) this.active++;
      const size = visible ? radius * (0.12 + 0.5 * Math.sqrt(age)) : 0;
      this.ball.setMatrixAt(k, matrix.makeScale(size, size, size).setPosition(at));
      this.ball.setColorAt(k, color.copy(FLAME).multiplyScalar(visible ? 0.5 * (1 - age) ** 1.5 : 0));
    });
    this.ball.visible = this.active > 0;
    if (this.active === 0 && wasActive === 0) return;
    this.ball.instanceMatrix.needsUpdate = true;
    this.ball.instanceColor!.needsUpdate = true;
  }
}
