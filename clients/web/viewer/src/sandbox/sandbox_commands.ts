// The commands of the sandbox tools as inputs. The server decides whether the client may send them; a
// rejection is shown like that of any input.

import type { Input } from '@jostle/client';

type InputKind = NonNullable<Input['kind']>;
type AttributeMessage = NonNullable<NonNullable<Extract<InputKind, { case: 'setAttributes' }>['value']['set']>['attributes']>[number];
type Edit = Extract<InputKind, { case: 'edit' }>['value'];
type RoomKind = NonNullable<Extract<InputKind, { case: 'room' }>['value']['kind']>;

export class SandboxCommands {
  constructor(private readonly send: (kind: InputKind) => number) {}

  setPaused(paused: boolean): void {
    this.room({ case: 'pause', value: { paused } });
  }
  step(steps = 1): void {
    this.room({ case: 'step', value: { steps } });
  }
  setSpeed(percent: number): void {
    this.room({ case: 'speed', value: { percent } });
  }
  rewind(tick: number): void {
    this.room({ case: 'rewind', value: { tick } });
  }
  reset(): void {
    this.room({ case: 'reset', value: {} });
  }

  undo(): void {
    this.send({ case: 'undo', value: {} });
  }
  edit(entity: number, changes: Omit<Edit, '$typeName' | '$unknown' | 'entity'>): void {
    this.send({ case: 'edit', value: { ...changes, entity } });
  }
  setFrozen(entity: number, frozen: boolean): void {
    this.edit(entity, { frozen });
  }
  clone(entity: number, offset: { x: number; y: number; z: number }, jointed: boolean): void {
    this.send({ case: 'clone', value: { entity, offset, jointed } });
  }
  /** Removes the attribute if it has no value. Returns the sequence of the input. */
  setAttribute(entity: number, attribute: AttributeMessage): number {
    return this.send({ case: 'setAttributes', value: { set: { target: { case: 'entity', value: entity }, attributes: [attribute] } } });
  }
  delete(entity: number): void {
    this.send({ case: 'delete', value: { entity } });
  }
  deleteJoint(joint: number): void {
    this.send({ case: 'deleteJoint', value: { joint } });
  }

  private room(kind: RoomKind): void {
    this.send({ case: 'room', value: { kind } });
  }
}
