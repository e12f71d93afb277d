// What is under the pointer, among what is drawn.

import * as THREE from 'three';
import type { SceneView } from './scene_view';

export interface Pick {
  entity: number;
  point: THREE.Vector3;
  normal: THREE.Vector3;
}

export function pick(view: SceneView, raycaster: THREE.Raycaster): Pick | undefined {
  for (const hit of raycaster.intersectObjects(view.objects, false)) {
    if (hit.instanceId === undefined) continue;
    const { entity } = view.ownerAt(hit.object, hit.instanceId);
    if (entity === 0) continue;
    const normal = hit.face?.normal.clone() ?? new THREE.Vector3(0, 1, 0);
    const instance = new THREE.Matrix4();
    (hit.object as THREE.InstancedMesh).getMatrixAt(hit.instanceId, instance);
    normal.applyNormalMatrix(new THREE.Matrix3().getNormalMatrix(instance)).normalize();
    return { entity, point: hit.point, normal };
  }
  return undefined;
}
