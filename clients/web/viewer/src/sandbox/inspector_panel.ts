// The inspector of the selected body or joint.

import type { Connection } from '@jostle/client';
import type { InputResult } from '@jostle/client/gen/play_pb';
import type { InspectedBody, InspectResponse } from '@jostle/client/gen/query_pb';
import type { Action } from '../room/room_rules';
import { AttributeEditor } from './attribute_editor';
import { bodyRows, entityRows, jointKindName, jointRows, type Names, type Row } from './describe_inspected';
import type { SandboxCommands } from './sandbox_commands';
import type { Selection } from './selection';
import { clamp, MASS } from './spawn_options';

const CLONE_OFFSET = { x: 0, y: 1.5, z: 0 }; // m

export interface InspectorOptions {
  readonly connection: Connection;
  readonly selection: Selection;
  readonly commands: SandboxCommands;
  readonly names: Names;
  poseOf(entity: number): ArrayLike<number> | undefined;
  focus(entity: number): void;
  /** The rule that refuses an action on a body; empty: none. */
  refusal(action: Action, entity: number): string;
  jointRefusal(): string;
  /** Why the client may not change attributes of the entity; empty: it may. */
  attributeRefusal(entity: number): string;
}

export class InspectorPanel {
  private readonly title = document.createElement('p');
  private readonly rows = document.createElement('dl');
  private readonly joints = document.createElement('div');
  private readonly actions = document.createElement('div');
  private readonly rights = document.createElement('p');
  private readonly form: EditForm;
  private readonly attributes: AttributeEditor;
  private response: InspectResponse | undefined;

  constructor(
    content: HTMLElement,
    private readonly options: InspectorOptions,
  ) {
    content.className = 'inspector';
    this.title.className = 'title';
    this.title.setAttribute('role', 'status');
    this.actions.className = 'button-row even';
    this.joints.className = 'button-row';
    this.form = new EditForm((changes) => this.options.commands.edit(this.options.selection.body, changes));
    this.attributes = new AttributeEditor({ set: (entity, attribute) => this.options.commands.setAttribute(entity, attribute), refusal: options.attributeRefusal });
    this.rights.className = 'note rights';
    content.append(this.title, this.actions, this.rights, this.rows, this.joints, this.form.element, this.attributes.element);
    options.selection.onChange(() => this.selectionChanged());
    this.selectionChanged();
  }

  private selectionChanged(): void {
    this.show(undefined);
    const { selection, commands, focus } = this.options;
    const { current } = selection;
    const action = (label: string, run: () => void, needed?: Action) => {
      const button = Object.assign(document.createElement('button'), { type: 'button', textContent: label });
      button.onclick = () => button.ariaDisabled !== 'true' && run();
      if (needed) button.dataset['action'] = needed;
      return button;
    };
    if (current?.kind === 'body') {
      const { id } = current;
      this.actions.replaceChildren(
        action('Focus', () => focus(id)),
        action('Freeze', () => commands.setFrozen(id, !this.isFrozen), 'edit'),
        action('Clone', () => commands.clone(id, CLONE_OFFSET, false), 'clone'),
        action('Delete', () => commands.delete(id), 'delete'),
        action('Undo', () => commands.undo()),
      );
    } else if (current) {
      this.actions.replaceChildren(
        action('Delete joint', () => commands.deleteJoint(current.id), 'joints'),
        action('Undo', () => commands.undo()),
      );
    } else this.actions.replaceChildren();
    this.form.element.hidden = current?.kind !== 'body';
    this.showRights();
  }

  /** Call when attributes, the role of the client or the room changed. */
  showRights(): void {
    const { selection, connection } = this.options;
    const { current } = selection;
    const rules = new Set<string>();
    for (const button of this.actions.querySelectorAll<HTMLButtonElement>('[data-action]')) {
      const needed = button.dataset['action'] as Action;
      const rule = current?.kind === 'body' ? this.options.refusal(needed, current.id) : this.options.jointRefusal();
      button.setAttribute('aria-disabled', String(rule !== ''));
      button.title = rule;
      if (rule) rules.add(rule);
    }
    this.rights.textContent = [...rules].join('. ');
    this.rights.hidden = rules.size === 0;
    this.form.setRefusal(current?.kind === 'body' ? this.options.refusal('edit', current.id) : '');
    this.attributes.show(selection.body, connection.data.attributesOf({ kind: 'entity', id: selection.body }));
  }

  /** Returns whether the refused input is one of this panel. */
  rejected(result: InputResult): boolean {
    return this.attributes.rejected(result);
  }

  private get isFrozen(): boolean {
    return this.response?.body?.frozen ?? false;
  }

  /** Shows the state of the selection; undefined: the server sent none. */
  show(response: InspectResponse | undefined): void {
    this.response = response;
    const { current } = this.options.selection;
    this.title.textContent = this.titleText();
    this.title.classList.toggle('note', current === undefined);
    setRows(this.rows, this.rowsOf(response));
    this.showJoints(response?.body);
    this.form.show(response?.body);
    const freeze = [...this.actions.children].find(({ textContent }) => textContent === 'Freeze' || textContent === 'Unfreeze');
    if (freeze && current?.kind === 'body') freeze.textContent = this.isFrozen ? 'Unfreeze' : 'Freeze';
  }

