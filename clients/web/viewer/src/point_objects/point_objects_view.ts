// Draws the point objects of a world: ropes, cloth, particles and heights.

import * as THREE from 'three';
import type { PointObjectView } from '@jostle/client';
import { pointDrawer, type PointDrawer } from './point_drawers';

/** In Hello.channels: all channel kinds with point objects. */
export const POINT_CHANNEL_KINDS = 'points:*';

export class PointObjectsView {
  private readonly drawers = new Map<PointObjectView, PointDrawer>();

  constructor(private readonly scene: THREE.Scene) {}

  /** Call once per rendered frame, after the objects were sampled. `poseOf`: of an entity. */
  update(objects: ReadonlyMap<number, PointObjectView>, poseOf: (entity: number) => ArrayLike<number> | undefined): void {
    const present = new Set(objects.values());
    for (const [view, drawer] of this.drawers) if (!present.has(view)) this.remove(view, drawer);
    for (const view of present) {
      if (!view.hasPoints) continue;
      const drawer = this.drawerOf(view);
      drawer.object.visible = this.place(drawer.object, view.description.entity, poseOf);
      if (drawer.object.visible) drawer.update(view);
    }
  }

  /** For tests: number of drawn objects. */
  get count(): number {
    return [...this.drawers.values()].filter(({ object }) => object.visible).length;
  }

  /** Moves an object to its entity. Returns false if the entity is not in the rendered frame. */
  private place(object: THREE.Object3D, entity: number, poseOf: (entity: number) => ArrayLike<number> | undefined): boolean {
    if (entity === 0) return true;
    const pose = poseOf(entity);
    if (!pose) return false;
    object.position.set(pose[0]!, pose[1]!, pose[2]!);
    object.quaternion.set(pose[3]!, pose[4]!, pose[5]!, pose[6]!);
    return true;
  }

  private drawerOf(view: PointObjectView): PointDrawer {
    const known = this.drawers.get(view);
    if (known) return known;
    const made = pointDrawer(view);
    this.drawers.set(view, made);
    this.scene.add(made.object);
    return made;
  }

  private remove(view: PointObjectView, drawer: PointDrawer): void {
    this.scene.remove(drawer.object);
    drawer.dispose();
    this.drawers.delete(view);
  }
}
