// Bodies to instanced meshes: one mesh per kind of part, one instance per part of a body. Each frame only the matrices of
// parts whose body moved are written; nothing is allocated.

import * as THREE from 'three';
import { BodyType, type Shape } from './gen/jostle/v1/scene_pb';
import type { Entity } from './gen/jostle/v1/play_pb';
import { POSE_FLOATS } from './frame_buffer';
import type { DrawnPoses } from './interpolate';

type Kind = 'box' | 'sphere' | 'cylinder' | 'plane';

interface Part {
  kind: Kind;
  instance: number;
  entity: number;
  local: THREE.Matrix4;
}

const GEOMETRIES: Record<Kind, () => THREE.BufferGeometry> = {
  box: () => new THREE.BoxGeometry(2, 2, 2),
  sphere: () => new THREE.SphereGeometry(1, 28, 18),
  cylinder: () => new THREE.CylinderGeometry(1, 1, 2, 28, 1, true),
  plane: () => new THREE.PlaneGeometry(2, 2).rotateX(-Math.PI / 2),
};

const PALETTE = [0x5b8def, 0xe07a5f, 0xf2cc8f, 0x81b29a, 0xb388eb, 0xef8354];
const FIXED_COLOR = 0x59636e;
const ASLEEP_SHADE = 0.72;

const vector = new THREE.Vector3();
const quaternion = new THREE.Quaternion();
const one = new THREE.Vector3(1, 1, 1);
const matrix = new THREE.Matrix4();
const color = new THREE.Color();

function localOf(shape: Shape, offset: THREE.Vector3, scale: THREE.Vector3): THREE.Matrix4 {
  const p = shape.position;
  const q = shape.rotation;
  const rotation = q ? new THREE.Quaternion(q.x, q.y, q.z, q.w) : new THREE.Quaternion();
  if (rotation.lengthSq() === 0) rotation.identity();
  rotation.normalize();
  const position = offset.clone().applyQuaternion(rotation);
  if (p) position.add(new THREE.Vector3(p.x, p.y, p.z));
  return new THREE.Matrix4().compose(position, rotation, scale);
}

const MIDDLE = new THREE.Vector3();

/** A shape as one to three parts of unit size. */
function partsOf(shape: Shape): { kind: Kind; local: THREE.Matrix4 }[] {
  switch (shape.kind.case) {
    case 'sphere': {
      const r = shape.kind.value.radius;
      return [{ kind: 'sphere', local: localOf(shape, MIDDLE, new THREE.Vector3(r, r, r)) }];
    }
    case 'box': {
      const h = shape.kind.value.halfExtents;
      const scale = new THREE.Vector3(h?.x ?? 0.5, h?.y ?? 0.5, h?.z ?? 0.5);
      return [{ kind: 'box', local: localOf(shape, MIDDLE, scale) }];
    }
    case 'capsule': {
      const { radius: r, halfLength: h } = shape.kind.value;
      const ball = new THREE.Vector3(r, r, r);
      return [
        { kind: 'cylinder', local: localOf(shape, MIDDLE, new THREE.Vector3(r, h, r)) },
        { kind: 'sphere', local: localOf(shape, new THREE.Vector3(0, h, 0), ball) },
        { kind: 'sphere', local: localOf(shape, new THREE.Vector3(0, -h, 0), ball) },
      ];
    }
    case 'plane': {
      const local = localOf(shape, MIDDLE, new THREE.Vector3(500, 1, 500));
      const n = shape.kind.value.normal;
      if (n) {
        const up = new THREE.Quaternion().setFromUnitVectors(
          new THREE.Vector3(0, 1, 0),
          new THREE.Vector3(n.x, n.y, n.z).normalize(),
        );
        local.multiply(new THREE.Matrix4().makeRotationFromQuaternion(up));
      }
      return [{ kind: 'plane', local }];
    }
    default:
      return [];
  }
}

export class SceneView {
  readonly scene = new THREE.Scene();
  private readonly meshes = new Map<Kind, THREE.InstancedMesh>();
  private parts: Part[] = [];
  private partsOfEntity = new Map<number, Part[]>();
  private entityOfInstance = new Map<Kind, Uint32Array>();
  private baseColor = new Map<number, number>();
  private drawn = new Map<number, { pose: Float64Array; asleep: boolean }>();
  private readonly sun = new THREE.DirectionalLight(0xfff4e0, 2.6);

