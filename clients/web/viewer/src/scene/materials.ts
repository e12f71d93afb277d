// Materials of bodies. Marks that show the orientation of a body are computed by the shader from the
// position on the unit geometry, so that instances of all sizes share one geometry: dark edges on
// boxes, a belt on spheres, a stripe on cylinders and cones, lines on the ground. Hulls and meshes have
// the distances to their creases as an attribute.

import * as THREE from 'three';
import type { Kind } from './shape_parts';

const VERTEX_HEAD = `
varying vec3 vUnit;  // on the unit geometry
varying vec3 vSize; // m, half extents
`;
const VERTEX_BODY = `
vUnit = position;
vSize = vec3(length(instanceMatrix[0].xyz), length(instanceMatrix[1].xyz), length(instanceMatrix[2].xyz));
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
vec2 meters = vUnit.xz * vSize.xz;
for (int i = 0; i < 2; i++) {
  float spacing = i == 0 ? 1.0 : 5.0;
  vec2 at = meters / spacing;
  vec2 blur = max(fwidth(at), vec2(1e-6));
  vec2 away = abs(fract(at - 0.5) - 0.5) / blur;
  vec2 line = (1.0 - min(away, 1.0)) * (1.0 - smoothstep(0.15, 0.5, blur));
  diffuseColor.rgb *= 1.0 - (i == 0 ? 0.10 : 0.16) * max(line.x, line.y);
}
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

export function materialFor(kind: Kind): THREE.Material {
  const ground = kind === 'slab' || kind === 'plane' || kind === 'field';
  const creased = kind === 'hull' || kind === 'mesh';
  const material = new THREE.MeshStandardMaterial({
    roughness: ground ? 0.95 : 0.6,
    metalness: 0,
    flatShading: kind === 'field',
    // Terrain and open meshes are visible from both sides.
    side: kind === 'field' || kind === 'mesh' ? THREE.DoubleSide : THREE.FrontSide,
  });
  const marks = MARKS[kind];
  if (marks === undefined) return material;
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>${creased ? FACET_VERTEX_HEAD : VERTEX_HEAD}`)
      .replace('#include <begin_vertex>', `#include <begin_vertex>${creased ? FACET_VERTEX_BODY : VERTEX_BODY}`);
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', `#include <common>${creased ? FACET_FRAGMENT_HEAD : VERTEX_HEAD}`)
      .replace('#include <color_fragment>', `#include <color_fragment>${marks}`);
  };
  material.customProgramCacheKey = () => marks;
  return material;
}

/** Sky dome: the color of the fog at the horizon, darker above. */
export function makeSky(horizon: THREE.Color, above: THREE.Color): THREE.Mesh {
  const material = new THREE.ShaderMaterial({
    side: THREE.BackSide,
    depthWrite: false,
    depthTest: false,
    fog: false,
    toneMapped: false,
    uniforms: { horizon: { value: horizon }, above: { value: above } },
    vertexShader: `
      varying vec3 vDirection;
      void main() {
        vDirection = position;
        gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0);
      }`,
    fragmentShader: `
      uniform vec3 horizon;
      uniform vec3 above;
      varying vec3 vDirection;
      void main() {
        float height = max(0.0, normalize(vDirection).y);
        gl_FragColor = vec4(mix(horizon, above, pow(min(1.0, height * 2.2), 0.7)), 1.0);
        #include <colorspace_fragment>
      }`,
  });
  const sky = new THREE.Mesh(new THREE.SphereGeometry(100, 24, 16), material);
  sky.frustumCulled = false;
  sky.renderOrder = -1;
  return sky;
}
