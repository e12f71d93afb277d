// Bodies to instanced meshes: one mesh per geometry, one instance per part of a body. Each picture only the matrices of parts whose
// body moved are written; nothing is allocated. Hulls, meshes and height fields that look alike share a geometry, which goes with
// the last of them; unit geometries stay.

import * as THREE from 'three';
import { BodyType } from '@jostle/client/gen/scene_pb';
import type { Entity } from '@jostle/client/gen/play_pb';
import { POSE_FLOATS, type RenderedPoses } from '@jostle/client';
import { Instances } from './instances';
import { makeSky, materialFor } from './materials';
import { partsOf, UNIT_GEOMETRIES, UNIT_KINDS, type Kind, type ShapePart } from './shape_parts';

interface Part {
  readonly instances: Instances;
  readonly slot: number;
  readonly local: THREE.Matrix4;
}

interface RenderedEntity {
  readonly entity: Entity;
  readonly parts: readonly Part[];
  readonly color: number;
  readonly pose: Float64Array; // NaN until the first picture
  asleep: boolean | undefined; // as painted; undefined: to be painted
}

const PALETTE = [0x5b8def, 0xe07a5f, 0xf2cc8f, 0x6bb392, 0xa78bfa, 0xef8354, 0x4cc9c0, 0xe66a9c];
const MINE = 0xffd166;
const STATIC_COLOR = 0x66727f;
const ASLEEP_GREY = new THREE.Color(0x39424c);
const ASLEEP_SHARE = 0.3;
// In the debug view.
const ASLEEP_MARK = new THREE.Color(0x2f6fd6);
const ASLEEP_MARK_SHARE = 0.75;
const NO_ISLAND = 0x8d959e;
const HORIZON = new THREE.Color(0x3b4c5e);
const ABOVE = new THREE.Color(0x0e141c);
const SUN = new THREE.Vector3(18, 30, 12).normalize().multiplyScalar(60); // m from what is looked at
const SHADOW_PIXELS = 2048;
const GROUND_WIDE = 45; // m: what is as wide is stood on, not looked at
const OWN_GEOMETRY_ROOM = 8; // instances; grows
const FLAT_GROUND: readonly Kind[] = ['plane', 'slab']; // casts no shadow

const vector = new THREE.Vector3();
const quaternion = new THREE.Quaternion();
const one = new THREE.Vector3(1, 1, 1);
const bodyMatrix = new THREE.Matrix4();
const partMatrix = new THREE.Matrix4();
const color = new THREE.Color();

export class SceneView {
  readonly scene = new THREE.Scene();
  private readonly geometries = new Map<string, Instances>(); // by the key of a part
  private readonly materials = new Map<Kind, THREE.Material>();
  private readonly shown = new Map<number, RenderedEntity>();
  private readonly sun = new THREE.DirectionalLight(0xfff1dc, 2.7);
  private shadowReach = 0;
  private tints: ReadonlyMap<number, number> | undefined;
  private bodyColors: ReadonlyMap<number, number> = new Map();
  private asleepMarked = false;

  constructor() {
    this.scene.fog = new THREE.Fog(HORIZON, 45, 170);
    this.scene.add(makeSky(HORIZON, ABOVE));
    this.scene.add(new THREE.HemisphereLight(0xcfe0f5, 0x4f4a42, 1.35));
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.03;
    this.scene.add(this.sun, this.sun.target);
    for (const kind of UNIT_KINDS) this.addInstances(kind, kind, UNIT_GEOMETRIES[kind]());
    this.updateSun(new THREE.Vector3(), 25);
  }

  private addInstances(key: string, kind: Kind, geometry: THREE.BufferGeometry, room?: number): Instances {
    let material = this.materials.get(kind);
    if (!material) this.materials.set(kind, (material = materialFor(kind)));
    const instances = new Instances(this.scene, kind, geometry, material, !FLAT_GROUND.includes(kind), room);
    this.geometries.set(key, instances);
    return instances;
  }

