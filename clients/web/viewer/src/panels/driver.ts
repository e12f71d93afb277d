// The line on driving: what can be driven here, how to take its wheel, what the keys do, how fast it goes. Arrows stand over what
// can be driven while one may choose.

import * as THREE from 'three';
import type { Entity } from '@jostle/client/gen/play_pb';
import type { Solids } from '../scene/solids';
import { entityName } from './entity_names';

const CHOICES_MAX = 12;
const ARROW = new THREE.Color(0xffd166);
const ARROW_HEIGHT = 2.4; // m over what it stands on
const DOWNWARDS = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(1, 0, 0), Math.PI);

export interface DriverState {
  choosing: boolean; // the tool is chosen
  driven: Entity | undefined;
  keys: string; // of what is driven
  words: string; // on what is driven
  general: string; // of the world
}

export class DriverPanel {
  private readonly line = document.createElement('p');
  private readonly keys = document.createElement('p');
  private readonly choices = document.createElement('p');
  private shown = '';
  private offered = '';

  constructor(
    private readonly panel: HTMLElement,
    private readonly take: (entity: number) => void,
    private readonly stopControlling: () => void,
  ) {
    this.keys.className = 'keys';
    panel.append(this.line, this.keys, this.choices);
  }

  /** Once a picture: touches the page only when something is to be said anew. */
  update(state: DriverState, controllable: readonly Entity[]): void {
    const { choosing, driven, keys, words, general } = state;
    this.panel.hidden = !choosing && !driven && general === '';
    if (this.panel.hidden) return;
    const told = driven
      ? `You drive ${entityName(driven, driven.id)}${words && ` · ${words}`}`
      : choosing
        ? controllable.length > 0
          ? 'Click what stands under an arrow, or choose:'
          : 'Nothing in this world can be driven'
        : general;
    const under = driven ? `${keys || 'W A S D or arrows, space, shift, E and Q'} · gamepad · Esc lets go` : '';
    if (this.shown !== told + under) {
      this.shown = told + under;
      this.line.textContent = told;
      this.keys.textContent = under;
    }
    this.offer(driven || !choosing ? [] : controllable.slice(0, CHOICES_MAX), driven !== undefined);
  }

  private offer(choices: readonly Entity[], drives: boolean): void {
    const offered = `${drives} ${choices.map(({ id }) => id).join()}`;
    if (this.offered === offered) return;
    this.offered = offered;
    const button = (label: string, click: () => void) => {
      const made = document.createElement('button');
      made.type = 'button';
      made.textContent = label;
      made.onclick = () => {
        made.blur(); // keys drive from now on
        click();
      };
      return made;
    };
    this.choices.replaceChildren(
      ...choices.map(({ id, name }) => button(name || `${id}`, () => this.take(id))),
      ...(drives ? [button('Let go', () => this.stopControlling())] : []),
    );
  }
}

/** An invitation. */
export function offerText(controllable: readonly Entity[]): string {
  if (controllable.length === 0) return '';
  return controllable.length === 1 ? `Press 8 to drive ${entityName(controllable[0], controllable[0]!.id)}` : `Press 8 to drive one of ${controllable.length}`;
}

const place = new THREE.Vector3();
const size = new THREE.Vector3(0.28, 0.45, 0.28);

/** An arrow over each; they bob. */
export function drawArrows(
  solids: Solids,
  controllable: readonly Entity[],
  poseOf: (entity: number) => ArrayLike<number> | undefined,
  nowMs: number,
): void {
  const bob = 0.15 * Math.sin(nowMs / 250);
  for (const { id } of controllable) {
    const pose = poseOf(id);
    if (pose) solids.add('cone', place.set(pose[0]!, pose[1]! + ARROW_HEIGHT + bob, pose[2]!), DOWNWARDS, size, ARROW);
  }
}
