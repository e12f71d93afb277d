// What is under the pointer. The drawing answers at once; the server answers rightly, a round trip later.

import * as THREE from 'three';
import type { Queries } from '@jostle/client';
import type { SceneView } from '../scene/scene_view';

export interface Pick {
  readonly entity: number;
  readonly shape: number; // which of the entity's shapes
  readonly point: THREE.Vector3;
  readonly normal: THREE.Vector3; // out of what was hit
  readonly distance: number; // m from the eye
}

const REACH = 500; // m: as far as the camera sees

/** Among what is drawn. */
export function pickRendered(view: SceneView, raycaster: THREE.Raycaster): Pick | undefined {
  for (const hit of raycaster.intersectObjects(view.objects, false)) {
    if (hit.instanceId === undefined) continue;
    const { entity, shape } = view.ownerAt(hit.object, hit.instanceId);
    if (entity === 0) continue;
    const normal = hit.face?.normal.clone() ?? new THREE.Vector3(0, 1, 0);
    const instance = new THREE.Matrix4();
    (hit.object as THREE.InstancedMesh).getMatrixAt(hit.instanceId, instance);
    normal.applyNormalMatrix(new THREE.Matrix3().getNormalMatrix(instance)).normalize();
    if (normal.dot(raycaster.ray.direction) > 0) normal.negate(); // the back of a mesh
    return { entity, shape, point: hit.point, normal, distance: hit.distance };
  }
  return undefined;
}

const CLOSEST = 1.2; // m
const OFF_WALL = 0.25; // m

/** How far one can go from a place towards another until something stands in the way that stays where it is. `but`: no matter. */
export function unobstructedDistance(view: SceneView, from: THREE.Vector3, to: THREE.Vector3, but: number): number {
  const way = to.clone().sub(from);
  const raycaster = new THREE.Raycaster(from, way.clone().normalize(), 0, way.length());
  for (const hit of raycaster.intersectObjects(view.objects, false)) {
    if (hit.instanceId === undefined) continue;
    const { entity } = view.ownerAt(hit.object, hit.instanceId);
    if (entity !== 0 && entity !== but && !view.loosePoseOf(entity)) return Math.max(CLOSEST, hit.distance - OFF_WALL);
  }
  return Infinity;
}

/** How high what is drawn reaches at a place; undefined: nothing is there. */
export function topAt(view: SceneView, x: number, z: number): number | undefined {
  const down = new THREE.Raycaster(new THREE.Vector3(x, REACH, z), new THREE.Vector3(0, -1, 0), 0, 2 * REACH);
  return pickRendered(view, down)?.point.y;
}

/** In the server's world, as it was in the picture if that is given; undefined when the server does not say. */
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

/** Which of the two counts. The picture is some tens of milliseconds behind the server: of a body that moves, the server's answer
 * is about another moment than the one in which the person aimed, so there what was seen counts. */
export function choosePick(
  drawn: Pick | undefined,
  fromServer: { hit: Pick | undefined } | undefined,
  moves: (entity: number) => boolean,
): Pick | undefined {
  if (!fromServer) return drawn;
  if (drawn && drawn.entity !== fromServer.hit?.entity && moves(drawn.entity)) return drawn;
  return fromServer.hit;
}
