// Pointer tools: drag, throw, spawn, explode, cut, delete, drive. Each turns clicks into inputs, which the
// server evaluates. The pressed body is looked up in the rendered scene, so that dragging starts
// immediately, and corrected by the server's response.

import * as THREE from 'three';
import type { Camera } from '../camera/camera';
import type { Connection, Input, Queries } from '@jostle/client';
import { Throttle } from './throttle';
import { pickPoints, type PointPick } from './pick_points';
import { pickFromServer, pickRendered, choosePick, type Pick } from './pick';
import type { SceneView } from '../scene/scene_view';

export type Tool = 'drag' | 'throw' | 'box' | 'sphere' | 'capsule' | 'explode' | 'cut' | 'delete' | 'drive';

export const TOOLS: { tool: Tool; key: string; label: string; hint: string }[] = [
  { tool: 'drag', key: '1', label: 'Drag', hint: 'Drag a body, a rope or cloth; drag the ground to turn the camera' },
  { tool: 'throw', key: '2', label: 'Throw', hint: 'Click to throw a ball from the camera' },
  { tool: 'box', key: '3', label: 'Box', hint: 'Click to place a box' },
  { tool: 'sphere', key: '4', label: 'Ball', hint: 'Click to place a ball' },
  { tool: 'capsule', key: '5', label: 'Capsule', hint: 'Click to place a capsule' },
  { tool: 'explode', key: '6', label: 'Explode', hint: 'Click to trigger an explosion' },
  { tool: 'delete', key: '7', label: 'Delete', hint: 'Click a body that you spawned to delete it' },
  { tool: 'drive', key: '8', label: 'Drive', hint: 'Click a controllable entity to drive it; Esc releases it' },
  { tool: 'cut', key: '9', label: 'Cut', hint: 'Click a rope or cloth to cut it' },
];

const THROW_SPEED = 18; // m/s
const BLAST_RADIUS = 6; // m
const CLICK_PIXELS = 6; // a pointer that moved less was clicked
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
  dragged?: boolean;
}

export class Tools {
  tool: Tool = 'drag';
  /** False: only hovering works. */
  enabled = true;
  private grabbed: { entity: number; plane: THREE.Plane } | undefined;
  private pressed: PointerPress | undefined;
  private hovering: PointerEvent | undefined;
  private readonly hover = new Throttle(HOVER_MS, () => this.updateHover());

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly camera: Camera,
    private readonly view: SceneView,
    private readonly connection: Connection,
    private readonly queries: Queries,
    /** Called with the body under the pointer. */
    private readonly onHover: (hit: Pick | undefined) => void,
    private readonly takeControl: (entity: number) => void,
    /** Called when an explosion starts. */
    private readonly onExplosion: (x: number, y: number, z: number, radius: number) => void,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.down(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', () => this.release());
    canvas.addEventListener('pointerleave', () => {
      this.hovering = undefined;
      this.onHover(undefined);
    });
  }

