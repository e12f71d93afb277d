// Materials of bodies, by the kind of a part and the surface of its body. Marks are computed by the
// shader from the position on the unit geometry, so that instances of all sizes share one geometry: dark
// edges on boxes, a belt on spheres, a stripe on cylinders and cones, a grid of 1 m and 10 m on the
// ground. Hulls and meshes have the distances to their creases as an attribute. Kinematic bodies have
// diagonal stripes; triggers are glass.

import * as THREE from 'three';
import type { Kind } from './shape_parts';

/** solid: a dynamic body. glass: a trigger. */
export type Surface = 'solid' | 'static' | 'kinematic' | 'glass';

export const GROUND_KINDS: readonly Kind[] = ['slab', 'plane', 'field'];

const HEAD = `
varying vec3 vUnit;  // on the unit geometry
varying vec3 vSize; // m, half extents
varying vec2 vGrid;  // m
`;
// The lines of level ground are at whole metres of the world; those of a slope are in its own axes.
const VERTEX_BODY = `
vUnit = position;
vSize = vec3(length(instanceMatrix[0].xyz), length(instanceMatrix[1].xyz), length(instanceMatrix[2].xyz));
vec3 gridPosition = instanceMatrix[1].y > 0.999 * vSize.y ? (instanceMatrix * vec4(position, 1.0)).xyz : position * vSize;
vGrid = gridPosition.xz;
`;
const FACET_VERTEX_HEAD = `
attribute vec3 edge;
varying vec3 vEdge;  // m to each side of the triangle
`;
const FACET_VERTEX_BODY = `
vEdge = edge;
`;
const FACET_FRAGMENT_HEAD = `
varying vec3 vEdge;
`;

const DARK_EDGE = `
float width = 0.018;
float blur = max(fwidth(toEdge), 1e-5);
float rim = (1.0 - smoothstep(width - blur, width + blur, toEdge)) * min(1.0, width / blur);
diffuseColor.rgb *= 1.0 - 0.45 * rim;
`;
const EDGES = `
vec3 inward = (1.0 - abs(vUnit)) * vSize;
float toEdge = max(min(inward.x, inward.y), min(max(inward.x, inward.y), inward.z));
${DARK_EDGE}`;
const CREASES = `
float toEdge = min(vEdge.x, min(vEdge.y, vEdge.z));
${DARK_EDGE}`;
const STRIPE = `
float aside = abs(vUnit.x) * vSize.x;
float band = 0.2 * vSize.x;
float soft = max(fwidth(aside), 1e-5);
float stripe = 1.0 - smoothstep(band - soft, band + soft, aside);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(1.0), 0.34 * stripe);
`;
// A rim is where the side meets a disc: both the radial and the axial distance are small there.
const ROUND_RIMS = `
float toEdge = max((1.0 - length(vUnit.xz)) * vSize.x, (1.0 - abs(vUnit.y)) * vSize.y);
${DARK_EDGE}`;
const CONE_RIM = `
float toEdge = max((1.0 - length(vUnit.xz)) * vSize.x, (1.0 + vUnit.y) * vSize.y);
${DARK_EDGE}`;
const BELT = `
float across = abs(vUnit.y);
float soft = max(fwidth(across), 1e-5);
float belt = 1.0 - smoothstep(0.26 - soft, 0.26 + soft, across);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(1.0), 0.42 * belt);
`;
const LINES = `
for (int i = 0; i < 2; i++) {
  vec2 at = vGrid / (i == 0 ? 1.0 : 10.0);
  vec2 blur = max(fwidth(at), vec2(1e-6));
  vec2 away = abs(fract(at - 0.5) - 0.5) / blur;
  vec2 line = (1.0 - min(away, 1.0)) * (1.0 - smoothstep(0.15, 0.5, blur));
  diffuseColor.rgb *= 1.0 - (i == 0 ? 0.16 : 0.30) * max(line.x, line.y);
}
`;
// 0.25 m wide, and at least four on a body.
const HAZARD = `
vec3 hazardAt = vUnit * vSize;
float hazardWidth = min(0.25, 0.35 * max(vSize.x, max(vSize.y, vSize.z)));
float hazard = (hazardAt.x + hazardAt.y + hazardAt.z) / hazardWidth;
float hazardBlur = max(fwidth(hazard), 1e-5);
float hazardStripe = smoothstep(0.5 - hazardBlur, 0.5 + hazardBlur, abs(fract(0.5 * hazard) - 0.5) * 2.0);
diffuseColor.rgb = mix(diffuseColor.rgb, mix(vec3(0.03), vec3(0.95, 0.62, 0.08), hazardStripe), 0.45 * (1.0 - smoothstep(0.5, 1.5, hazardBlur)));
`;
// Glass is clearer where it is seen from the front.
const GLASS = `
float facing = abs(dot(normalize(cross(dFdx(vViewPosition), dFdy(vViewPosition))), normalize(vViewPosition)));
diffuseColor.a *= mix(0.55, 0.16, facing);
`;
const MARKS: Partial<Record<Kind, string>> = {
  box: EDGES,
  sphere: BELT,
  slab: LINES,
  plane: LINES,
  field: LINES,
  cylinder: STRIPE + ROUND_RIMS,
  cone: STRIPE + CONE_RIM,
  hull: CREASES,
  mesh: CREASES,
};

const ROUGHNESS: Record<Surface, number> = { solid: 0.48, static: 0.85, kinematic: 0.4, glass: 0.12 };

export function materialFor(kind: Kind, surface: Surface): THREE.Material {
  const ground = GROUND_KINDS.includes(kind);
  const creased = kind === 'hull' || kind === 'mesh';
  const glass = surface === 'glass';
  const material = new THREE.MeshStandardMaterial({
    roughness: ground && !glass ? 0.95 : ROUGHNESS[surface],
    metalness: surface === 'kinematic' ? 0.25 : 0,
    flatShading: kind === 'field',
    transparent: glass,
    depthWrite: !glass,
    // Terrain and open meshes are visible from both sides.
    side: kind === 'field' || kind === 'mesh' || glass ? THREE.DoubleSide : THREE.FrontSide,
  });
  const marks = (MARKS[kind] ?? '') + (surface === 'kinematic' ? HAZARD : glass ? GLASS : '');
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>${HEAD}${creased ? FACET_VERTEX_HEAD : ''}`)
      .replace('#include <begin_vertex>', `#include <begin_vertex>${VERTEX_BODY}${creased ? FACET_VERTEX_BODY : ''}`);
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', `#include <common>${HEAD}${creased ? FACET_FRAGMENT_HEAD : ''}`)
      .replace('#include <color_fragment>', `#include <color_fragment>${marks}`);
  };
  material.customProgramCacheKey = () => marks + String(creased);
  return material;
}
