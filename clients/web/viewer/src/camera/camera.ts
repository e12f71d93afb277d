// Where the viewer looks from: orbit with the mouse, pan with the right button, zoom with the wheel; touch works alike.

import * as THREE from 'three';
import { frameOf } from './framing';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

const FOLLOW_RATE = 3; // 1/s
const FOLLOW_UP = 0.3; // m over what is driven: it stays clear of the panels below
const SETTLE_RATE = 4; // 1/s
const SETTLE_S = 2; // after taking a wheel the camera comes near; then its distance is the pointer's again
const SETTLE_SLOPE = 0.32; // rad above what is driven
const NEAREST = 9; // m, of a whole scene
const FURTHEST = 95;
const FROM = new THREE.Vector3(13, 9, 18).normalize();

export class Camera {
  readonly camera = new THREE.PerspectiveCamera(55, 1, 0.1, 500);
  readonly controls: OrbitControls;
  private settling = { distance: 0, left: 0 };

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

  /** So that all of that box is seen, unless it is huge. */
  frame(box: THREE.Box3): void {
    if (box.isEmpty()) return;
    const { position, target } = frameOf(box, FROM, this.camera.fov, this.camera.aspect, NEAREST, FURTHEST);
    this.camera.position.copy(position);
    this.controls.target.copy(target);
  }

  /** Follow something that is driven from about so far, from now on. */
  settle(distance: number): void {
    this.settling = { distance, left: SETTLE_S };
  }

  /** Keeps behind and above something that is driven: `heading`, rad about y from -z, to the left. */
  follow(position: ArrayLike<number>, heading: number | undefined, seconds: number): void {
    const target = this.controls.target;
    const moved = new THREE.Vector3(position[0], position[1]! + FOLLOW_UP, position[2]).sub(target);
    target.add(moved);
    this.camera.position.add(moved);
    if (this.settling.left > 0) this.comeNear(seconds);
    if (heading === undefined) return;
    // Turns after it, by most of what is left in half a second, unless somebody holds the camera.
    const arm = this.camera.position.clone().sub(target);
    const now = Math.atan2(arm.x, arm.z);
    const left = Math.atan2(Math.sin(heading - now), Math.cos(heading - now));
    arm.applyAxisAngle(new THREE.Vector3(0, 1, 0), left * (1 - Math.exp(-FOLLOW_RATE * seconds)));
    this.camera.position.copy(target).add(arm);
  }

  private comeNear(seconds: number): void {
    this.settling.left -= seconds;
    const arm = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    const share = 1 - Math.exp(-SETTLE_RATE * seconds);
    arm.radius += share * (this.settling.distance - arm.radius);
    arm.phi += share * (Math.PI / 2 - SETTLE_SLOPE - arm.phi);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3().setFromSpherical(arm));
  }

  /** Draws from no further away than that: so what stands between does not hide what is looked at. */
  within(distance: number, draw: () => void): void {
    const { position } = this.camera;
    const { target } = this.controls;
    const own = position.clone();
    const arm = own.distanceTo(target);
    if (distance < arm) position.lerpVectors(target, own, distance / arm);
    draw();
    position.copy(own);
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
