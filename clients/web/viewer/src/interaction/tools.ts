// Pointer tools: drag, throw, spawn, explode, cut, delete, drive. Each turns clicks into inputs, which the
// server evaluates. The pressed body is looked up in the rendered scene, so that dragging starts
// immediately, and corrected by the server's response. A second finger ends what the first one did and
// moves the camera. A right click or a long press asks for a menu.

import * as THREE from 'three';
import type { Camera } from '../camera/camera';
import type { Connection, Input, Queries } from '@jostle/client';
import { Throttle } from './throttle';
import { pickPoints, type PointPick } from './pick_points';
import { spawnTemplate, type SpawnKind, type SpawnOptions } from '../sandbox/spawn_options';
import { pickFromServer, pickRendered, choosePick, type Pick } from './pick';
import type { SceneView } from '../scene/scene_view';
import type { Action } from '../room/room_rules';
import type { ToolDefinition } from '../ui/toolbar';

export type Tool = 'drag' | 'throw' | 'box' | 'sphere' | 'capsule' | 'explode' | 'cut' | 'delete' | 'drive' | 'joint' | 'inspect';

export const TOOLS: readonly ToolDefinition<Tool>[] = [
  { tool: 'drag', key: '1', label: 'Drag', hint: 'Drag a body, a rope or cloth; drag the ground to turn the camera', icon: 'drag' },
  { tool: 'throw', key: '2', label: 'Throw', hint: 'Click to throw a ball from the camera', icon: 'throw' },
  { tool: 'box', key: '3', label: 'Box', hint: 'Click to place a box', icon: 'box' },
  { tool: 'sphere', key: '4', label: 'Ball', hint: 'Click to place a ball', icon: 'sphere' },
  { tool: 'capsule', key: '5', label: 'Capsule', hint: 'Click to place a capsule', icon: 'capsule' },
  { tool: 'explode', key: '6', label: 'Explode', hint: 'Click to trigger an explosion', icon: 'explode' },
  { tool: 'delete', key: '7', label: 'Delete', hint: 'Click a body that you spawned to delete it', icon: 'delete' },
  { tool: 'drive', key: '8', label: 'Drive', hint: 'Click a controllable entity to drive it; Esc releases it', icon: 'drive' },
  { tool: 'cut', key: '9', label: 'Cut', hint: 'Click a rope or cloth to cut it', icon: 'cut' },
  { tool: 'joint', key: 'j', label: 'Joint', hint: 'Click two points to join their bodies; Build chooses the kind', icon: 'joint' },
  { tool: 'inspect', key: '0', label: 'Inspect', hint: 'Click a body or a joint to inspect it', icon: 'inspect' },
];

/** The action that each tool needs; those without one are always allowed. */
export const TOOL_ACTIONS: Partial<Record<Tool, Action>> = {
  drag: 'drag',
  throw: 'spawn',
  box: 'spawn',
  sphere: 'spawn',
  capsule: 'spawn',
  explode: 'explode',
  delete: 'delete',
  drive: 'control',
  cut: 'joints',
  joint: 'joints',
};

const THROW_SPEED = 18; // m/s
const THROWN_RADIUS = 0.3; // m
const BLAST_RADIUS = 6; // m
const CLICK_PIXELS = 6; // a pointer that moved less was clicked
const TOUCH_PIXELS = 12; // likewise, of a finger
const LONG_PRESS_MS = 550;
const SERVER_TIMEOUT_MS = 150; // for the server's response to a click or a hover; then the rendered result counts
const HOVER_MS = 100;

const xyz = (v: THREE.Vector3) => ({ x: v.x, y: v.y, z: v.z });

function withTimeout<T>(fromServer: Promise<T>): Promise<T | undefined> {
  return Promise.race([fromServer, new Promise<undefined>((done) => setTimeout(() => done(undefined), SERVER_TIMEOUT_MS))]);
}

interface PointerPress {
  readonly x: number;
  readonly y: number;
  readonly raycaster: THREE.Raycaster;
  readonly rendered: Pick | undefined;
  /** A rope or cloth in front of `rendered`. */
  readonly points?: PointPick | undefined;
  readonly fromServer: ReturnType<typeof pickFromServer>;
  readonly touch: boolean;
  dragged?: boolean;
}

/** The end of a grab that follows the pointer. */
export interface Grab {
  readonly entity: number; // 0: a rope or cloth
  /** The grabbed point in the frame of the entity; of a rope or cloth, in the world at the start. */
  readonly point: THREE.Vector3;
  readonly target: THREE.Vector3;
}

