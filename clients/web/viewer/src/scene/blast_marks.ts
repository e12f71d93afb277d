// Where something went off: a ball of light that grows and fades within half a second.

import * as THREE from 'three';

const MARKS = 8;
const LASTS_MS = 550;
const SAME_M = 0.05; // a picture is drawn of one tick more than once: marks nearer than that, one after the other, are one

const matrix = new THREE.Matrix4();
const color = new THREE.Color();
const FLAME = new THREE.Color(0xffa640);

export class BlastMarks {
  private readonly ball: THREE.InstancedMesh;
  private readonly marks = Array.from({ length: MARKS }, () => ({ at: new THREE.Vector3(), radius: 0, bornMs: -Infinity }));
  private next = 0;
  private lit = 0;

  constructor(scene: THREE.Scene) {
    const look = { transparent: true, blending: THREE.AdditiveBlending, depthWrite: false, fog: false, toneMapped: false };
    this.ball = new THREE.InstancedMesh(new THREE.IcosahedronGeometry(1, 3), new THREE.MeshBasicMaterial(look), MARKS);
    this.ball.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    this.ball.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(MARKS * 3), 3);
    this.ball.frustumCulled = false;
    this.ball.visible = false;
    scene.add(this.ball);
  }

  add(x: number, y: number, z: number, radius: number, nowMs: number): void {
    const same = this.marks.some(({ at, bornMs }) => nowMs - bornMs < LASTS_MS && Math.hypot(at.x - x, at.y - y, at.z - z) < SAME_M);
    if (same) return;
    const mark = this.marks[this.next]!;
    this.next = (this.next + 1) % MARKS;
    mark.at.set(x, y, z);
    mark.radius = radius;
    mark.bornMs = nowMs;
  }

  get activeCount(): number {
    return this.lit;
  }

  /** Once a picture. */
  update(nowMs: number): void {
    const before = this.lit;
    this.lit = 0;
    this.marks.forEach(({ at, radius, bornMs }, k) => {
      const age = (nowMs - bornMs) / LASTS_MS;
      const burns = age >= 0 && age < 1;
      if (burns) this.lit++;
      const size = burns ? radius * (0.12 + 0.5 * Math.sqrt(age)) : 0;
      this.ball.setMatrixAt(k, matrix.makeScale(size, size, size).setPosition(at));
      this.ball.setColorAt(k, color.copy(FLAME).multiplyScalar(burns ? 0.5 * (1 - age) ** 1.5 : 0));
    });
    this.ball.visible = this.lit > 0;
    if (this.lit === 0 && before === 0) return;
    this.ball.instanceMatrix.needsUpdate = true;
    this.ball.instanceColor!.needsUpdate = true;
  }
}
