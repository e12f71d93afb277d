// Water with waves: a sheet around the target of the camera, displaced by the same sum of waves as on
// the server (waves.h of the module "fields"). The shader evaluates it; a rendered frame only updates
// uniforms.

import * as THREE from 'three';

export interface Wave {
  amplitude: number; // m
  number: number; // 1/m
  x: number; // direction of travel
  z: number;
  phase: number; // rad, at the rendered time
}

export interface WaterSurface {
  level: number; // m
  waves: readonly Wave[];
}

const WAVES_MAX = 8;
const REACH = 260; // m, from the center
const CELLS = 112;
const CENTER_CELL_SIZE = 0.22; // cell size at the center, relative to an even grid

/** Height of the surface at a position, as computed by the shader. */
export function heightAt({ level, waves }: WaterSurface, x: number, z: number): number {
  return waves.reduce((y, wave) => y + wave.amplitude * Math.cos(wave.number * (wave.x * x + wave.z * z) + wave.phase), level);
}

const VERTEX = `
uniform float level;
uniform vec2 center;
uniform int count;
uniform vec2 waves[${WAVES_MAX}];  // amplitude, phase
uniform vec2 waveVectors[${WAVES_MAX}];   // number times direction
varying vec3 vPosition;
varying float vCrest;
#include <fog_pars_vertex>
void main() {
  vec2 at = center + position.xz;
  float lift = 0.0;
  for (int i = 0; i < ${WAVES_MAX}; i++)
    if (i < count) lift += waves[i].x * cos(dot(waveVectors[i], at) + waves[i].y);
  vCrest = lift;
  vPosition = vec3(at.x, level + lift, at.y);
  vec4 mvPosition = viewMatrix * vec4(vPosition, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`;
const FRAGMENT = `
uniform int count;
uniform vec2 waves[${WAVES_MAX}];
uniform vec2 waveVectors[${WAVES_MAX}];
uniform float highest;
uniform vec3 sun;
varying vec3 vPosition;
varying float vCrest;
#include <common>
#include <fog_pars_fragment>
void main() {
  vec2 slope = vec2(0.0);
  for (int i = 0; i < ${WAVES_MAX}; i++)
    if (i < count) slope -= waves[i].x * waveVectors[i] * sin(dot(waveVectors[i], vPosition.xz) + waves[i].y);
  // Ripples: only in the normals, and only near the camera.
  float away = length(cameraPosition - vPosition);
  float near = exp(-away / 25.0);
  vec2 p = vPosition.xz;
  float t = waves[0].y;
  slope += near * 0.06 * vec2(sin(3.1 * p.x + 1.7 * p.y - 2.1 * t) + sin(1.3 * p.x - 4.3 * p.y + 3.3 * t), sin(2.3 * p.y - 2.9 * p.x + 2.7 * t));
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  vec3 toEye = normalize(cameraPosition - vPosition);
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
  readonly surfaces: WaterSurface[] = [];

  constructor(private readonly scene: THREE.Scene) {}

  begin(): void {
    this.used = 0;
    this.surfaces.length = 0;
  }

  /** Adds a surface around the target of the camera. */
  add(surface: WaterSurface, cameraTarget: { x: number; z: number }): void {
    this.surfaces.push(surface);
    const sheet = (this.sheets[this.used++] ??= this.make());
    sheet.visible = true;
    const { uniforms } = sheet.material;
    uniforms['level']!.value = surface.level;
    uniforms['center']!.value.set(cameraTarget.x, cameraTarget.z);
    uniforms['count']!.value = Math.min(WAVES_MAX, surface.waves.length);
    uniforms['highest']!.value = surface.waves.reduce((sum, wave) => sum + wave.amplitude, 0);
    surface.waves.slice(0, WAVES_MAX).forEach((wave, k) => {
      uniforms['waves']!.value[k].set(wave.amplitude, wave.phase);
      uniforms['waveVectors']!.value[k].set(wave.number * wave.x, wave.number * wave.z);
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
          center: { value: new THREE.Vector2() },
          count: { value: 0 },
          highest: { value: 0 },
          waves: { value: pairs() },
          waveVectors: { value: pairs() },
          sun: { value: new THREE.Vector3(-14, 28, 17).normalize() },
        },
      ]),
      transparent: true,
      depthWrite: false,
      side: THREE.DoubleSide,
      fog: true,
    });
    const sheet = new THREE.Mesh(sheetGeometry(), material);
    sheet.frustumCulled = false; // displaced by the shader
    this.scene.add(sheet);
    return sheet;
  }
}

/** A square grid with smaller cells at the center, near the camera. */
function sheetGeometry(): THREE.BufferGeometry {
  const geometry = new THREE.PlaneGeometry(2, 2, CELLS, CELLS).rotateX(-Math.PI / 2);
  const positions = geometry.getAttribute('position');
  const stretched = (u: number) => REACH * (CENTER_CELL_SIZE * u + (1 - CENTER_CELL_SIZE) * u ** 3);
  for (let k = 0; k < positions.count; k++) positions.setXYZ(k, stretched(positions.getX(k)), 0, stretched(positions.getZ(k)));
  return geometry;
}