export interface ToolsOptions {
  readonly canvas: HTMLCanvasElement;
  readonly camera: Camera;
  readonly view: SceneView;
  readonly connection: Connection;
  readonly queries: Queries;
  /** Called with the body under the pointer. */
  onHover(hit: Pick | undefined): void;
  takeControl(entity: number): void;
  readonly spawnOptions: SpawnOptions;
  /** A click of the tools for joints and of the inspector. */
  onSandboxClick(tool: 'joint' | 'inspect', hit: Pick | undefined, ray: THREE.Ray): void;
  /** Called when an explosion starts. */
  onExplosion(x: number, y: number, z: number, radius: number): void;
  /** Called when a body is spawned, before the server adds it. */
  onSpawn(position: THREE.Vector3, radius: number): void;
  /** A right click or a long press at a point of the page. */
  onMenu(hit: Pick | undefined, x: number, y: number): void;
  /** A double click. */
  onFocus(hit: Pick | undefined): void;
}

export class Tools {
  tool: Tool = 'drag';
  /** False: only hovering works. */
  enabled = true;
  private grabbed: { entity: number; plane: THREE.Plane; point: THREE.Vector3; target: THREE.Vector3 } | undefined;
  private pressed: PointerPress | undefined;
  private longPress: { timer: ReturnType<typeof setTimeout>; x: number; y: number } | undefined;
  private readonly fingers = new Map<number, PointerEvent>(); // their last events
  private hovering: PointerEvent | undefined;
  private rightPress: { x: number; y: number } | undefined;
  private readonly hover = new Throttle(HOVER_MS, () => this.updateHover());

  private readonly canvas: HTMLCanvasElement;
  private readonly camera: Camera;
  private readonly view: SceneView;
  private readonly connection: Connection;
  private readonly queries: Queries;

