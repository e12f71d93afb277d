// Light, sky and fog of a world. The sun casts sharp shadows; the light of the zenith casts wide, soft
// ones, which darken the ground under bodies and the gaps between them. Shadows follow the target of the
// camera.

import * as THREE from 'three';
import type { QualityLevel } from './quality';

export interface Palette {
  readonly horizon: number;
  readonly zenith: number;
  readonly ground: number; // light that the ground reflects
  readonly exposure: number;
}

export const PALETTES: Record<'dark' | 'light', Palette> = {
  dark: { horizon: 0x6d8299, zenith: 0x27384c, ground: 0x6a645b, exposure: 1 },
  light: { horizon: 0xdce8f2, zenith: 0x7eb0de, ground: 0x8d877c, exposure: 1.15 },
};

const SUN = new THREE.Vector3(-14, 28, 17).normalize();
const SUN_DISTANCE = 60; // m, beyond the reach of the shadows
const REACH_MIN = 14; // m from the target of the camera
const REACH_MAX = 224;
const GRAINS = 16; // steps of the shadow position per reach, so that camera moves do not make edges crawl
const CONTACT_PIXELS = 512;
const FOG_NEAR = 2.2; // camera distances
const FOG_FAR = 9;
const FOG_NEAR_MIN = 70; // m
const FOG_FAR_MIN = 260;
const FOG_FAR_MAX = 1900; // the edge of planes is not visible

export class Environment {
  readonly sun = new THREE.DirectionalLight(0xfff3e2, 2.3);
  readonly zenith = new THREE.DirectionalLight(0xdfeaf7, 0.65);
  private readonly sky = new THREE.HemisphereLight(0xdbe8f8, 0x6a645b, 1.65);
  private readonly fog = new THREE.Fog(0, FOG_NEAR_MIN, FOG_FAR_MIN);
  private readonly dome = makeSky();
  private reach = 0;

  constructor(scene: THREE.Scene) {
    scene.fog = this.fog;
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.03;
    this.sun.shadow.radius = 2;
    this.zenith.shadow.bias = -0.002;
    this.zenith.shadow.normalBias = 0.05;
    this.zenith.shadow.radius = 7;
    this.zenith.shadow.mapSize.set(CONTACT_PIXELS, CONTACT_PIXELS);
    scene.add(this.dome, this.sky, this.sun, this.sun.target, this.zenith, this.zenith.target);
    this.setPalette(PALETTES.dark);
  }

  setPalette({ horizon, zenith, ground }: Palette): void {
    this.fog.color.set(horizon);
    this.dome.material.uniforms['horizon']!.value.set(horizon);
    this.dome.material.uniforms['above']!.value.set(zenith);
    this.sky.groundColor.set(ground);
  }

  setQuality({ sunShadowPixels, contactShadows }: QualityLevel): void {
    this.sun.castShadow = sunShadowPixels > 0;
    this.zenith.castShadow = contactShadows;
    if (sunShadowPixels === 0 || this.sun.shadow.mapSize.x === sunShadowPixels) return;
    this.sun.shadow.mapSize.set(sunShadowPixels, sunShadowPixels);
    this.sun.shadow.map?.dispose();
    this.sun.shadow.map = null;
  }

  /** `distance`: from the camera to its target, in m. `flat`: an orthographic view, which has no depth. */
  update(target: THREE.Vector3, distance: number, flat: boolean): void {
    this.fog.near = flat ? 1e6 : Math.max(FOG_NEAR_MIN, FOG_NEAR * distance);
    this.fog.far = flat ? 2e6 : Math.min(FOG_FAR_MAX, Math.max(FOG_FAR_MIN, FOG_FAR * distance));
    const reach = shadowReach(distance);
    if (reach !== this.reach) {
      this.reach = reach;
      for (const { shadow } of [this.sun, this.zenith]) {
        Object.assign(shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 1, far: SUN_DISTANCE + 3 * reach });
        shadow.camera.updateProjectionMatrix();
      }
    }
    const grain = reach / GRAINS;
    const { position } = this.sun.target;
    position.copy(target).divideScalar(grain).round().multiplyScalar(grain);
    this.zenith.target.position.copy(position);
    this.sun.position.copy(position).addScaledVector(SUN, SUN_DISTANCE + reach);
    this.zenith.position.copy(position).add(new THREE.Vector3(0, SUN_DISTANCE + reach, 0.01));
  }
}

/** Half the width of the shadowed area, in m: the next power of two times the minimum. */
export function shadowReach(distance: number): number {
  return Math.min(REACH_MAX, REACH_MIN * 2 ** Math.max(0, Math.ceil(Math.log2(distance / REACH_MIN))));
}

/** Sky dome: the color of the fog at the horizon and below it, darker above. */
function makeSky(): THREE.Mesh<THREE.SphereGeometry, THREE.ShaderMaterial> {
  const material = new THREE.ShaderMaterial({
    side: THREE.BackSide,
    depthWrite: false,
    depthTest: false,
    fog: false,
    toneMapped: false,
    uniforms: { horizon: { value: new THREE.Color() }, above: { value: new THREE.Color() } },
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
