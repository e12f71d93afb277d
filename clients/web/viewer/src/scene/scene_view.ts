// Bodies as instanced meshes: one mesh per geometry, one instance per part of a body. Per rendered
// frame only the matrices of moved bodies are written, without allocations. Equal hulls, meshes and
// height fields share a geometry, which is disposed with the last of them; unit geometries stay.

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
  readonly pose: Float64Array; // NaN until the first rendered frame
  asleep: boolean | undefined; // as colored; undefined: to be colored
}

const PALETTE = [0x5b8def, 0xe07a5f, 0xf2cc8f, 0x6bb392, 0xa78bfa, 0xef8354, 0x4cc9c0, 0xe66a9c];
const OWN_COLOR = 0xffd166;
const STATIC_COLOR = 0x66727f;
const ASLEEP_GRAY = new THREE.Color(0x39424c);
const ASLEEP_WEIGHT = 0.3;
// In the debug view.
const ASLEEP_MARK = new THREE.Color(0x2f6fd6);
const ASLEEP_MARK_WEIGHT = 0.75;
const NO_ISLAND = 0x8d959e;
const HORIZON = new THREE.Color(0x3b4c5e);
const ZENITH = new THREE.Color(0x0e141c);
const SUN = new THREE.Vector3(18, 30, 12).normalize().multiplyScalar(60); // m, from the target of the camera
const SHADOW_PIXELS = 2048;
const GROUND_WIDTH = 45; // m: wider parts are ground
const GEOMETRY_CAPACITY = 8; // initial instances
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
  private readonly rendered = new Map<number, RenderedEntity>();
  private readonly sun = new THREE.DirectionalLight(0xfff1dc, 2.7);
  private shadowReach = 0;
  private tints: ReadonlyMap<number, number> | undefined;
  private bodyColors: ReadonlyMap<number, number> = new Map();
  private asleepMarked = false;

  constructor() {
    this.scene.fog = new THREE.Fog(HORIZON, 45, 170);
    this.scene.add(makeSky(HORIZON, ZENITH));
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
    return made && this.addInstances(key, kind, made, GEOMETRY_CAPACITY);
  }

  get objects(): THREE.InstancedMesh[] {
    return [...this.geometries.values()].map((instances) => instances.mesh);
  }

  /** Number of parts of each kind. */
  partCounts(): Partial<Record<Kind, number>> {
    const counts: Partial<Record<Kind, number>> = {};
    for (const { kind, size } of this.geometries.values()) if (size > 0) counts[kind] = (counts[kind] ?? 0) + size;
    return counts;
  }

  /** Entity and shape index of an instance; entity 0: none. */
  ownerAt(mesh: THREE.Object3D, slot: number): { entity: number; shape: number } {
    const instances = mesh.userData['instances'] as Instances | undefined;
    return { entity: instances?.entityAt(slot) ?? 0, shape: instances?.shapeAt(slot) ?? 0 };
  }

  /** Moves the shadows to the target of the camera; their resolution depends on the distance. */
  updateSun(target: THREE.Vector3, distance: number): void {
    const reach = Math.min(112, 14 * 2 ** Math.max(0, Math.ceil(Math.log2(distance / 14))));
    if (reach !== this.shadowReach) {
      this.shadowReach = reach;
      const { camera } = this.sun.shadow;
      Object.assign(camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 1, far: 60 + 2 * reach });
      camera.updateProjectionMatrix();
    }
    // Quantized, so that camera moves do not make the edges of shadows crawl.
    const grain = reach / 16;
    const { position } = this.sun.target;
    position.copy(target).divideScalar(grain).round().multiplyScalar(grain);
    this.sun.position.copy(position).add(SUN);
  }

  /** The set of entities changed. */
  setEntities(entities: ReadonlyMap<number, Entity>, clientId: number): void {
    for (const [id, rendered] of this.rendered) {
      if (entities.get(id) === rendered.entity) continue;
      for (const part of rendered.parts) part.instances.release(part.slot);
      this.rendered.delete(id);
    }
    for (const entity of entities.values())
      if (!this.rendered.has(entity.id)) this.rendered.set(entity.id, this.addEntity(entity, clientId));
    // Last, so that a changed body reuses a geometry that only it has.
    for (const [key, instances] of this.geometries) {
      if (instances.size > 0 || (UNIT_KINDS as readonly string[]).includes(key)) continue;
      instances.dispose();
      this.geometries.delete(key);
    }
  }

  private addEntity(entity: Entity, clientId: number): RenderedEntity {
    const parts: Part[] = [];
    entity.shapes.forEach((shape, number) => {
      for (const part of partsOf(shape)) {
        const instances = this.instancesFor(part);
        if (instances) parts.push({ instances, slot: instances.acquire(entity.id, number), local: part.local });
      }
    });
    const pose = new Float64Array(POSE_FLOATS).fill(NaN);
    return { entity, parts, color: colorOf(entity, clientId), pose, asleep: undefined };
  }

  /** Applies the current poses. */
  update(now: RenderedPoses): void {
    for (let i = 0; i < now.count; i++) {
      const rendered = this.rendered.get(now.ids[i]!);
      if (!rendered) continue;
      const asleep = now.source!.entities[i]!.atRest;
      if (rendered.asleep !== asleep) this.applyColor(rendered, asleep);
      let same = true;
      const at = i * POSE_FLOATS;
      const { pose } = rendered;
      for (let k = 0; k < POSE_FLOATS; k++) {
        const value = now.poses[at + k]!;
        if (pose[k] === value) continue;
        pose[k] = value;
        same = false;
      }
      if (!same) this.applyPose(rendered);
    }
    for (const instances of this.geometries.values()) instances.upload();
  }

  private applyPose({ pose, parts }: RenderedEntity): void {
    vector.set(pose[0]!, pose[1]!, pose[2]!);
    quaternion.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
    bodyMatrix.compose(vector, quaternion, one);
    for (let k = 0; k < parts.length; k++) {
      const { instances, slot, local } = parts[k]!;
      instances.setMatrix(slot, partMatrix.multiplyMatrices(bodyMatrix, local));
    }
  }

  private applyColor(rendered: RenderedEntity, asleep: boolean): void {
    rendered.asleep = asleep;
    color.set(this.currentColor(rendered));
    // Static bodies always rest; only dynamic bodies are rendered as sleeping.
    if (asleep && rendered.entity.mass > 0)
      color.lerp(this.asleepMarked ? ASLEEP_MARK : ASLEEP_GRAY, this.asleepMarked ? ASLEEP_MARK_WEIGHT : ASLEEP_WEIGHT);
    for (const { instances, slot } of rendered.parts) instances.setColor(slot, color);
  }

  private currentColor({ entity, color }: RenderedEntity): number {
    const own = entity.color ?? this.bodyColors.get(entity.id) ?? color;
    if (!this.tints || entity.mass <= 0) return own;
    return this.tints.get(entity.id) ?? NO_ISLAND;
  }

  /** Debug view: a color per body instead of its own; undefined: its own again. */
  setTints(tints: ReadonlyMap<number, number> | undefined): void {
    const previous = this.tints;
    this.tints = tints;
    if (!previous && !tints) return;
    for (const [id, rendered] of this.rendered)
      if (!previous || !tints || previous.get(id) !== tints.get(id)) rendered.asleep = undefined; // colored with the next rendered frame
  }

  /** Colors of bodies that have no color of their own. */
  setBodyColors(colors: ReadonlyMap<number, number>): void {
    const previous = this.bodyColors;
    this.bodyColors = colors;
    for (const [id, rendered] of this.rendered) if (previous.get(id) !== colors.get(id)) rendered.asleep = undefined; // colored with the next rendered frame
  }

  /** Debug view: whether to highlight sleeping bodies. */
  markAsleep(marked: boolean): void {
    if (this.asleepMarked === marked) return;
    this.asleepMarked = marked;
    for (const rendered of this.rendered.values()) rendered.asleep = undefined;
  }

  /** The rendered pose of a body; undefined before its first rendered frame. */
  poseOf(id: number): Float64Array | undefined {
    const pose = this.rendered.get(id)?.pose;
    return pose && !Number.isNaN(pose[0]!) ? pose : undefined;
  }

  /** Bounding box of all parts but ground. */
  bounds(): THREE.Box3 {
    const box = new THREE.Box3();
    const part = new THREE.Box3();
    for (const { parts, pose } of this.rendered.values()) {
      if (Number.isNaN(pose[0]!)) continue;
      for (const { instances, slot } of parts) {
        instances.mesh.geometry.boundingBox ?? instances.mesh.geometry.computeBoundingBox();
        instances.mesh.getMatrixAt(slot, partMatrix);
        part.copy(instances.mesh.geometry.boundingBox!).applyMatrix4(partMatrix);
        const width = Math.max(part.max.x - part.min.x, part.max.z - part.min.z);
        if (width < GROUND_WIDTH) box.union(part);
      }
    }
    return box;
  }

  /** The rendered pose of a dynamic body. */
  dynamicPoseOf(id: number): Float64Array | undefined {
    return (this.rendered.get(id)?.entity.mass ?? 0) > 0 ? this.poseOf(id) : undefined;
  }

  /** The color of a body's parts in the rendered frame. */
  colorOf(id: number): number | undefined {
    const part = this.rendered.get(id)?.parts[0];
    return part && part.instances.colorAt(part.slot).getHex();
  }
}

function colorOf(entity: Entity, clientId: number): number {
  if (entity.color !== undefined) return entity.color;
  if (entity.type === BodyType.STATIC) return STATIC_COLOR;
  if (entity.owner !== 0) return entity.owner === clientId ? OWN_COLOR : PALETTE[entity.owner % PALETTE.length]!;
  return PALETTE[entity.id % PALETTE.length]!;
}
