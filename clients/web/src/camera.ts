// Where the viewer looks from: orbit with the mouse, pan with the right button, zoom with the wheel; touch works alike.

import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

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