  private titleText(): string {
    const { selection, names, connection } = this.options;
    const { current } = selection;
    if (!current) return 'No body is selected. Choose one with the tool Inspect, or Inspect in its menu.';
    if (current.kind === 'body') return `${names.ofEntity(current.id)} · id ${current.id}`;
    return `${jointKindName(connection.joints.joints.get(current.id)?.form.kind.case)} joint · id ${current.id}`;
  }

  private rowsOf(response: InspectResponse | undefined): Row[] {
    const { selection, connection, names, poseOf } = this.options;
    const { current } = selection;
    if (response?.body) return bodyRows(response.body, connection.welcome?.tickHz || 60, names);
    if (response?.joint) return jointRows(response.joint, names);
    const entity = current?.kind === 'body' ? connection.entities.get(current.id) : undefined;
    if (entity) return entityRows(entity, poseOf(entity.id), names);
    const joint = current && connection.joints.joints.get(current.id);
    return joint ? [['Bodies', `${joint.entityA === 0 ? 'the world' : names.ofEntity(joint.entityA)} and ${names.ofEntity(joint.entityB)}`]] : [];
  }

  /** The joints of the body as buttons that select them. */
  private showJoints(body: InspectedBody | undefined): void {
    const { selection } = this.options;
    const ids = body?.joints.map(({ id }) => id) ?? [];
    const shown = [...this.joints.children].map((element) => Number((element as HTMLElement).dataset['joint']));
    if (ids.length === shown.length && ids.every((id, k) => id === shown[k])) return;
    this.joints.replaceChildren(
      ...(body?.joints ?? []).map(({ id, joint }) => {
        const button = Object.assign(document.createElement('button'), { type: 'button', textContent: `${jointKindName(joint?.kind.case)} joint ${id}` });
        button.dataset['joint'] = String(id);
        button.onclick = () => selection.select({ kind: 'joint', id });
        return button;
      }),
    );
  }
}

/** Updates a list in place, so that a text selection and the scroll position stay. */
function setRows(list: HTMLElement, rows: readonly Row[]): void {
  while (list.children.length > 2 * rows.length) list.lastElementChild!.remove();
  while (list.children.length < 2 * rows.length) list.append(document.createElement('dt'), document.createElement('dd'));
  rows.forEach((row, k) => row.forEach((text, column) => {
    const element = list.children[2 * k + column]!;
    if (element.textContent !== text) element.textContent = text;
  }));
}

type Changes = Parameters<SandboxCommands['edit']>[1];

/** Properties of a body that the server may let the client change. */
class EditForm {
  readonly element = document.createElement('details');
  private refused = false;
  private readonly inputs: { input: HTMLInputElement; read(body: InspectedBody): number }[] = [];

  constructor(private readonly edit: (changes: Changes) => void) {
    const summary = document.createElement('summary');
    summary.textContent = 'Edit';
    const form = document.createElement('div');
    form.className = 'form';
    form.append(
      this.field('Mass, kg', MASS.min, MASS.max, ({ mass }) => mass, (mass) => ({ mass })),
      this.field('Friction', 0, 10, ({ materials }) => materials[0]?.friction ?? 0, (friction) => ({ friction })),
      this.field('Restitution', 0, 1, ({ materials }) => materials[0]?.restitution ?? 0, (restitution) => ({ restitution })),
      this.field('Gravity scale', -10, 10, ({ gravityScale }) => gravityScale, (gravityScale) => ({ gravityScale })),
      this.velocityField(),
      this.colorField(),
    );
    this.element.append(summary, form);
  }

  /** `rule`: that refuses edits of the body; empty: none. */
  setRefusal(rule: string): void {
    this.refused = rule !== '';
    for (const control of this.element.querySelectorAll<HTMLInputElement | HTMLButtonElement>('input, button')) control.disabled = this.refused;
    this.element.title = rule;
  }

  /** Shows the values of the body in the fields that the user does not edit. */
  show(body: InspectedBody | undefined): void {
    for (const { input, read } of this.inputs) {
      input.disabled = body === undefined || this.refused;
      if (document.activeElement !== input) input.value = body ? String(Number(read(body).toPrecision(6))) : '';
    }
  }

  private field(label: string, min: number, max: number, read: (body: InspectedBody) => number, changes: (value: number) => Changes): HTMLElement {
    const input = Object.assign(document.createElement('input'), { type: 'number', step: 'any', min: String(min), max: String(max), disabled: true });
    input.onchange = () => {
      if (input.value !== '') this.edit(changes(clamp(Number(input.value), min, max)));
    };
    this.inputs.push({ input, read });
    const row = document.createElement('label');
    row.className = 'field';
    row.append(label, input);
    return row;
  }

  private velocityField(): HTMLElement {
    const row = document.createElement('div');
    row.className = 'button-row';
    const stop = Object.assign(document.createElement('button'), { type: 'button', textContent: 'Stop' });
    const zero = { x: 0, y: 0, z: 0 };
    stop.onclick = () => this.edit({ linearVelocity: zero, angularVelocity: zero });
    const upright = Object.assign(document.createElement('button'), { type: 'button', textContent: 'Reset rotation' });
    upright.onclick = () => this.edit({ rotation: { ...zero, w: 1 }, angularVelocity: zero });
    row.append(stop, upright);
    return row;
  }

  private colorField(): HTMLElement {
    const input = Object.assign(document.createElement('input'), { type: 'color', value: '#5b8def' });
    input.onchange = () => this.edit({ color: parseInt(input.value.slice(1), 16) });
    const row = document.createElement('label');
    row.className = 'field';
    row.append('Color', input);
    return row;
  }
}
