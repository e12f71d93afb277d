// Control line: which entities can be controlled, how to take control, the keys, and the status. Arrows
// mark controllable entities while the tool is selected.

import * as THREE from 'three';
import type { Entity } from '@jostle/client/gen/play_pb';
import type { Solids } from '../scene/solids';
import { entityName } from './entity_names';

const CHOICES_MAX = 12;
const ARROW = new THREE.Color(0xffd166);
const ARROW_HEIGHT = 2.4; // m above the entity
const DOWNWARDS = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(1, 0, 0), Math.PI);

export interface DriverState {
  toolSelected: boolean; // the tool is selected
  controlled: Entity | undefined;
  keys: string; // of the controlled entity
  status: string; // of the controlled entity
  worldStatus: string; // of the world
  touch: boolean; // on-screen controls replace the keys
}

export class DriverPanel {
  private readonly line = document.createElement('p');
  private readonly keys = document.createElement('p');
  private readonly choices = document.createElement('p');
  private renderedText = '';
  private offered = '';

  constructor(
    private readonly panel: HTMLElement,
    private readonly take: (entity: number) => void,
    private readonly stopControlling: () => void,
  ) {
    this.keys.className = 'keys';
    panel.append(this.line, this.keys, this.choices);
  }

  /** Call once per rendered frame; changes the DOM only when the text changes. */
  update(state: DriverState, controllable: readonly Entity[]): void {
    const { toolSelected, controlled, keys, status, worldStatus, touch } = state;
    this.panel.hidden = !toolSelected && !controlled && worldStatus === '';
    if (this.panel.hidden) return;
    const text = controlled
      ? `Driving ${entityName(controlled, controlled.id)}${status && ` · ${status}`}`
      : toolSelected
        ? controllable.length > 0
          ? `${touch ? 'Tap' : 'Click'} an entity below an arrow, or choose one:`
          : 'This world has no controllable entities'
        : worldStatus;
    const help = controlled && !touch ? `${keys || 'W A S D or arrows, Space, Shift, E and Q'} · gamepad · Esc releases` : '';
    if (this.renderedText !== text + help) {
      this.renderedText = text + help;
      this.line.textContent = text;
      this.keys.textContent = help;
    }
    this.offer(controlled || !toolSelected ? [] : controllable.slice(0, CHOICES_MAX), controlled !== undefined);
  }

  private offer(choices: readonly Entity[], canRelease: boolean): void {
    const offered = `${canRelease} ${choices.map(({ id }) => id).join()}`;
    if (this.offered === offered) return;
    this.offered = offered;
    const button = (label: string, click: () => void) => {
      const created = document.createElement('button');
      created.type = 'button';
      created.textContent = label;
      created.onclick = () => {
        created.blur(); // keys control the entity from now on
        click();
      };
      return created;
    };
    this.choices.replaceChildren(
      ...choices.map(({ id, name }) => button(name || `${id}`, () => this.take(id))),
      ...(canRelease ? [button('Release', () => this.stopControlling())] : []),
    );
  }
}

/** An invitation to take control; empty without controllable entities. */
export function offerText(controllable: readonly Entity[], touch = false): string {
  if (controllable.length === 0) return '';
  const how = touch ? 'Select Drive to control' : 'Press 8 to drive';
  return controllable.length === 1 ? `${how} ${entityName(controllable[0], controllable[0]!.id)}` : `${how} one of ${controllable.length} entities`;
}

const position = new THREE.Vector3();
const size = new THREE.Vector3(0.28, 0.45, 0.28);

/** A bobbing arrow above each entity. */
export function drawArrows(
  solids: Solids,
  controllable: readonly Entity[],
  poseOf: (entity: number) => ArrayLike<number> | undefined,
  nowMs: number,
): void {
  const bob = 0.15 * Math.sin(nowMs / 250);
  for (const { id } of controllable) {
    const pose = poseOf(id);
    if (pose) solids.add('cone', position.set(pose[0]!, pose[1]! + ARROW_HEIGHT + bob, pose[2]!), DOWNWARDS, size, ARROW);
  }
}
