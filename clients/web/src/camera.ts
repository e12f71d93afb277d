// Where the viewer looks from: orbit with the mouse, pan with the right button, zoom with the wheel; touch works alike.

import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

const FOLLOW_RATE = 3; // 1/s

export class Camera {
  readonly camera = new THREE.PerspectiveCamera(55, 1, 0.05, 500);
  readonly controls: OrbitControls;

  constructor(canvas: HTMLCanvasElement) {
    this.camera.position.set(13, 10, 17);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target.set(0, 1, -1);
    this.controls.maxPolarAngle = Math.PI * 0.495;
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.maxDistance = 160;
    this.controls.minDistance = 1;
  }

  /** Keeps behind and above something that is driven: `heading`, rad about y from -z, to the left. */
  follow(position: ArrayLike<number>, heading: number | undefined, seconds: number): void {
    const target = this.controls.target;
    const moved = new THREE.Vector3(position[0], position[1]! + 1, position[2]).sub(target);
    target.add(moved);
    this.camera.position.add(moved);
    if (heading === undefined) return;
    // Turns after it, by most of what is left in half a second, unless somebody holds the camera.
    const arm = this.camera.position.clone().sub(target);
    const now = Math.atan2(arm.x, arm.z);
    const left = Math.atan2(Math.sin(heading - now), Math.cos(heading - now));
    arm.applyAxisAngle(new THREE.Vector3(0, 1, 0), left * (1 - Math.exp(-FOLLOW_RATE * seconds)));
    this.camera.position.copy(target).add(arm);
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
  }

  /** A ray through a point of the canvas, in pixels from its corner. */
  ray(x: number, y: number, width: number, height: number): THREE.Raycaster {
    const raycaster = new THREE.Raycaster();
    raycaster.setFromCamera(new THREE.Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), this.camera);
    return raycaster;
  }
}
