// Water with waves: a sheet about what the camera looks at, lifted by the same sums of waves as the server's (waves.h of the module
// "fields"). The graphics processor does it all; each picture it is given a few numbers.

import * as THREE from 'three';

export interface Wave {
  amplitude: number; // m
  number: number; // 1/m
  x: number; // where its crests go
  z: number;
  turn: number; // rad, of this moment
}

export interface WaterSurface {
  level: number; // m
  waves: readonly Wave[];
}

const WAVES_MAX = 8;
const REACH = 260; // m from the middle
const CELLS = 112;
const DENSE = 0.22; // how much finer its middle is than its rim

/** Height of the surface over a place; what the shader does. */
export function heightAt({ level, waves }: WaterSurface, x: number, z: number): number {
  return waves.reduce((y, wave) => y + wave.amplitude * Math.cos(wave.number * (wave.x * x + wave.z * z) + wave.turn), level);
}

const VERTEX = `
uniform float level;
uniform vec2 middle;
uniform int count;
uniform vec2 waves[${WAVES_MAX}];  // amplitude, turn
uniform vec2 ways[${WAVES_MAX}];   // number times direction
varying vec3 vPlace;
varying float vCrest;
#include <fog_pars_vertex>
void main() {
  vec2 at = middle + position.xz;
  float lift = 0.0;
  for (int i = 0; i < ${WAVES_MAX}; i++)
    if (i < count) lift += waves[i].x * cos(dot(ways[i], at) + waves[i].y);
  vCrest = lift;
  vPlace = vec3(at.x, level + lift, at.y);
  vec4 mvPosition = viewMatrix * vec4(vPlace, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`;
const FRAGMENT = `
uniform int count;
uniform vec2 waves[${WAVES_MAX}];
uniform vec2 ways[${WAVES_MAX}];
uniform float highest;
uniform vec3 sun;
varying vec3 vPlace;
varying float vCrest;
#include <common>
#include <fog_pars_fragment>
void main() {
  vec2 slope = vec2(0.0);
  for (int i = 0; i < ${WAVES_MAX}; i++)
    if (i < count) slope -= waves[i].x * ways[i] * sin(dot(ways[i], vPlace.xz) + waves[i].y);
  // Ripples that only shine, and only near by.
  float away = length(cameraPosition - vPlace);
  float near = exp(-away / 25.0);
  vec2 p = vPlace.xz;
  float t = waves[0].y;
  slope += near * 0.06 * vec2(sin(3.1 * p.x + 1.7 * p.y - 2.1 * t) + sin(1.3 * p.x - 4.3 * p.y + 3.3 * t), sin(2.3 * p.y - 2.9 * p.x + 2.7 * t));
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  vec3 toEye = normalize(cameraPosition - vPlace);
  if (dot(normal, toEye) < 0.0) normal = -normal;
  float mirror = 0.03 + 0.97 * pow(1.0 - max(0.0, dot(normal, toEye)), 5.0);
  vec3 deep = vec3(0.012, 0.10, 0.14);
  vec3 shallow = vec3(0.04, 0.26, 0.30);
  vec3 sky = vec3(0.20, 0.32, 0.44);
  float crest = highest > 0.0 ? vCrest / highest : 0.0;
  vec3 color = mix(mix(deep, shallow, 0.5 + 0.5 * crest), sky, mirror);
  color += vec3(1.0, 0.94, 0.8) * 0.9 * pow(max(0.0, dot(reflect(-toEye, normal), sun)), 90.0);
  color = mix(color, vec3(0.75, 0.82, 0.85), 0.14 * smoothstep(0.7, 1.0, crest));
  gl_FragColor = vec4(color, mix(0.78, 0.97, mirror));
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #include <fog_fragment>
}`;

export class Water {
  private readonly sheets: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>[] = [];
  private used = 0;
  readonly drawn: WaterSurface[] = [];

  constructor(private readonly scene: THREE.Scene) {}

  begin(): void {
    this.used = 0;
    this.drawn.length = 0;
  }

  /** About that place. */
  add(look: WaterSurface, around: { x: number; z: number }): void {
    this.drawn.push(look);
    const sheet = (this.sheets[this.used++] ??= this.make());
    sheet.visible = true;
    const { uniforms } = sheet.material;
    uniforms['level']!.value = look.level;
    uniforms['middle']!.value.set(around.x, around.z);
    uniforms['count']!.value = Math.min(WAVES_MAX, look.waves.length);
    uniforms['highest']!.value = look.waves.reduce((sum, wave) => sum + wave.amplitude, 0);
    look.waves.slice(0, WAVES_MAX).forEach((wave, k) => {
      uniforms['waves']!.value[k].set(wave.amplitude, wave.turn);
      uniforms['ways']!.value[k].set(wave.number * wave.x, wave.number * wave.z);
    });
  }

  end(): void {
    for (let k = this.used; k < this.sheets.length; k++) this.sheets[k]!.visible = false;
  }

  private make(): THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial> {
    const pairs = () => Array.from({ length: WAVES_MAX }, () => new THREE.Vector2());
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: THREE.UniformsUtils.merge([
        THREE.UniformsLib.fog,
        {
          level: { value: 0 },
          middle: { value: new THREE.Vector2() },
          count: { value: 0 },
          highest: { value: 0 },
          waves: { value: pairs() },
          ways: { value: pairs() },
          sun: { value: new THREE.Vector3(18, 30, 12).normalize() },
        },
      ]),
      transparent: true,
      depthWrite: false,
      side: THREE.DoubleSide,
      fog: true,
    });
    const sheet = new THREE.Mesh(sheetGeometry(), material);
    sheet.frustumCulled = false; // the shader moves it
    this.scene.add(sheet);
    return sheet;
  }
}

/** A square of cells that are small in the middle, where one is near. */
function sheetGeometry(): THREE.BufferGeometry {
  const geometry = new THREE.PlaneGeometry(2, 2, CELLS, CELLS).rotateX(-Math.PI / 2);
  const place = geometry.getAttribute('position');
  const stretched = (u: number) => REACH * (DENSE * u + (1 - DENSE) * u ** 3);
  for (let k = 0; k < place.count; k++) place.setXYZ(k, stretched(place.getX(k)), 0, stretched(place.getZ(k)));
  return geometry;
}