  private ray(event: PointerEvent): THREE.Raycaster {
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

  private down(event: PointerEvent): void {
    if (event.button !== 0 || !this.enabled) return;
    const { x, y } = { x: event.clientX, y: event.clientY };
    const raycaster = this.ray(event);
    if (this.tool === 'throw') {
      this.pressed = { x, y, raycaster, rendered: undefined, fromServer: Promise.resolve(undefined) };
      return;
    }
    const rendered = pickRendered(this.view, raycaster);
    const points = this.pointsBefore(rendered, raycaster);
    const fromServer = points ? Promise.resolve(undefined) : pickFromServer(this.queries, raycaster.ray, this.connection.renderedTime());
    const press: PointerPress = { x, y, raycaster, rendered, points, fromServer };
    this.pressed = press;
    if (this.tool !== 'drag') return;
    if (points) return this.grab(points.point, { case: 'grab', value: { object: points.object, point: xyz(points.point) } }, 0, event.pointerId);
    if (this.isDynamic(rendered)) this.grabBody(rendered, event.pointerId);
    void press.fromServer.then((fromServer) => this.replacePick(press, choosePick(rendered, fromServer, this.isMoving), event.pointerId));
  }

  /** The rope or cloth under the pointer, unless a body is in front of it. */
  private pointsBefore(rendered: Pick | undefined, raycaster: THREE.Raycaster): PointPick | undefined {
    const points = pickPoints(this.connection.points.objects, raycaster.ray);
    return points && points.distance < (rendered?.distance ?? Infinity) ? points : undefined;
  }

  private grabBody(hit: Pick, pointerId: number): void {
    this.grab(hit.point, { case: 'grab', value: { entity: hit.entity, point: xyz(hit.point) } }, hit.entity, pointerId);
  }

  private grab(point: THREE.Vector3, input: NonNullable<Input['kind']>, entity: number, pointerId: number): void {
    this.camera.controls.enabled = false; // the pointer now moves the body instead of the camera
    const direction = this.camera.camera.getWorldDirection(new THREE.Vector3());
    this.grabbed = {
      entity,
      plane: new THREE.Plane().setFromNormalAndCoplanarPoint(direction, point),
    };
    this.canvas.setPointerCapture(pointerId);
    this.send(input);
    this.send({ case: 'drag', value: { target: xyz(point) } });
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
    if (from && Math.hypot(event.clientX - from.x, event.clientY - from.y) > CLICK_PIXELS) from.dragged = true;
    if (!this.grabbed) {
      if (event.buttons !== 0) return;
      this.hovering = event;
      this.hover.request();
      return;
    }
    const target = this.ray(event).ray.intersectPlane(this.grabbed.plane, new THREE.Vector3());
    if (!target) return;
    target.y = Math.max(0.05, target.y);
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
    this.onHover(hit);
  }

  private up(event: PointerEvent): void {
    if (this.grabbed) return this.release();
    const press = this.pressed;
    this.pressed = undefined;
    if (!press || Math.hypot(event.clientX - press.x, event.clientY - press.y) > CLICK_PIXELS) return;
    if (this.tool === 'throw') this.throwBall(press.raycaster);
    else if (this.tool !== 'drag') void this.click(press, this.tool);
  }

  private release(): void {
    this.pressed = undefined;
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
    const hit = choosePick(press.rendered, await withTimeout(press.fromServer), this.isMoving);
    if (!hit) return;
    switch (tool) {
      case 'box':
        return this.spawn(hit, 0.35, {
          case: 'box',
          value: { halfExtents: { x: 0.35, y: 0.35, z: 0.35 } },
        });
      case 'sphere':
        return this.spawn(hit, 0.35, { case: 'sphere', value: { radius: 0.35 } });
      case 'capsule':
        return this.spawn(hit, 0.6, { case: 'capsule', value: { radius: 0.22, halfLength: 0.35 } });
      case 'explode':
        return this.explode(hit.point);
      case 'delete':
        return this.send({ case: 'delete', value: { entity: hit.entity } });
      case 'drive':
        return this.takeControl(hit.entity);
    }
  }

  private explode(point: THREE.Vector3): void {
    this.onExplosion(...point.toArray(), BLAST_RADIUS);
    this.send({ case: 'explode', value: { center: xyz(point), radius: BLAST_RADIUS, speed: 12 } });
  }

  private spawn(
    hit: Pick,
    reach: number,
    kind: NonNullable<NonNullable<Extract<Input['kind'], { case: 'spawn' }>['value']>['shape']>['kind'],
  ): void {
    const position = hit.point.clone().addScaledVector(hit.normal, reach + 0.02);
    this.send({ case: 'spawn', value: { shape: { kind: kind! }, position: xyz(position) } });
  }

  private throwBall(raycaster: THREE.Raycaster): void {
    const { origin, direction } = raycaster.ray;
    const position = origin.clone().addScaledVector(direction, 1);
    this.send({
      case: 'spawn',
      value: {
        shape: { kind: { case: 'sphere', value: { radius: 0.3 } } },
        position: xyz(position),
        linearVelocity: xyz(direction.clone().multiplyScalar(THROW_SPEED)),
      },
    });
  }
}
