// Camera: orbit with the left button, pan with the right button, zoom with the wheel; touch gestures do
// the same.

import * as THREE from 'three';
import { frameBox } from './framing';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

const FOLLOW_RATE = 3; // 1/s
const FOLLOW_UP = 0.3; // m above the controlled entity, which keeps it clear of the panels at the bottom
const APPROACH_RATE = 4; // 1/s
const APPROACH_S = 2; // duration of the approach after taking control; then the user sets the distance
const APPROACH_SLOPE = 0.32; // rad above the controlled entity
const FRAME_DISTANCE_MIN = 9; // m, limits of frame()
const FRAME_DISTANCE_MAX = 95;
const FROM = new THREE.Vector3(13, 9, 18).normalize();

export class Camera {
  readonly camera = new THREE.PerspectiveCamera(55, 1, 0.1, 500);
  readonly controls: OrbitControls;
  private approaching = { distance: 0, remainingS: 0 };

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

  /** Shows all of the box, within the distance limits. */
  frame(box: THREE.Box3): void {
    if (box.isEmpty()) return;
    const { position, target } = frameBox(box, FROM, this.camera.fov, this.camera.aspect, FRAME_DISTANCE_MIN, FRAME_DISTANCE_MAX);
    this.camera.position.copy(position);
    this.controls.target.copy(target);
  }

  /** Approaches the followed entity to `distance` (m) during the next seconds. */
  startApproach(distance: number): void {
    this.approaching = { distance, remainingS: APPROACH_S };
  }

  /**
   * Keeps the camera behind and above an entity. `heading`: rad about y from -z, to the left;
   * undefined: the user turns it.
   */
  follow(position: ArrayLike<number>, heading: number | undefined, seconds: number): void {
    const target = this.controls.target;
    const moved = new THREE.Vector3(position[0], position[1]! + FOLLOW_UP, position[2]).sub(target);
    target.add(moved);
    this.camera.position.add(moved);
    if (this.approaching.remainingS > 0) this.approach(seconds);
    if (heading === undefined) return;
    // Turn after the entity: most of the angle within 0.5 s.
    const arm = this.camera.position.clone().sub(target);
    const now = Math.atan2(arm.x, arm.z);
    const left = Math.atan2(Math.sin(heading - now), Math.cos(heading - now));
    arm.applyAxisAngle(new THREE.Vector3(0, 1, 0), left * (1 - Math.exp(-FOLLOW_RATE * seconds)));
    this.camera.position.copy(target).add(arm);
  }

  private approach(seconds: number): void {
    this.approaching.remainingS -= seconds;
    const arm = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    const fraction = 1 - Math.exp(-APPROACH_RATE * seconds);
    arm.radius += fraction * (this.approaching.distance - arm.radius);
    arm.phi += fraction * (Math.PI / 2 - APPROACH_SLOPE - arm.phi);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3().setFromSpherical(arm));
  }

  /**
   * Calls `draw` with the camera at most `distance` m from its target, so that obstacles do not hide
   * the target.
   */
  renderWithin(distance: number, draw: () => void): void {
    const { position } = this.camera;
    const { target } = this.controls;
    const saved = position.clone();
    const arm = saved.distanceTo(target);
    if (distance < arm) position.lerpVectors(target, saved, distance / arm);
    draw();
    position.copy(saved);
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
  }

  /** A ray through a point of the canvas, in pixels from its top left corner. */
  ray(x: number, y: number, width: number, height: number): THREE.Raycaster {
    const raycaster = new THREE.Raycaster();
    raycaster.setFromCamera(new THREE.Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), this.camera);
    return raycaster;
  }
}