  constructor() {
    this.scene.background = new THREE.Color(0x141a21);
    this.scene.fog = new THREE.Fog(0x141a21, 60, 220);
    this.scene.add(new THREE.HemisphereLight(0xbcd4f0, 0x3a352c, 1.1));
    this.sun.position.set(18, 30, 12);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    const reach = 26;
    Object.assign(this.sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, far: 90 });
    this.sun.shadow.bias = -0.0005;
    this.sun.shadow.normalBias = 0.03;
    this.scene.add(this.sun);
    const grid = new THREE.GridHelper(200, 100, 0x37424e, 0x262f38);
    grid.position.y = 0.004;
    (grid.material as THREE.Material).transparent = true;
    (grid.material as THREE.Material).opacity = 0.45;
    this.scene.add(grid);
  }

  get objects(): THREE.InstancedMesh[] {
    return [...this.meshes.values()];
  }

  entityAt(mesh: THREE.Object3D, instance: number): number | undefined {
    for (const [kind, known] of this.meshes)
      if (known === mesh) return this.entityOfInstance.get(kind)?.[instance];
    return undefined;
  }

  /** Who is there changed: parts and meshes are made anew. */
  setEntities(entities: ReadonlyMap<number, Entity>, me: number): void {
    this.parts = [];
    this.partsOfEntity.clear();
    this.baseColor.clear();
    this.drawn.clear();
    const counts = new Map<Kind, number>();
    for (const entity of entities.values()) {
      this.baseColor.set(entity.id, this.colorOf(entity, me));
      const own: Part[] = [];
      for (const shape of entity.shapes)
        for (const { kind, local } of partsOf(shape)) {
          const instance = counts.get(kind) ?? 0;
          counts.set(kind, instance + 1);
          own.push({ kind, instance, entity: entity.id, local });
        }
      this.partsOfEntity.set(entity.id, own);
      this.parts.push(...own);
    }
    for (const kind of Object.keys(GEOMETRIES) as Kind[]) this.fitMesh(kind, counts.get(kind) ?? 0);
    for (const part of this.parts) {
      this.entityOfInstance.get(part.kind)![part.instance] = part.entity;
      // Not in a frame yet: invisible.
      this.meshes.get(part.kind)!.setMatrixAt(part.instance, matrix.makeScale(0, 0, 0));
    }
  }

  private colorOf(entity: Entity, me: number): number {
    if (entity.color !== undefined) return entity.color;
    if (entity.owner === me && me !== 0) return 0xffd166;
    if (entity.type === BodyType.FIXED) return FIXED_COLOR;
    return PALETTE[entity.id % PALETTE.length]!;
  }

  private fitMesh(kind: Kind, count: number): void {
    let mesh = this.meshes.get(kind);
    if (!mesh || mesh.instanceMatrix.count < count) {
      if (mesh) {
        this.scene.remove(mesh);
        mesh.dispose();
      }
      const material =
        (mesh?.material as THREE.Material | undefined) ??
        new THREE.MeshStandardMaterial({ roughness: 0.72, metalness: 0.04 });
      const room = Math.max(64, Math.ceil(count * 1.5));
      mesh = new THREE.InstancedMesh(mesh?.geometry ?? GEOMETRIES[kind](), material, room);
      mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
      mesh.castShadow = kind !== 'plane';
      mesh.receiveShadow = true;
      mesh.frustumCulled = false; // instances are all over the place
      this.meshes.set(kind, mesh);
      this.entityOfInstance.set(kind, new Uint32Array(room));
      this.scene.add(mesh);
    }
    mesh.count = count;
  }

  /** Puts every body where it is now. */
  update(now: DrawnPoses): void {
    let moved = false;
    let shaded = false;
    for (let i = 0; i < now.count; i++) {
      const id = now.ids[i]!;
      const asleep = now.source!.entities[i]!.atRest;
      let last = this.drawn.get(id);
      const parts = this.partsOfEntity.get(id);
      if (!parts) continue;
      const at = i * POSE_FLOATS;
      if (!last) {
        last = { pose: new Float64Array(POSE_FLOATS).fill(NaN), asleep: !asleep };
        this.drawn.set(id, last);
      }
      if (last.asleep !== asleep) {
        last.asleep = asleep;
        shaded = true;
        this.shade(id, parts, asleep);
      }
      let same = true;
      for (let k = 0; k < POSE_FLOATS; k++)
        if (last.pose[k] !== now.poses[at + k]) {
          same = false;
          last.pose[k] = now.poses[at + k]!;
        }
      if (same) continue;
      moved = true;
      vector.set(last.pose[0]!, last.pose[1]!, last.pose[2]!);
      quaternion.set(last.pose[3]!, last.pose[4]!, last.pose[5]!, last.pose[6]!);
      const body = matrix.compose(vector, quaternion, one);
      for (const part of parts) {
        partMatrix.multiplyMatrices(body, part.local);
        this.meshes.get(part.kind)!.setMatrixAt(part.instance, partMatrix);
      }
    }
    for (const mesh of this.meshes.values()) {
      if (moved) {
        mesh.instanceMatrix.needsUpdate = true;
        mesh.boundingSphere = null; // picking computes it anew
      }
      if (shaded && mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  private shade(id: number, parts: Part[], asleep: boolean): void {
    color.set(this.baseColor.get(id) ?? FIXED_COLOR);
    // Fixed bodies always rest; only what could move looks sleepy.
    if (asleep && this.baseColor.get(id) !== FIXED_COLOR) color.multiplyScalar(ASLEEP_SHADE);
    for (const part of parts) this.meshes.get(part.kind)!.setColorAt(part.instance, color);
  }

  poseOf(id: number): Float64Array | undefined {
    return this.drawn.get(id)?.pose;
  }
}

const partMatrix = new THREE.Matrix4();
