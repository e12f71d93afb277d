// Camera: orbit with the left button, pan with the right button, zoom with the wheel; touch gestures and
// the keys of the focused view do the same. Planar worlds are shown straight on by an orthographic
// camera that pans and zooms. The target appears at the center of the area that panels leave free.

import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { frameFlat, framePoints, freeArea, NO_INSETS, type FreeArea, narrowDistance, type Insets } from './framing';

const FOLLOW_RATE = 3; // 1/s
const FOLLOW_UP = 0.3; // m above the controlled entity
const APPROACH_RATE = 4; // 1/s
const APPROACH_S = 2; // duration of the approach after taking control; then the user sets the distance
const APPROACH_SLOPE = 0.32; // rad above the controlled entity
const FRAME_DISTANCE_MIN = 5; // m, limits of frame()
const FRAME_DISTANCE_MAX = 400;
const FOCUS_RADII = 7; // distance of a focused body
const FOCUS_DISTANCE_MIN = 2.5; // m
const MOVE_S = 0.45; // duration of animated moves
const OFFSET_RATE = 9; // 1/s, at which the view follows panels that open and close
const FOV = 55; // degrees
const FLAT_DISTANCE = 200; // m from the plane of a planar world
const FLAT_HEIGHT_MIN = 2; // m, half the height of a planar view
const KEY_TURN = 0.06; // rad per key press
const KEY_ZOOM = 1.12;
const FROM_AZIMUTH = Math.atan2(13, 18); // rad about y from +z
const FROM_SLOPES = [0.39, 0.72] as const; // rad above the horizon, in wide and in tall views
const STRAIGHT = new THREE.Vector3(0, 0, 1);

interface Pose {
  readonly position: THREE.Vector3;
  readonly target: THREE.Vector3;
  readonly halfHeight: number; // m, orthographic only
}

