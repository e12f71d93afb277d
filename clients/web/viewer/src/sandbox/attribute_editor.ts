// The attributes of the selected entity: typed fields for those that the client may change, and a form that
// adds one. A refusal of the server is shown at the field that caused it.

import type { Attribute, InputResult } from '@jostle/client/gen/play_pb';
import { iconButton } from '../ui/icons';
import { ATTRIBUTE_TYPES, keyProblem, parseValue, valueText, type AttributeType, type AttributeValueCase } from './attribute_values';

const PENDING_MAX = 32;

export interface AttributeEditorOptions {
  /** Sends the input that sets an attribute, or removes one without a value; returns its sequence. */
  set(entity: number, attribute: { key: string; value: AttributeValueCase | { case: undefined }; visibility?: number; roles?: number }): number;
  /** Why the client may not change attributes of the entity; empty: it may. */
  refusal(entity: number): string;
}

let problems = 0; // so that every problem has its own id

/** A control with the problem of its value below it. */
class Field {
  readonly problem = document.createElement('p');

  constructor(readonly control: HTMLInputElement | HTMLSelectElement) {
    this.problem.className = 'problem';
    this.problem.id = `attribute-problem-${problems++}`;
    this.problem.setAttribute('role', 'alert');
    control.setAttribute('aria-describedby', this.problem.id);
  }
  get hasProblem(): boolean {
    return this.problem.textContent !== '';
  }
  setProblem(text: string): void {
    if (this.problem.textContent !== text) this.problem.textContent = text;
    if (text) this.control.setAttribute('aria-invalid', 'true');
    else this.control.removeAttribute('aria-invalid');
  }
}

interface Row {
  readonly element: HTMLElement;
  readonly shape: string; // type and rights, which decide the elements
  readonly field: Field | undefined; // undefined: read-only
  readonly text: HTMLElement;
  value: Attribute['value'] | undefined; // that is shown
}

export class AttributeEditor {
  readonly element = document.createElement('section');
  private readonly list = document.createElement('div');
  private readonly note = document.createElement('p');
  private readonly form = document.createElement('form');
  private readonly key = new Field(control('input', 'Key of the new attribute'));
  private readonly type = control('select', 'Type of the new attribute');
  private value = new Field(control('input', 'Value of the new attribute'));
  private readonly valueCell = document.createElement('div');
  private readonly rows = new Map<string, Row>();
  private readonly pending = new Map<number, Field>(); // by input sequence
  private entity = 0;
  private attributes: ReadonlyMap<string, Attribute> = new Map();

  constructor(private readonly options: AttributeEditorOptions) {
    this.element.className = 'attributes';
    this.element.setAttribute('aria-label', 'Attributes');
    const heading = document.createElement('h3');
    heading.textContent = 'Attributes';
    this.note.className = 'note';
    Object.assign(this.key.control, { name: 'key', placeholder: 'key', maxLength: 32, autocomplete: 'off', spellcheck: false });
    this.key.control.setAttribute('autocapitalize', 'none');
    for (const [type, label] of Object.entries(ATTRIBUTE_TYPES)) (this.type as HTMLSelectElement).add(new Option(label, type, false, type === 'text'));
    this.type.name = 'type';
    this.type.onchange = () => this.renderValueField();
    const add = document.createElement('button');
    add.type = 'submit';
    add.textContent = 'Add';
    const line = document.createElement('div');
    line.className = 'line';
    line.append(this.type, this.valueCell, add);
    this.form.append(this.key.control, this.key.problem, line);
    this.form.onsubmit = (event) => {
      event.preventDefault();
      this.add();
    };
    this.renderValueField();
    this.element.append(heading, this.list, this.note, this.form);
  }

  private get newType(): AttributeType {
    return this.type.value as AttributeType;
  }

  private renderValueField(): void {
    this.value = new Field(valueControl(this.newType, 'Value of the new attribute'));
    this.value.control.name = 'value';
    this.valueCell.replaceChildren(this.value.control);
    this.form.querySelector('.value-problem')?.remove();
    this.value.problem.classList.add('value-problem');
    this.form.append(this.value.problem);
  }

  /** Entity 0: no entity is selected. */
  show(entity: number, attributes: ReadonlyMap<string, Attribute>): void {
    this.element.hidden = entity === 0;
    if (entity !== this.entity) this.clear();
    this.entity = entity;
    this.attributes = attributes;
    if (entity === 0) return;
    const refusal = this.options.refusal(entity);
    this.form.hidden = refusal !== '';
    this.note.hidden = refusal === '' && attributes.size > 0;
    this.note.textContent = [attributes.size === 0 ? 'The entity has no attributes.' : '', refusal].filter((text) => text !== '').join(' ');
    for (const [key, row] of this.rows) {
      if (attributes.has(key)) continue;
      row.element.remove();
      this.rows.delete(key);
    }
    for (const [, attribute] of [...attributes].sort(([a], [b]) => (a < b ? -1 : 1))) this.showRow(attribute, refusal === '');
  }