  constructor(private readonly options: ToolsOptions) {
    const { canvas, camera, view, connection, queries } = options;
    [this.canvas, this.camera, this.view, this.connection, this.queries] = [canvas, camera, view, connection, queries];
    canvas.addEventListener('pointerdown', (event) => this.pointerDown(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.pointerUp(event));
    canvas.addEventListener('pointercancel', (event) => {
      this.fingers.delete(event.pointerId);
      this.release();
    });
    canvas.addEventListener('pointerleave', () => {
      this.hovering = undefined;
      options.onHover(undefined);
    });
    canvas.addEventListener('dblclick', (event) => {
      if (this.tool === 'drag' || !this.enabled) options.onFocus(pickRendered(view, this.ray(event)));
    });
  }

  /** What this client grabs; undefined: nothing. */
  get grab(): Grab | undefined {
    return this.grabbed;
  }

  private ray(event: MouseEvent): THREE.Raycaster {
    const box = this.canvas.getBoundingClientRect();
    return this.camera.ray(event.clientX - box.left, event.clientY - box.top, box.width, box.height);
  }

  private send(kind: NonNullable<Input['kind']>): void {
    this.connection.send({ kind });
  }

  private isDynamic(hit: Pick | undefined): hit is Pick {
    return hit !== undefined && (this.connection.entities.get(hit.entity)?.mass ?? 0) > 0;
  }

  private readonly isMoving = (entity: number): boolean =>
    this.connection.frames.newest?.entities.find((state) => state.id === entity)?.atRest === false;

  private pointerDown(event: PointerEvent): void {
    if (event.button === 2) this.rightPress = { x: event.clientX, y: event.clientY };
    if (event.pointerType === 'touch' && event.isTrusted) {
      const first = [...this.fingers.values()][0];
      this.fingers.set(event.pointerId, event);
      if (first) return this.startGesture(first);
    }
    if (event.isTrusted) this.down(event);
  }

  /** Two fingers move the camera, which does not know the first one if it grabbed something. */
  private startGesture(first: PointerEvent): void {
    const grabbed = this.grabbed !== undefined;
    this.release();
    if (!grabbed) return;
    const { pointerId, clientX, clientY } = first;
    this.canvas.dispatchEvent(new PointerEvent('pointerdown', { pointerId, clientX, clientY, pointerType: 'touch', bubbles: true }));
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const { clientX: x, clientY: y } = event;
    const touch = event.pointerType === 'touch';
    const raycaster = this.ray(event);
    if (touch) this.startLongPress(raycaster, x, y);
    if (!this.enabled) return;
    if (this.tool === 'throw') {
      this.pressed = { x, y, raycaster, touch, rendered: undefined, fromServer: Promise.resolve(undefined) };
      return;
    }
    const rendered = pickRendered(this.view, raycaster);
    const points = this.pointsBefore(rendered, raycaster);
    const fromServer = points ? Promise.resolve(undefined) : pickFromServer(this.queries, raycaster.ray, this.connection.renderedTime());
    const press: PointerPress = { x, y, raycaster, touch, rendered, points, fromServer };
    this.pressed = press;
    if (this.tool !== 'drag') return;
    if (points) return this.startGrab(points.point, { case: 'grab', value: { object: points.object, point: xyz(points.point) } }, 0, event.pointerId);
    if (this.isDynamic(rendered)) this.grabBody(rendered, event.pointerId);
    void press.fromServer.then((fromServer) => this.replacePick(press, choosePick(rendered, fromServer, this.isMoving), event.pointerId));
  }

  private startLongPress(raycaster: THREE.Raycaster, x: number, y: number): void {
    this.stopLongPress();
    const timer = setTimeout(() => {
      this.longPress = undefined;
      this.release();
      this.options.onMenu(pickRendered(this.view, raycaster), x, y);
    }, LONG_PRESS_MS);
    this.longPress = { timer, x, y };
  }

  /** The rope or cloth under the pointer, unless a body is in front of it. */
  private pointsBefore(rendered: Pick | undefined, raycaster: THREE.Raycaster): PointPick | undefined {
    const points = pickPoints(this.connection.points.objects, raycaster.ray);
    return points && points.distance < (rendered?.distance ?? Infinity) ? points : undefined;
  }

  private grabBody(hit: Pick, pointerId: number): void {
    this.startGrab(hit.point, { case: 'grab', value: { entity: hit.entity, point: xyz(hit.point) } }, hit.entity, pointerId);
  }

  private startGrab(point: THREE.Vector3, input: NonNullable<Input['kind']>, entity: number, pointerId: number): void {
    this.camera.controls.enabled = false; // the pointer now moves the body instead of the camera
    const direction = this.camera.camera.getWorldDirection(new THREE.Vector3());
    this.grabbed = {
      entity,
      plane: new THREE.Plane().setFromNormalAndCoplanarPoint(direction, point),
      point: this.inFrameOf(entity, point),
      target: point.clone(),
    };
    this.canvas.setPointerCapture(pointerId);
    this.send(input);
    this.send({ case: 'drag', value: { target: xyz(point) } });
  }

  /** A point of the world in the frame of an entity. */
  private inFrameOf(entity: number, point: THREE.Vector3): THREE.Vector3 {
    const pose = this.view.poseOf(entity);
    if (!pose) return point.clone();
    const turnBack = new THREE.Quaternion(pose[3], pose[4], pose[5], pose[6]).conjugate();
    return point.clone().sub(new THREE.Vector3(pose[0], pose[1], pose[2])).applyQuaternion(turnBack);
  }

  /** The server responded; mostly with the rendered result. */
  private replacePick(press: PointerPress, hit: Pick | undefined, pointerId: number): void {
    if (this.pressed !== press || press.points || this.grabbed?.entity === hit?.entity) return;
    if (this.grabbed) this.dropGrab();
    // A pointer that already turns the camera does not grab a body.
    else if (press.dragged) return;
    if (this.isDynamic(hit)) this.grabBody(hit, pointerId);
  }

  private move(event: PointerEvent): void {
    const from = this.pressed;
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, event);
    if (from && this.hasMoved(from, event)) from.dragged = true;
    if (this.longPress && Math.hypot(event.clientX - this.longPress.x, event.clientY - this.longPress.y) > TOUCH_PIXELS) this.stopLongPress();
    if (!this.grabbed) {
      if (event.buttons !== 0 || event.pointerType === 'touch') return;
      this.hovering = event;
      this.hover.request();
      return;
    }
    const target = this.ray(event).ray.intersectPlane(this.grabbed.plane, new THREE.Vector3());
    if (!target) return;
    if (!this.camera.planar) target.y = Math.max(0.05, target.y);
    this.grabbed.target.copy(target);
    this.send({ case: 'drag', value: { target: xyz(target) } });
  }

  private async updateHover(): Promise<void> {
    const event = this.hovering;
    if (!event) return;
    const raycaster = this.ray(event);
    const rendered = pickRendered(this.view, raycaster);
    const points = this.pointsBefore(rendered, raycaster);
    const hit = choosePick(rendered, await withTimeout(pickFromServer(this.queries, raycaster.ray, this.connection.renderedTime())), this.isMoving);
    if (!this.hovering) return; // the pointer left meanwhile
    if (this.tool === 'drag') this.canvas.style.cursor = points || this.isDynamic(hit) ? 'grab' : '';
    this.options.onHover(hit);
  }