  private instancesFor({ key, kind, geometry }: ShapePart): Instances | undefined {
    const known = this.geometries.get(key);
    if (known) return known;
    const made = geometry();
    return made && this.addInstances(key, kind, made, OWN_GEOMETRY_ROOM);
  }

  get objects(): THREE.InstancedMesh[] {
    return [...this.geometries.values()].map((instances) => instances.mesh);
  }

  /** How many parts of each kind there are. */
  partCounts(): Partial<Record<Kind, number>> {
    const counts: Partial<Record<Kind, number>> = {};
    for (const { kind, size } of this.geometries.values()) if (size > 0) counts[kind] = (counts[kind] ?? 0) + size;
    return counts;
  }

  /** Whose part that instance is, and of which of its shapes; entity 0: nobody's. */
  ownerAt(mesh: THREE.Object3D, slot: number): { entity: number; shape: number } {
    const instances = mesh.userData['instances'] as Instances | undefined;
    return { entity: instances?.entityAt(slot) ?? 0, shape: instances?.shapeAt(slot) ?? 0 };
  }

  /** Shadows fall where one looks, as sharp as the distance allows. */
  updateSun(target: THREE.Vector3, distance: number): void {
    const reach = Math.min(112, 14 * 2 ** Math.max(0, Math.ceil(Math.log2(distance / 14))));
    if (reach !== this.shadowReach) {
      this.shadowReach = reach;
      const { camera } = this.sun.shadow;
      Object.assign(camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 1, far: 60 + 2 * reach });
      camera.updateProjectionMatrix();
    }
    // In steps, or every move of the camera would make the shadows' rims crawl.
    const grain = reach / 16;
    const { position } = this.sun.target;
    position.copy(target).divideScalar(grain).round().multiplyScalar(grain);
    this.sun.position.copy(position).add(SUN);
  }

  /** Who is there changed. */
  setEntities(entities: ReadonlyMap<number, Entity>, me: number): void {
    for (const [id, shown] of this.shown) {
      if (entities.get(id) === shown.entity) continue;
      for (const part of shown.parts) part.instances.giveBack(part.slot);
      this.shown.delete(id);
    }
    for (const entity of entities.values())
      if (!this.shown.has(entity.id)) this.shown.set(entity.id, this.show(entity, me));
    // Last, so that a body that changed keeps the geometry it shares only with itself.
    for (const [key, instances] of this.geometries) {
      if (instances.size > 0 || (UNIT_KINDS as readonly string[]).includes(key)) continue;
      instances.dispose();
      this.geometries.delete(key);
    }
  }

  private show(entity: Entity, me: number): RenderedEntity {
    const parts: Part[] = [];
    entity.shapes.forEach((shape, number) => {
      for (const part of partsOf(shape)) {
        const instances = this.instancesFor(part);
        if (instances) parts.push({ instances, slot: instances.take(entity.id, number), local: part.local });
      }
    });
    const pose = new Float64Array(POSE_FLOATS).fill(NaN);
    return { entity, parts, color: colorOf(entity, me), pose, asleep: undefined };
  }

  /** Puts every body where it is now. */
  update(now: RenderedPoses): void {
    for (let i = 0; i < now.count; i++) {
      const shown = this.shown.get(now.ids[i]!);
      if (!shown) continue;
      const asleep = now.source!.entities[i]!.atRest;
      if (shown.asleep !== asleep) this.paint(shown, asleep);
      let same = true;
      const at = i * POSE_FLOATS;
      const { pose } = shown;
      for (let k = 0; k < POSE_FLOATS; k++) {
        const value = now.poses[at + k]!;
        if (pose[k] === value) continue;
        pose[k] = value;
        same = false;
      }
      if (!same) this.place(shown);
    }
    for (const instances of this.geometries.values()) instances.publish();
  }

  private place({ pose, parts }: RenderedEntity): void {
    vector.set(pose[0]!, pose[1]!, pose[2]!);
    quaternion.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
    bodyMatrix.compose(vector, quaternion, one);
    for (let k = 0; k < parts.length; k++) {
      const { instances, slot, local } = parts[k]!;
      instances.place(slot, partMatrix.multiplyMatrices(bodyMatrix, local));
    }
  }

  private paint(shown: RenderedEntity, asleep: boolean): void {
    shown.asleep = asleep;
    color.set(this.colorNow(shown));
    // Fixed bodies always rest; only what could move looks sleepy.
    if (asleep && shown.entity.mass > 0)
      color.lerp(this.asleepMarked ? ASLEEP_MARK : ASLEEP_GREY, this.asleepMarked ? ASLEEP_MARK_SHARE : ASLEEP_SHARE);
    for (const { instances, slot } of shown.parts) instances.paint(slot, color);
  }

  private colorNow({ entity, color }: RenderedEntity): number {
    const own = entity.color ?? this.bodyColors.get(entity.id) ?? color;
    if (!this.tints || entity.mass <= 0) return own;
    return this.tints.get(entity.id) ?? NO_ISLAND;
  }

  /** Debug view: a colour per body instead of its own; undefined: their own again. */
  setTints(tints: ReadonlyMap<number, number> | undefined): void {
    const before = this.tints;
    this.tints = tints;
    if (!before && !tints) return;
    for (const [id, shown] of this.shown)
      if (!before || !tints || before.get(id) !== tints.get(id)) shown.asleep = undefined; // painted with the next picture
  }

  /** Colours for bodies that have none of their own. */
  setBodyColors(colors: ReadonlyMap<number, number>): void {
    const before = this.bodyColors;
    this.bodyColors = colors;
    for (const [id, shown] of this.shown) if (before.get(id) !== colors.get(id)) shown.asleep = undefined; // painted with the next picture
  }

  /** Debug view: whether who sleeps stands out. */
  markAsleep(marked: boolean): void {
    if (this.asleepMarked === marked) return;
    this.asleepMarked = marked;
    for (const shown of this.shown.values()) shown.asleep = undefined;
  }

  /** Where a body is drawn; nothing while it never was. */
  poseOf(id: number): Float64Array | undefined {
    const pose = this.shown.get(id)?.pose;
    return pose && !Number.isNaN(pose[0]!) ? pose : undefined;
  }

  /** A box round what is there to be seen: all but ground and what hangs far away from the rest. */
  outline(): THREE.Box3 {
    const around = new THREE.Box3();
    const part = new THREE.Box3();
    for (const { parts, pose } of this.shown.values()) {
      if (Number.isNaN(pose[0]!)) continue;
      for (const { instances, slot } of parts) {
        instances.mesh.geometry.boundingBox ?? instances.mesh.geometry.computeBoundingBox();
        instances.mesh.getMatrixAt(slot, partMatrix);
        part.copy(instances.mesh.geometry.boundingBox!).applyMatrix4(partMatrix);
        const wide = Math.max(part.max.x - part.min.x, part.max.z - part.min.z);
        if (wide < GROUND_WIDE) around.union(part);
      }
    }
    return around;
  }

  /** The same, of what can move. */
  loosePoseOf(id: number): Float64Array | undefined {
    return (this.shown.get(id)?.entity.mass ?? 0) > 0 ? this.poseOf(id) : undefined;
  }

  /** The colour that a body's parts have in the picture. */
  colorOf(id: number): number | undefined {
    const part = this.shown.get(id)?.parts[0];
    return part && part.instances.colorAt(part.slot).getHex();
  }
}

function colorOf(entity: Entity, me: number): number {
  if (entity.color !== undefined) return entity.color;
  if (entity.type === BodyType.STATIC) return STATIC_COLOR;
  if (entity.owner !== 0) return entity.owner === me ? MINE : PALETTE[entity.owner % PALETTE.length]!;
  return PALETTE[entity.id % PALETTE.length]!;
}
