// Picks the body under the pointer. The rendered scene gives an immediate result, the server the exact
// one after a round trip.

import * as THREE from 'three';
import type { Queries } from '@jostle/client';
import type { SceneView } from '../scene/scene_view';

export interface Pick {
  readonly entity: number;
  readonly shape: number; // index of the entity's shape
  readonly point: THREE.Vector3;
  readonly normal: THREE.Vector3; // outward normal of the hit surface
  readonly distance: number; // m from the ray origin
}

const REACH = 500; // m: far plane of the camera

/** In the rendered scene. */
export function pickRendered(view: SceneView, raycaster: THREE.Raycaster): Pick | undefined {
  for (const hit of raycaster.intersectObjects(view.objects, false)) {
    if (hit.instanceId === undefined) continue;
    const { entity, shape } = view.ownerAt(hit.object, hit.instanceId);
    if (entity === 0) continue;
    const normal = hit.face?.normal.clone() ?? new THREE.Vector3(0, 1, 0);
    const instance = new THREE.Matrix4();
    (hit.object as THREE.InstancedMesh).getMatrixAt(hit.instanceId, instance);
    normal.applyNormalMatrix(new THREE.Matrix3().getNormalMatrix(instance)).normalize();
    if (normal.dot(raycaster.ray.direction) > 0) normal.negate(); // the back side of a mesh
    return { entity, shape, point: hit.point, normal, distance: hit.distance };
  }
  return undefined;
}

const CAMERA_DISTANCE_MIN = 1.2; // m
const WALL_CLEARANCE = 0.25; // m

/**
 * Distance from `from` towards `to` up to the first static body; Infinity without one. `except`: an
 * entity to ignore.
 */
export function unobstructedDistance(view: SceneView, from: THREE.Vector3, to: THREE.Vector3, except: number): number {
  const displacement = to.clone().sub(from);
  const raycaster = new THREE.Raycaster(from, displacement.clone().normalize(), 0, displacement.length());
  for (const hit of raycaster.intersectObjects(view.objects, false)) {
    if (hit.instanceId === undefined) continue;
    const { entity } = view.ownerAt(hit.object, hit.instanceId);
    if (entity !== 0 && entity !== except && !view.dynamicPoseOf(entity)) return Math.max(CAMERA_DISTANCE_MIN, hit.distance - WALL_CLEARANCE);
  }
  return Infinity;
}

/** Height of the rendered scene at a position; undefined where there is nothing. */
export function surfaceHeightAt(view: SceneView, x: number, z: number): number | undefined {
  const down = new THREE.Raycaster(new THREE.Vector3(x, REACH, z), new THREE.Vector3(0, -1, 0), 0, 2 * REACH);
  return pickRendered(view, down)?.point.y;
}

/** In the server's world, at `viewTime` if given; undefined without a response. */
export async function pickFromServer(
  queries: Queries,
  { origin, direction }: THREE.Ray,
  viewTime?: { tick: number; fraction: number },
): Promise<{ hit: Pick | undefined } | undefined> {
  const motion = direction.clone().multiplyScalar(REACH);
  const xyz = ({ x, y, z }: THREE.Vector3) => ({ x, y, z });
  const response = await queries.castRays({ rays: [{ origin: xyz(origin), motion: xyz(motion) }], viewTime });
  if (!response) return undefined;
  const hit = response.rays[0]?.hits[0];
  if (!hit) return { hit: undefined };
  const { entity, shape, fraction } = hit;
  const point = new THREE.Vector3(hit.point?.x, hit.point?.y, hit.point?.z);
  const normal = new THREE.Vector3(hit.normal?.x, hit.normal?.y, hit.normal?.z);
  return { hit: { entity, shape, point, normal, distance: fraction * REACH } };
}

/**
 * Chooses between the two results. Rendering is tens of milliseconds behind the server: for a moving
 * body, the server's result may refer to another time than the user's aim, so the rendered result
 * counts.
 */
export function choosePick(
  rendered: Pick | undefined,
  fromServer: { hit: Pick | undefined } | undefined,
  isMoving: (entity: number) => boolean,
): Pick | undefined {
  if (!fromServer) return rendered;
  if (rendered && rendered.entity !== fromServer.hit?.entity && isMoving(rendered.entity)) return rendered;
  return fromServer.hit;
}