  private hasMoved(from: PointerPress, event: PointerEvent): boolean {
    return Math.hypot(event.clientX - from.x, event.clientY - from.y) > (from.touch ? TOUCH_PIXELS : CLICK_PIXELS);
  }

  private stopLongPress(): void {
    clearTimeout(this.longPress?.timer);
    this.longPress = undefined;
  }

  private pointerUp(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.stopLongPress();
    if (event.button === 2) return this.rightUp(event);
    this.up(event);
  }

  private rightUp(event: PointerEvent): void {
    const from = this.rightPress;
    this.rightPress = undefined;
    if (!from || Math.hypot(event.clientX - from.x, event.clientY - from.y) > CLICK_PIXELS) return;
    this.options.onMenu(pickRendered(this.view, this.ray(event)), event.clientX, event.clientY);
  }

  private up(event: PointerEvent): void {
    if (this.grabbed) return this.release();
    const press = this.pressed;
    this.pressed = undefined;
    if (!press || this.hasMoved(press, event)) return;
    if (this.tool === 'throw') this.throwBall(press.raycaster);
    else if (this.tool !== 'drag') void this.click(press, this.tool);
  }

  private release(): void {
    this.pressed = undefined;
    this.stopLongPress();
    if (this.grabbed) this.dropGrab();
  }

  private dropGrab(): void {
    this.grabbed = undefined;
    this.camera.controls.enabled = true;
    this.send({ case: 'release', value: {} });
  }

  private async click(press: PointerPress, tool: Tool): Promise<void> {
    if (press.points && tool === 'cut') return this.send({ case: 'cut', value: { object: press.points.object, point: xyz(press.points.point) } });
    if (press.points && tool === 'explode') return this.explode(press.points.point);
    const hit = choosePick(press.rendered, await withTimeout(press.fromServer), this.isMoving) ?? this.planarHit(press.raycaster);
    if (tool === 'inspect' || (tool === 'joint' && hit)) return this.options.onSandboxClick(tool, hit, press.raycaster.ray);
    if (!hit) return;
    switch (tool) {
      case 'box':
      case 'sphere':
      case 'capsule':
        return this.spawn(hit, tool);
      case 'explode':
        return this.explode(hit.point);
      case 'delete':
        if (hit.entity === 0) return;
        return this.send({ case: 'delete', value: { entity: hit.entity } });
      case 'drive':
        if (hit.entity === 0) return;
        return this.options.takeControl(hit.entity);
    }
  }

  /** In a planar world, a click beside all bodies hits the plane. */
  private planarHit({ ray }: THREE.Raycaster): Pick | undefined {
    const point = this.camera.planar ? ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1), 0), new THREE.Vector3()) : null;
    return point ? { entity: 0, shape: 0, point, normal: new THREE.Vector3(0, 0, 0), distance: point.distanceTo(ray.origin) } : undefined;
  }

  private explode(point: THREE.Vector3): void {
    if (this.camera.planar) point.z = 0;
    this.options.onExplosion(...point.toArray(), BLAST_RADIUS);
    this.send({ case: 'explode', value: { center: xyz(point), radius: BLAST_RADIUS, speed: 12 } });
  }

  private spawn(hit: Pick, kind: SpawnKind): void {
    const { shape, color, reach } = spawnTemplate(kind, this.options.spawnOptions);
    const position = hit.point.clone().addScaledVector(hit.normal, reach + 0.02);
    if (this.camera.planar) position.z = 0;
    this.options.onSpawn(position, reach);
    this.send({ case: 'spawn', value: { shape, position: xyz(position), ...(color === undefined ? {} : { color }) } });
  }

  private throwBall(raycaster: THREE.Raycaster): void {
    const { origin, direction } = raycaster.ray;
    const position = origin.clone().addScaledVector(direction, 1);
    const velocity = direction.clone().multiplyScalar(THROW_SPEED);
    const planar = this.planarHit(raycaster);
    if (planar) {
      // Thrown into the plane from the side of the target of the camera.
      position.copy(planar.point);
      velocity.set(THROW_SPEED * Math.sign(this.camera.controls.target.x - position.x || 1), 0, 0);
    }
    this.options.onSpawn(position, THROWN_RADIUS);
    this.send({
      case: 'spawn',
      value: {
        shape: { kind: { case: 'sphere', value: { radius: THROWN_RADIUS } } },
        position: xyz(position),
        linearVelocity: xyz(velocity),
      },
    });
  }
}
