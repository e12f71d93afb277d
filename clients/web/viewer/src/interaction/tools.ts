// What the pointer does: drag bodies, throw, spawn, explode, delete. Each tool turns a click into inputs; the server decides. What
// was pressed is looked up in the drawing at once, so that dragging starts without lag, and put right by the server's answer.

import * as THREE from 'three';
import type { Camera } from '../camera/camera';
import type { Connection, Input, Queries } from '@jostle/client';
import { Throttle } from './throttle';
import { pickFromServer, pickRendered, choosePick, type Pick } from './pick';
import type { SceneView } from '../scene/scene_view';

export type Tool = 'drag' | 'throw' | 'box' | 'sphere' | 'capsule' | 'explode' | 'delete' | 'drive';

export const TOOLS: { tool: Tool; key: string; label: string; hint: string }[] = [
  { tool: 'drag', key: '1', label: 'Drag', hint: 'Take a body and pull it about; drag the ground to look around' },
  { tool: 'throw', key: '2', label: 'Throw', hint: 'Click to throw a ball from where you stand' },
  { tool: 'box', key: '3', label: 'Box', hint: 'Click to put a box there' },
  { tool: 'sphere', key: '4', label: 'Ball', hint: 'Click to put a ball there' },
  { tool: 'capsule', key: '5', label: 'Capsule', hint: 'Click to put a capsule there' },
  { tool: 'explode', key: '6', label: 'Explode', hint: 'Click to blow things away' },
  { tool: 'delete', key: '7', label: 'Delete', hint: 'Click one of your own bodies to take it away' },
  { tool: 'drive', key: '8', label: 'Drive', hint: 'Click what can be driven to take its wheel; Esc lets go' },
];

const THROW_SPEED = 18; // m/s
const BLAST_RADIUS = 6; // m
const CLICK_PIXELS = 6; // a pointer that moved less was a click
const SERVER_TIMEOUT_MS = 150; // for the server's answer, after a click and while hovering; then what is drawn counts
const HOVER_MS = 100;

const xyz = (v: THREE.Vector3) => ({ x: v.x, y: v.y, z: v.z });

function withTimeout<T>(fromServer: Promise<T>): Promise<T | undefined> {
  return Promise.race([fromServer, new Promise<undefined>((done) => setTimeout(() => done(undefined), SERVER_TIMEOUT_MS))]);
}

interface PointerPress {
  readonly x: number;
  readonly y: number;
  readonly raycaster: THREE.Raycaster;
  readonly drawn: Pick | undefined;
  readonly fromServer: ReturnType<typeof pickFromServer>;
  movedAway?: boolean;
}

export class Tools {
  tool: Tool = 'drag';
  /** False: it only tells what is under the pointer. */
  enabled = true;
  private held: { entity: number; plane: THREE.Plane } | undefined;
  private pressed: PointerPress | undefined;
  private hovering: PointerEvent | undefined;
  private readonly hover = new Throttle(HOVER_MS, () => this.lookUnderPointer());

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly camera: Camera,
    private readonly view: SceneView,
    private readonly connection: Connection,
    private readonly queries: Queries,
    /** What is under the pointer now. */
    private readonly over: (hit: Pick | undefined) => void,
    private readonly takeControl: (entity: number) => void,
    /** Something goes off. */
    private readonly flash: (x: number, y: number, z: number, radius: number) => void,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.down(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', () => this.release());
    canvas.addEventListener('pointerleave', () => {
      this.hovering = undefined;
      this.over(undefined);
    });
  }

  private ray(event: PointerEvent): THREE.Raycaster {
    const box = this.canvas.getBoundingClientRect();
    return this.camera.ray(event.clientX - box.left, event.clientY - box.top, box.width, box.height);
  }

  private send(kind: NonNullable<Input['kind']>): void {
    this.connection.send({ kind });
  }

  private isLoose(hit: Pick | undefined): hit is Pick {
    return hit !== undefined && (this.connection.entities.get(hit.entity)?.mass ?? 0) > 0;
  }

  private readonly moves = (entity: number): boolean =>
    this.connection.frames.newest?.entities.find((state) => state.id === entity)?.atRest === false;

