// Bodies as instanced meshes: one mesh per geometry, one instance per part of a body. Per rendered
// frame only the matrices of moved bodies are written, without allocations. Equal hulls, meshes and
// height fields share a geometry, which is disposed with the last of them; unit geometries of solid
// surfaces stay.

import * as THREE from 'three';
import { BodyType } from '@jostle/client/gen/scene_pb';
import type { Entity } from '@jostle/client/gen/play_pb';
import { POSE_FLOATS, type RenderedPoses } from '@jostle/client';
import { Instances } from './instances';
import { GROUND_KINDS, materialFor, type Surface } from './materials';
import { sceneExtent, type PlacedBody } from './scene_extent';
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
  readonly radius: number; // m, mean radius of its smallest part
  asleep: boolean | undefined; // as colored; undefined: to be colored
}

const PALETTE = [0x5b8def, 0xe07a5f, 0xf2cc8f, 0x6bb392, 0xa78bfa, 0xef8354, 0x4cc9c0, 0xe66a9c];
const OWN_COLOR = 0xffd166;
const STATIC_COLOR = 0x93a0ad;
const GROUND_COLOR = 0x7f8b97;
const KINEMATIC_COLOR = 0xb9c3cd;
const TRIGGER_COLOR = 0x58d6e8;
const ASLEEP_GRAY = new THREE.Color(0x39424c);
const ASLEEP_WEIGHT = 0.3;
// In the debug view.
const ASLEEP_MARK = new THREE.Color(0x2f6fd6);
const ASLEEP_MARK_WEIGHT = 0.75;
const NO_ISLAND = 0x8d959e;
const GROUND_WIDTH = 45; // m: wider parts are ground
const GROUND_WIDTH_MAX = 400; // m: wider ground is never shown as a whole
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
  private readonly materials = new Map<string, THREE.Material>(); // by surface and kind
  private readonly rendered = new Map<number, RenderedEntity>();
  private tints: ReadonlyMap<number, number> | undefined;
  private bodyColors: ReadonlyMap<number, number> = new Map();
  private asleepMarked = false;

  constructor() {
    for (const kind of UNIT_KINDS) this.addInstances(kind, kind, 'solid', UNIT_GEOMETRIES[kind]());
  }

  private addInstances(key: string, kind: Kind, surface: Surface, geometry: THREE.BufferGeometry, room?: number): Instances {
    const materialKey = `${surface} ${kind}`;
    let material = this.materials.get(materialKey);
    if (!material) this.materials.set(materialKey, (material = materialFor(kind, surface)));
    const instances = new Instances(this.scene, kind, geometry, material, surface !== 'glass' && !FLAT_GROUND.includes(kind), room);
    // Opaque bodies first, so that triggers show what is inside of them.
    if (surface === 'glass') instances.renderOrder = 2;
    this.geometries.set(key, instances);
    return instances;
  }

  private instancesFor({ key: shapeKey, kind, geometry }: ShapePart, surface: Surface): Instances | undefined {
    const key = surface === 'solid' ? shapeKey : `${surface} ${shapeKey}`;
    const known = this.geometries.get(key);
    if (known) return known;
    const made = geometry();
    return made && this.addInstances(key, kind, surface, made, GEOMETRY_CAPACITY);
  }

  /** Meshes of all bodies, without triggers, which pointers and rays pass through. */
  get objects(): THREE.InstancedMesh[] {
    return [...this.geometries.entries()].filter(([key]) => !key.startsWith('glass ')).map(([, { mesh }]) => mesh);
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
    let radius = Infinity;
    entity.shapes.forEach((shape, number) => {
      const surface = surfaceOf(entity, shape.trigger);
      for (const part of partsOf(shape)) {
        const instances = this.instancesFor(part, surface);
        if (!instances) continue;
        parts.push({ instances, slot: instances.acquire(entity.id, number), local: part.local });
        radius = Math.min(radius, meanRadius(instances.mesh.geometry, part.local));
      }
    });
    const pose = new Float64Array(POSE_FLOATS).fill(NaN);
    const ground = parts.some(({ instances }) => GROUND_KINDS.includes(instances.kind));
    return { entity, parts, color: colorOf(entity, clientId, ground), pose, radius, asleep: undefined };
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

  /** Mean radius of the smallest part of a body in m; undefined: it has no parts. */
  radiusOf(id: number): number | undefined {
    const radius = this.rendered.get(id)?.radius;
    return radius !== undefined && radius < Infinity ? radius : undefined;
  }

  /** Bounding box of a body in its rendered pose; empty: it has none. */
  boxOf(id: number): THREE.Box3 {
    const rendered = this.rendered.get(id);
    return rendered && !Number.isNaN(rendered.pose[0]!) ? boxOfParts(rendered.parts, Infinity) : new THREE.Box3();
  }

  /**
   * Points that a view of the scene should show: without bodies that rolled away, and without ground
   * unless there is nothing else.
   */
  extent(): THREE.Vector3[] {
    const points = sceneExtent(this.placedBodies(GROUND_WIDTH));
    return points.length > 0 ? points : sceneExtent(this.placedBodies(GROUND_WIDTH_MAX));
  }

  /** Bodies without parts that are wider than `widthMax` in m. */
  private placedBodies(widthMax: number): PlacedBody[] {
    const bodies: PlacedBody[] = [];
    for (const { parts, pose, entity } of this.rendered.values()) {
      if (Number.isNaN(pose[0]!)) continue;
      const box = boxOfParts(parts, widthMax);
      if (!box.isEmpty()) bodies.push({ box, dynamic: entity.mass > 0 });
    }
    return bodies;
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

function boxOfParts(parts: readonly Part[], widthMax: number): THREE.Box3 {
  const box = new THREE.Box3();
  const partBox = new THREE.Box3();
  for (const { instances, slot } of parts) {
    const { mesh } = instances;
    mesh.geometry.boundingBox ?? mesh.geometry.computeBoundingBox();
    mesh.getMatrixAt(slot, partMatrix);
    partBox.copy(mesh.geometry.boundingBox!).applyMatrix4(partMatrix);
    if (Math.max(partBox.max.x - partBox.min.x, partBox.max.z - partBox.min.z) < widthMax) box.union(partBox);
  }
  return box;
}

/** Geometric mean of the half extents, m. */
function meanRadius(geometry: THREE.BufferGeometry, local: THREE.Matrix4): number {
  geometry.boundingBox ?? geometry.computeBoundingBox();
  const size = geometry.boundingBox!.getSize(vector);
  const scale = new THREE.Vector3().setFromMatrixScale(local);
  return Math.cbrt(size.x * scale.x * size.y * scale.y * size.z * scale.z) / 2;
}

function surfaceOf({ type, mass }: Entity, trigger: boolean): Surface {
  if (trigger) return 'glass';
  if (type === BodyType.KINEMATIC) return 'kinematic';
  return type === BodyType.STATIC && mass <= 0 ? 'static' : 'solid';
}

function colorOf(entity: Entity, clientId: number, ground: boolean): number {
  if (entity.color !== undefined) return entity.color;
  if (entity.shapes.length > 0 && entity.shapes.every(({ trigger }) => trigger)) return TRIGGER_COLOR;
  if (entity.type === BodyType.KINEMATIC) return KINEMATIC_COLOR;
  if (entity.type === BodyType.STATIC) return ground ? GROUND_COLOR : STATIC_COLOR;
  if (entity.owner !== 0) return entity.owner === clientId ? OWN_COLOR : PALETTE[entity.owner % PALETTE.length]!;
  return PALETTE[entity.id % PALETTE.length]!;
}