  private clear(): void {
    this.rows.clear();
    this.list.replaceChildren();
    this.pending.clear();
    (this.key.control as HTMLInputElement).value = '';
    this.key.setProblem('');
    this.renderValueField();
  }

  private showRow(attribute: Attribute, editable: boolean): void {
    const { key, value, readOnly } = attribute;
    const shape = `${value.case} ${editable && !readOnly}`;
    let row = this.rows.get(key);
    if (row?.shape !== shape) {
      const created = this.createRow(attribute, editable && !readOnly, shape);
      if (row) row.element.replaceWith(created.element);
      else this.list.insertBefore(created.element, [...this.rows].filter(([other]) => other > key).sort(([a], [b]) => (a < b ? -1 : 1))[0]?.[1].element ?? null);
      this.rows.set(key, (row = created));
    }
    if (row.value === value) return;
    row.value = value;
    row.field?.setProblem('');
    if (!row.field) row.text.textContent = valueText(attribute);
    else if (document.activeElement !== row.field.control) row.field.control.value = valueText(attribute);
  }

  private createRow(attribute: Attribute, editable: boolean, shape: string): Row {
    const { key, value } = attribute;
    const element = document.createElement('div');
    element.className = 'attribute';
    const label = document.createElement('label');
    label.textContent = key;
    const text = document.createElement('span');
    if (!editable || value.case === undefined) {
      text.className = 'text';
      const by = document.createElement('span');
      by.className = 'by';
      by.textContent = attribute.readOnly ? 'by the server' : '';
      element.append(label, text, by);
      return { element, shape, field: undefined, text, value: undefined };
    }
    const field = new Field(valueControl(value.case, ''));
    field.control.removeAttribute('aria-label');
    field.control.id = `attribute-${this.entity}-${key}`;
    label.htmlFor = field.control.id;
    field.control.onchange = () => this.change(key, field);
    field.control.onkeydown = (event) => {
      const row = this.rows.get(key);
      if (event.key !== 'Escape' || !row?.value) return;
      event.stopPropagation();
      field.control.value = valueText({ value: row.value });
      field.setProblem('');
    };
    const remove = iconButton('close', `Remove ${key}`);
    remove.title = `Remove ${key}`;
    remove.className = 'remove';
    remove.onclick = () => this.send(field, key, { case: undefined });
    element.append(label, field.control, remove, field.problem);
    return { element, shape, field, text, value: undefined };
  }

  private change(key: string, field: Field): void {
    const type = this.attributes.get(key)?.value.case;
    if (type === undefined) return;
    const value = parseValue(type, field.control.value);
    if (typeof value === 'string') return field.setProblem(value);
    field.setProblem('');
    this.send(field, key, value);
  }

  private add(): void {
    const key = this.key.control.value.trim();
    const keyText = keyProblem(key, (known) => this.attributes.has(known));
    this.key.setProblem(keyText);
    const value = parseValue(this.newType, this.value.control.value);
    this.value.setProblem(typeof value === 'string' ? value : '');
    if (keyText) return this.key.control.focus();
    if (typeof value === 'string') return this.value.control.focus();
    this.send(this.key, key, value);
    this.key.control.value = '';
    this.renderValueField();
  }

  private send(field: Field, key: string, value: AttributeValueCase | { case: undefined }): void {
    const { visibility, roles } = this.attributes.get(key) ?? {};
    const sequence = this.options.set(this.entity, { key, value, ...(visibility === undefined ? {} : { visibility }), ...(roles ? { roles } : {}) });
    this.pending.set(sequence, field);
    if (this.pending.size > PENDING_MAX) this.pending.delete(this.pending.keys().next().value!);
  }

  /** Returns whether the refused input is one of this editor. */
  rejected({ sequence, message }: InputResult): boolean {
    const field = this.pending.get(sequence);
    if (!field) return false;
    this.pending.delete(sequence);
    field.setProblem(message || 'The server refused the change.');
    return true;
  }
}

function control(tag: 'input', label: string): HTMLInputElement;
function control(tag: 'select', label: string): HTMLSelectElement;
function control(tag: 'input' | 'select', label: string): HTMLInputElement | HTMLSelectElement {
  const element = document.createElement(tag);
  if (element instanceof HTMLInputElement) element.type = 'text';
  element.setAttribute('aria-label', label);
  return element;
}

function valueControl(type: AttributeType, label: string): HTMLInputElement | HTMLSelectElement {
  if (type === 'boolean') {
    const select = control('select', label);
    for (const value of ['false', 'true']) select.add(new Option(value, value));
    return select;
  }
  const input = control('input', label);
  Object.assign(input, { autocomplete: 'off', placeholder: { integer: '0', number: '0.0', text: 'text', vector: 'x, y, z' }[type] });
  if (type === 'integer') input.inputMode = 'numeric';
  if (type === 'number') input.inputMode = 'decimal';
  if (type === 'text') input.dir = 'auto';
  return input;
}