export class Camera {
  readonly perspective = new THREE.PerspectiveCamera(FOV, 1, 0.1, 3000);
  readonly flat = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 2 * FLAT_DISTANCE);
  readonly controls: OrbitControls;
  planar = false;
  private approaching = { distance: 0, remainingS: 0 };
  private move: { from: Pose; to: Pose; seconds: number } | undefined;
  private insets = NO_INSETS;
  private offset = new THREE.Vector2();
  private halfHeight = 10; // m, of the orthographic view at zoom 1
  private width = 1;
  private height = 1;

  constructor(canvas: HTMLCanvasElement) {
    this.perspective.position.set(13, 10, 17);
    this.controls = new OrbitControls(this.perspective, canvas);
    this.controls.target.set(0, 1, -1);
    this.controls.maxPolarAngle = Math.PI * 0.495;
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.maxDistance = 800;
    this.controls.minDistance = 1;
    this.controls.addEventListener('start', () => (this.move = undefined));
  }

  get camera(): THREE.PerspectiveCamera | THREE.OrthographicCamera {
    return this.planar ? this.flat : this.perspective;
  }

  /** m that are visible from the bottom to the top of the view, at the target. */
  get viewHeight(): number {
    if (this.planar) return (2 * this.halfHeight) / this.flat.zoom;
    return 2 * Math.tan((this.perspective.fov * Math.PI) / 360) * this.perspective.position.distanceTo(this.controls.target);
  }

  /** m from the camera to its target; of a planar view, that of a perspective camera that shows as much. */
  get distance(): number {
    return this.viewHeight / (2 * Math.tan((FOV * Math.PI) / 360));
  }

  /** Shows a planar world straight on. */
  setPlanar(planar: boolean): void {
    if (this.planar === planar) return;
    this.planar = planar;
    this.move = undefined;
    const { controls } = this;
    controls.object = this.camera;
    controls.enableRotate = !planar;
    controls.mouseButtons.LEFT = planar ? THREE.MOUSE.PAN : THREE.MOUSE.ROTATE;
    controls.touches.ONE = planar ? THREE.TOUCH.PAN : THREE.TOUCH.ROTATE;
    controls.maxPolarAngle = Math.PI * (planar ? 0.5 : 0.495);
    if (planar) this.flat.position.copy(controls.target).addScaledVector(STRAIGHT, FLAT_DISTANCE);
    this.applyProjection();
  }

  /** Shows all points, within the distance limits. */
  frame(points: readonly THREE.Vector3[], animated = false): void {
    if (points.length === 0) return;
    this.perspective.fov = FOV;
    const area = this.freeArea();
    if (this.planar) {
      const box = new THREE.Box3().setFromPoints([...points]);
      const target = box.getCenter(new THREE.Vector3()).setZ(0);
      this.moveTo(this.straightOn(target, Math.max(FLAT_HEIGHT_MIN, frameFlat(box, area, FOV))), animated);
      return;
    }
    const from = animated ? this.direction() : initialDirection(this.width / this.height);
    this.moveTo({ ...framePoints(points, from, area, FRAME_DISTANCE_MIN, FRAME_DISTANCE_MAX), halfHeight: 0 }, animated);
  }

  /** Shows a body of this radius at the center. */
  focus(point: THREE.Vector3, radius: number): void {
    const distance = Math.max(FOCUS_DISTANCE_MIN, FOCUS_RADII * radius);
    const target = point.clone();
    if (this.planar) return this.moveTo(this.straightOn(target.setZ(0), Math.max(FLAT_HEIGHT_MIN, distance / 2)), true);
    this.moveTo({ target, position: target.clone().addScaledVector(this.direction(), distance), halfHeight: 0 }, true);
  }

  /** The view that a scene defines: points in m, `fov`: vertical field of view in degrees; 0: default. */
  setView(eye: THREE.Vector3, target: THREE.Vector3, fov: number): void {
    const verticalFov = fov > 0 ? fov : FOV;
    if (this.planar) {
      const halfHeight = eye.distanceTo(target) * Math.tan((verticalFov * Math.PI) / 360);
      return this.moveTo(this.straightOn(target.clone().setZ(0), halfHeight), false);
    }
    this.perspective.fov = verticalFov;
    const position = eye.clone().sub(target).multiplyScalar(narrowDistance(this.width / this.height)).add(target);
    this.moveTo({ position, target: target.clone(), halfHeight: 0 }, false);
    this.applyProjection();
  }

  /** Panels cover other borders than before. */
  setInsets(insets: Insets): void {
    this.insets = insets;
  }

  /** Call once per rendered frame. */
  update(seconds: number): void {
    this.advanceMove(seconds);
    const area = this.freeArea();
    const share = 1 - Math.exp(-OFFSET_RATE * seconds);
    const before = this.offset.clone();
    this.offset.lerp(new THREE.Vector2(-area.offsetX, -area.offsetY), share);
    if (this.offset.distanceToSquared(before) > 1e-4) this.applyProjection();
    this.controls.update();
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    const area = this.freeArea();
    this.offset.set(-area.offsetX, -area.offsetY);
    this.applyProjection();
  }

  /** Turns, pans and zooms by a key of the focused view; returns whether the key has an effect. */
  key(code: string): boolean {
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const turn = arrows[code];
    if (turn) this.turn(turn[0], turn[1]);
    else if (code === 'Equal' || code === 'NumpadAdd') this.zoom(1 / KEY_ZOOM);
    else if (code === 'Minus' || code === 'NumpadSubtract') this.zoom(KEY_ZOOM);
    else return false;
    this.move = undefined;
    return true;
  }

  private turn(right: number, up: number): void {
    const { target } = this.controls;
    if (this.planar) {
      const step = new THREE.Vector3(right, up, 0).multiplyScalar(this.viewHeight * 0.04);
      target.add(step);
      this.flat.position.add(step);
      return;
    }
    const arm = new THREE.Spherical().setFromVector3(this.perspective.position.clone().sub(target));
    arm.theta += KEY_TURN * right;
    arm.phi = Math.min(this.controls.maxPolarAngle, Math.max(0.05, arm.phi - KEY_TURN * up));
    this.perspective.position.copy(target).add(new THREE.Vector3().setFromSpherical(arm));
  }

  private zoom(factor: number): void {
    if (this.planar) {
      this.flat.zoom /= factor;
      this.applyProjection();
    } else {
      this.perspective.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    }
  }

  /** Unit vector from the target to the camera. */
  private direction(): THREE.Vector3 {
    return this.perspective.position.clone().sub(this.controls.target).normalize();
  }

  private straightOn(target: THREE.Vector3, halfHeight: number): Pose {
    return { target, position: target.clone().addScaledVector(STRAIGHT, FLAT_DISTANCE), halfHeight };
  }

  private pose(): Pose {
    return { position: this.camera.position.clone(), target: this.controls.target.clone(), halfHeight: this.viewHeight / 2 };
  }

  private moveTo(to: Pose, animated: boolean): void {
    this.move = animated ? { from: this.pose(), to, seconds: 0 } : undefined;
    if (!animated) this.setPose(to);
  }

  private setPose({ position, target, halfHeight }: Pose): void {
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    if (!this.planar) return;
    this.halfHeight = halfHeight;
    this.flat.zoom = 1;
    this.applyProjection();
  }

  private advanceMove(seconds: number): void {
    if (!this.move) return;
    const { from, to } = this.move;
    this.move.seconds += seconds;
    const linear = Math.min(1, this.move.seconds / MOVE_S);
    const t = linear * linear * (3 - 2 * linear);
    const target = from.target.clone().lerp(to.target, t);
    // The distance changes evenly, so that the camera does not pass close to bodies.
    const arm = from.position.clone().sub(from.target).lerp(to.position.clone().sub(to.target), t);
    const halfHeight = from.halfHeight + t * (to.halfHeight - from.halfHeight);
    this.setPose({ target, position: target.clone().add(arm), halfHeight });
    if (linear === 1) this.move = undefined;
  }

  private freeArea(): FreeArea {
    return freeArea(this.width, this.height, this.perspective.fov, this.insets);
  }

  private applyProjection(): void {
    const { width, height, offset, flat, perspective } = this;
    const aspect = width / height;
    perspective.aspect = aspect;
    Object.assign(flat, { left: -aspect * this.halfHeight, right: aspect * this.halfHeight, top: this.halfHeight, bottom: -this.halfHeight });
    for (const camera of [perspective, flat]) {
      camera.setViewOffset(width, height, offset.x, offset.y, width, height);
      camera.updateProjectionMatrix();
    }
  }

  /** Approaches the followed entity to `distance` (m) during the next seconds. */
  startApproach(distance: number): void {
    this.move = undefined;
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
    if (this.planar) return;
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
    if (distance < arm && !this.planar) position.lerpVectors(target, saved, distance / arm);
    draw();
    position.copy(saved);
  }

  /** A ray through a point of the canvas, in pixels from its top left corner. */
  ray(x: number, y: number, width: number, height: number): THREE.Raycaster {
    const raycaster = new THREE.Raycaster();
    this.camera.updateMatrixWorld();
    raycaster.setFromCamera(new THREE.Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), this.camera);
    return raycaster;
  }
}

/** Unit vector from a scene to the camera. Tall views look down more steeply, which fills them. */
function initialDirection(aspect: number): THREE.Vector3 {
  const tallness = Math.min(1, Math.max(0, (1.4 - aspect) / 0.8));
  const slope = FROM_SLOPES[0] + tallness * (FROM_SLOPES[1] - FROM_SLOPES[0]);
  return new THREE.Vector3().setFromSphericalCoords(1, Math.PI / 2 - slope, FROM_AZIMUTH);
}
