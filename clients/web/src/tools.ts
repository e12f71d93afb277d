// What the pointer does: drag bodies, throw, spawn, explode, delete. Each tool turns a click into inputs; the server decides.

import * as THREE from 'three';
import type { Camera } from './camera';
import type { Connection, Input } from './connection';
import { pick, type Pick } from './pick';
import type { SceneView } from './scene_view';

export type Tool = 'drag' | 'throw' | 'box' | 'sphere' | 'capsule' | 'explode' | 'delete';

export const TOOLS: { tool: Tool; key: string; label: string; hint: string }[] = [
  { tool: 'drag', key: '1', label: 'Drag', hint: 'Take a body and pull it about; drag the ground to look around' },
  { tool: 'throw', key: '2', label: 'Throw', hint: 'Click to throw a ball from where you stand' },
  { tool: 'box', key: '3', label: 'Box', hint: 'Click to put a box there' },
  { tool: 'sphere', key: '4', label: 'Ball', hint: 'Click to put a ball there' },
  { tool: 'capsule', key: '5', label: 'Capsule', hint: 'Click to put a capsule there' },
  { tool: 'explode', key: '6', label: 'Explode', hint: 'Click to blow things away' },
  { tool: 'delete', key: '7', label: 'Delete', hint: 'Click one of your own bodies to take it away' },
];

const THROW_SPEED = 18; // m/s
const CLICK_PIXELS = 6; // a pointer that moved less was a click

const xyz = (v: THREE.Vector3) => ({ x: v.x, y: v.y, z: v.z });

export class Tools {
  tool: Tool = 'drag';
  private held: { entity: number; plane: THREE.Plane } | undefined;
  private pressed: { x: number; y: number } | undefined;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly camera: Camera,
    private readonly view: SceneView,
    private readonly connection: Connection,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.down(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', () => this.release());
  }

  private ray(event: PointerEvent): THREE.Raycaster {
    const box = this.canvas.getBoundingClientRect();
    return this.camera.ray(event.clientX - box.left, event.clientY - box.top, box.width, box.height);
  }

  private send(kind: NonNullable<Input['kind']>): void {
    this.connection.send({ kind });
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.pressed = { x: event.clientX, y: event.clientY };
    if (this.tool !== 'drag') return;
    const hit = pick(this.view, this.ray(event));
    if (!hit || (this.connection.entities.get(hit.entity)?.mass ?? 0) <= 0) return;
    this.camera.controls.enabled = false; // the pointer moves the body now, not the camera
    const towards = this.camera.camera.getWorldDirection(new THREE.Vector3());
    this.held = {
      entity: hit.entity,
      plane: new THREE.Plane().setFromNormalAndCoplanarPoint(towards, hit.point),
    };
    this.canvas.setPointerCapture(event.pointerId);
    this.send({ case: 'grab', value: { entity: hit.entity, point: xyz(hit.point) } });
    this.send({ case: 'drag', value: { target: xyz(hit.point) } });
  }

  private move(event: PointerEvent): void {
    if (!this.held) {
      if (this.tool === 'drag' && event.buttons === 0) this.showHover(event);
      return;
    }
    const target = this.ray(event).ray.intersectPlane(this.held.plane, new THREE.Vector3());
    if (!target) return;
    target.y = Math.max(0.05, target.y);
    this.send({ case: 'drag', value: { target: xyz(target) } });
  }

  private showHover(event: PointerEvent): void {
    const hit = pick(this.view, this.ray(event));
    const loose = hit && (this.connection.entities.get(hit.entity)?.mass ?? 0) > 0;
    this.canvas.style.cursor = loose ? 'grab' : '';
  }

  private up(event: PointerEvent): void {
    if (this.held) return this.release();
    const from = this.pressed;
    this.pressed = undefined;
    if (!from || Math.hypot(event.clientX - from.x, event.clientY - from.y) > CLICK_PIXELS) return;
    this.click(event);
  }

  private release(): void {
    this.pressed = undefined;
    if (!this.held) return;
    this.held = undefined;
    this.camera.controls.enabled = true;
    this.send({ case: 'release', value: {} });
  }

  private click(event: PointerEvent): void {
    const raycaster = this.ray(event);
    if (this.tool === 'throw') return this.throwBall(raycaster);
    const hit = pick(this.view, raycaster);
    if (!hit) return;
    switch (this.tool) {
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
        return this.send({ case: 'explode', value: { center: xyz(hit.point), radius: 6, speed: 12 } });
      case 'delete':
        return this.send({ case: 'delete', value: { entity: hit.entity } });
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