  private down(event: PointerEvent): void {
    if (event.button !== 0 || !this.enabled) return;
    const { x, y } = { x: event.clientX, y: event.clientY };
    const raycaster = this.ray(event);
    if (this.tool === 'throw') {
      this.pressed = { x, y, raycaster, drawn: undefined, fromServer: Promise.resolve(undefined) };
      return;
    }
    const drawn = pickRendered(this.view, raycaster);
    const press: PointerPress = { x, y, raycaster, drawn, fromServer: pickFromServer(this.queries, raycaster.ray, this.connection.renderedTime()) };
    this.pressed = press;
    if (this.tool !== 'drag') return;
    if (this.isLoose(drawn)) this.take(drawn, event.pointerId);
    void press.fromServer.then((fromServer) => this.replacePick(press, choosePick(drawn, fromServer, this.moves), event.pointerId));
  }

  private take(hit: Pick, pointerId: number): void {
    this.camera.controls.enabled = false; // the pointer moves the body now, not the camera
    const towards = this.camera.camera.getWorldDirection(new THREE.Vector3());
    this.held = {
      entity: hit.entity,
      plane: new THREE.Plane().setFromNormalAndCoplanarPoint(towards, hit.point),
    };
    this.canvas.setPointerCapture(pointerId);
    this.send({ case: 'grab', value: { entity: hit.entity, point: xyz(hit.point) } });
    this.send({ case: 'drag', value: { target: xyz(hit.point) } });
  }

  /** The server answered; most often what the drawing said. */
  private replacePick(press: PointerPress, hit: Pick | undefined, pointerId: number): void {
    if (this.pressed !== press || this.held?.entity === hit?.entity) return;
    if (this.held) this.dropGrab();
    // Who is looking around by now is not given a body.
    else if (press.movedAway) return;
    if (this.isLoose(hit)) this.take(hit, pointerId);
  }

  private move(event: PointerEvent): void {
    const from = this.pressed;
    if (from && Math.hypot(event.clientX - from.x, event.clientY - from.y) > CLICK_PIXELS) from.movedAway = true;
    if (!this.held) {
      if (event.buttons !== 0) return;
      this.hovering = event;
      this.hover.request();
      return;
    }
    const target = this.ray(event).ray.intersectPlane(this.held.plane, new THREE.Vector3());
    if (!target) return;
    target.y = Math.max(0.05, target.y);
    this.send({ case: 'drag', value: { target: xyz(target) } });
  }

  private async lookUnderPointer(): Promise<void> {
    const event = this.hovering;
    if (!event) return;
    const raycaster = this.ray(event);
    const drawn = pickRendered(this.view, raycaster);
    const hit = choosePick(drawn, await withTimeout(pickFromServer(this.queries, raycaster.ray, this.connection.renderedTime())), this.moves);
    if (!this.hovering) return; // the pointer left in the meantime
    if (this.tool === 'drag') this.canvas.style.cursor = this.isLoose(hit) ? 'grab' : '';
    this.over(hit);
  }

  private up(event: PointerEvent): void {
    if (this.held) return this.release();
    const press = this.pressed;
    this.pressed = undefined;
    if (!press || Math.hypot(event.clientX - press.x, event.clientY - press.y) > CLICK_PIXELS) return;
    if (this.tool === 'throw') this.throwBall(press.raycaster);
    else if (this.tool !== 'drag') void this.click(press, this.tool);
  }

  private release(): void {
    this.pressed = undefined;
    if (this.held) this.dropGrab();
  }

  private dropGrab(): void {
    this.held = undefined;
    this.camera.controls.enabled = true;
    this.send({ case: 'release', value: {} });
  }

  private async click(press: PointerPress, tool: Tool): Promise<void> {
    const hit = choosePick(press.drawn, await withTimeout(press.fromServer), this.moves);
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
        this.flash(...hit.point.toArray(), BLAST_RADIUS);
        return this.send({ case: 'explode', value: { center: xyz(hit.point), radius: BLAST_RADIUS, speed: 12 } });
      case 'delete':
        return this.send({ case: 'delete', value: { entity: hit.entity } });
      case 'drive':
        return this.takeControl(hit.entity);
    }
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
