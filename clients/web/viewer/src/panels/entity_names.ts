// Display names of bodies.

import type { Entity } from '@jostle/client/gen/play_pb';
import type { Shape } from '@jostle/client/gen/scene_pb';

const KIND_NAMES: Record<string, string> = { heightField: 'height field' };

export function shapeKindName(shape: Shape | undefined): string {
  const kind = shape?.kind.case;
  return kind === undefined ? 'shape' : (KIND_NAMES[kind] ?? kind);
}

/** The name in the scene, or else the kind of the first shape and the id. */
export function entityName(entity: Entity | undefined, id: number): string {
  if (!entity) return `body ${id}`;
  const kind = shapeKindName(entity.shapes[0]);
  return entity.name || `${kind === 'sphere' ? 'ball' : kind} ${id}`;
}

/** One line about the body under the pointer. */
export function describePick(entity: Entity | undefined, pick: { entity: number; shape: number; distance: number }): string {
  const parts = [
    entity?.name || 'no name',
    `id ${pick.entity}`,
    shapeKindName(entity?.shapes[pick.shape]),
    `${pick.distance.toFixed(pick.distance < 10 ? 2 : 1)} m away`,
  ];
  return parts.join(' · ');
}
