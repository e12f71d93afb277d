// The panel of the room: its settings as a form for those who may change them, the table of permissions,
// protected areas, bans, and the transfer of the room. Refusals of the server are shown at their field.

import type { InputResult } from '@jostle/client/gen/play_pb';
import { PlayerRole } from '@jostle/client/gen/play_pb';
import type { RoomUpdate } from '@jostle/client/gen/room_pb';
import type * as THREE from 'three';
import { cleanText } from '../people/text';
import { parseValue } from '../sandbox/attribute_values';
import { vectorText } from '../sandbox/describe_inspected';
import type { RoomCommand } from './room';
import { defaultQuota, fieldOfProblem, fieldsOf, QUOTAS, reachIn, replacedCount, setQuota, setReach, settingsOf, type Quota, type RoomFields } from './room_form';
import { ACTION_NAMES, ACTIONS, defaultReach, REACHES, ROLES, type Reach, type Role, type RoomRules } from './room_rules';
import { button, element } from '../ui/elements';

const CONFIRM_MS = 4000;
const AREA_MARGIN = 1; // m around the selected body
const AREA_HALF = 3; // m, around the target of the camera

export interface RoomPanelOptions {
  rules(): RoomRules;
  /** Returns the sequence of the input. */
  send(kind: RoomCommand): number;
  nameOf(client: number): string;
  /** The other clients. */
  clients(): number[];
  selectedBox(): THREE.Box3 | undefined;
  cameraTarget(): THREE.Vector3;
}

type Problem = HTMLParagraphElement;

function problemOf(name: string): Problem {
  const problem = element('p', '', 'problem');
  problem.id = `room-problem-${name}`;
  problem.setAttribute('role', 'alert');
  return problem;
}

function setProblem(problem: Problem, control: HTMLElement | undefined, text: string): void {
  if (problem.textContent !== text) problem.textContent = text;
  if (text) control?.setAttribute('aria-invalid', 'true');
  else control?.removeAttribute('aria-invalid');
}

/** A button that acts on its second click within some seconds. */
function confirmButton(text: string, question: string, run: () => void): HTMLButtonElement {
  let until = 0;
  const created = button(text, () => {
    const now = performance.now();
    if (now < until) {
      until = 0;
      created.textContent = text;
      return run();
    }
    until = now + CONFIRM_MS;
    created.textContent = question;
    setTimeout(() => (created.textContent = text), CONFIRM_MS);
  });
  return created;
}

export class RoomPanel {
  private readonly about = element('p', '', 'note');
  private readonly settings: SettingsForm;
  private readonly areas: AreaList;
  private readonly bans = element('section');
  private readonly transfer = element('section');
  private readonly player = element('select');
  private readonly transferProblem = problemOf('transfer');
  private readonly banProblem = problemOf('bans');
  private readonly pending = new Map<number, (message: string) => void>(); // by input sequence
  private shown: RoomUpdate | undefined;
  private shownRole: Role | undefined;
  private shownClients = '';

  constructor(
    content: HTMLElement,
    private readonly options: RoomPanelOptions,
  ) {
    content.className = 'room';
    const send = (kind: RoomCommand, refused: (message: string) => void) => this.send(kind, refused);
    this.settings = new SettingsForm(send);
    this.areas = new AreaList(options, send);
    this.player.setAttribute('aria-label', 'New owner');
    this.player.setAttribute('aria-describedby', this.transferProblem.id);
    const give = confirmButton('Transfer the room', 'Click again to transfer', () => {
      if (this.player.value) this.send({ case: 'setRole', value: { client: Number(this.player.value), role: PlayerRole.OWNER } }, (text) => setProblem(this.transferProblem, this.player, text));
    });
    const line = element('div', '', 'line');
    line.append(this.player, give);
    this.transfer.append(element('h3', 'Owner'), element('p', 'The new owner gets all rights, and you become a builder.', 'note'), line, this.transferProblem);
    content.append(this.about, this.settings.element, this.areas.element, this.bans, this.transfer);
  }

  private send(kind: RoomCommand, refused: (message: string) => void): void {
    const sequence = this.options.send(kind);
    this.pending.set(sequence, refused);
    if (this.pending.size > 32) this.pending.delete(this.pending.keys().next().value!);
  }

  rejected({ sequence, message }: InputResult): boolean {
    const refused = this.pending.get(sequence);
    this.pending.delete(sequence);
    refused?.(message || 'The server refused the command.');
    return refused !== undefined;
  }

  /** Call when the room, the own role or the players changed. */
  show(): void {
    const rules = this.options.rules();
    const { room, role } = rules;
    this.showClients();
    if (room === this.shown && role === this.shownRole) return;
    this.shown = room;
    this.shownRole = role;
    for (const part of [this.settings.element, this.areas.element]) part.hidden = room === undefined;
    this.bans.hidden = room === undefined || !rules.may('ban');
    this.transfer.hidden = room === undefined || !rules.may('set_role') || role !== 'owner';
    if (!room) {
      this.about.textContent = 'This world is no room: it has no roles, and everybody may do what the server allows. Worlds creates rooms.';
      return;
    }
    const refusal = rules.refusal('settings');
    this.about.textContent = `Your role is ${role}.${refusal ? ` You cannot change the settings: ${refusal}` : ''}`;
    this.settings.show(room, refusal === '');
    this.areas.show(room, rules.refusal('protect'));
    this.showBans(room);
  }

  private showBans({ bans }: RoomUpdate): void {
    const list = element('ul', '', 'entries');
    for (const { member, reason, permanent } of bans) {
      const item = element('li');
      const words = element('span', cleanText(member, 80));
      const about = [permanent ? 'until it is removed' : 'for a time', cleanText(reason, 100)].filter((text) => text !== '').join(' · ');
      const label = element('span', '', 'words');
      label.append(words, element('span', about, 'dim'));
      const remove = button('Unban', () => this.send({ case: 'unban', value: { member } }, (text) => setProblem(this.banProblem, undefined, text)));
      remove.setAttribute('aria-label', `Unban ${cleanText(member, 80)}`);
      item.append(label, remove);
      list.append(item);
    }
    const empty = element('p', 'No member is banned. The menu of a player bans it.', 'note');
    setProblem(this.banProblem, undefined, '');
    this.bans.replaceChildren(element('h3', 'Bans'), bans.length > 0 ? list : empty, this.banProblem);
  }

  private showClients(): void {
    const clients = this.options.clients().map((client) => [client, this.options.nameOf(client)] as const);
    const key = JSON.stringify(clients);
    if (key === this.shownClients) return;
    this.shownClients = key;
    const { value } = this.player;
    this.player.replaceChildren(...(clients.length > 0 ? clients.map(([client, name]) => new Option(name, String(client))) : [new Option('No other player', '')]));
    if (clients.some(([client]) => String(client) === value)) this.player.value = value;
  }
}

type Send = (kind: RoomCommand, refused: (message: string) => void) => void;

/** The settings. Changes of others replace the fields unless the user changed them. */
class SettingsForm {
  readonly element = element('form');
  private readonly controls = new Map<string, HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement>();
  private readonly problems = new Map<string, Problem>();
  private readonly role = element('select');
  private readonly table = element('div', '', 'permissions');
  private readonly status = element('p', '', 'note');
  private readonly save = element('button', 'Save', 'primary');
  private readonly discard = button('Discard changes', () => this.fill());
  private fields: RoomFields = fieldsOf(undefined);
  private room: RoomUpdate | undefined;
  private editable = false;
  private dirty = false;
  private saving = false;

  constructor(private readonly send: Send) {
    this.element.className = 'form';
    this.element.noValidate = true;
    this.element.setAttribute('aria-label', 'Settings of the room');
    const text = (name: string, label: string, max: number) => this.row(name, label, Object.assign(element('input'), { type: 'text', maxLength: max, autocomplete: 'off', dir: 'auto' }));
    const number = (name: string, label: string, max: number) => this.row(name, label, Object.assign(element('input'), { type: 'number', min: '0', max: String(max), step: '1' }));
    const check = (name: string, label: string) => this.row(name, label, Object.assign(element('input'), { type: 'checkbox' }));
    const initial = element('select');
    for (const role of ['spectator', 'player', 'builder']) initial.add(new Option(role, role));
    text('title', 'Title', 64);
    this.row('description', 'Description', Object.assign(element('textarea'), { maxLength: 512, rows: 2, dir: 'auto' }));
    text('tags', 'Tags', 600);
    number('capacity', 'Capacity, 0: any', 10_000);
    check('isPrivate', 'Private');
    text('joinCode', 'Join code', 64);
    check('unlisted', 'Unlisted');
    check('closeWhenEmpty', 'Close when empty');
    number('timelineSeconds', 'Timeline, s', 60);
    this.row('initialRole', 'Role on entry', initial);
    const details = element('details');
    for (const role of ROLES) this.role.add(new Option(role, role, false, role === 'player'));
    this.role.setAttribute('aria-label', 'Role of the permissions');
    this.role.onchange = () => this.renderTable();
    const line = element('div', '', 'line');
    line.append(this.role);
    details.append(element('summary', 'Permissions and quotas'), line, this.table);
    this.status.setAttribute('role', 'status');
    this.save.type = 'submit';
    const buttons = element('div', '', 'button-row');
    buttons.append(this.save, this.discard);
    this.element.append(details, this.problem('permissions'), this.problem('quotas'), this.problem('other'), this.status, buttons);
    this.element.oninput = (event) => {
      if (event.target === this.role) return;
      this.setDirty(true);
      this.joinCodeRow();
    };
    this.element.onsubmit = (event) => {
      event.preventDefault();
      this.submit();
    };
  }

  private row(name: string, label: string, control: HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement): void {
    control.name = name;
    control.id = `room-${name}`;
    const row = element('div', '', 'field');
    const words = element('label', label);
    words.htmlFor = control.id;
    const problem = this.problem(name);
    control.setAttribute('aria-describedby', problem.id);
    const cell = element('label', '', 'cell'); // a larger target than the box
    if (control.type === 'checkbox') cell.append(control);
    row.append(words, control.type === 'checkbox' ? cell : control, problem);
    this.controls.set(name, control);
    this.element.append(row);
  }

  private problem(name: string): Problem {
    const problem = problemOf(name);
    this.problems.set(name, problem);
    return problem;
  }

  private setDirty(dirty: boolean): void {
    this.dirty = dirty;
    this.save.disabled = this.discard.disabled = !this.editable || !dirty;
    if (dirty) this.status.textContent = '';
  }

  show(room: RoomUpdate, editable: boolean): void {
    this.room = room;
    this.editable = editable;
    if (this.saving) {
      this.saving = false;
      this.fill();
      this.status.textContent = 'The settings are saved.';
    } else if (this.dirty) this.status.textContent = 'The room changed meanwhile. Discard your changes to see it, or save yours.';
    else this.fill();
  }

  /** Shows the settings of the room. */
  private fill(): void {
    this.fields = fieldsOf(this.room?.settings);
    for (const [name, control] of this.controls) {
      const value = this.fields[name as keyof RoomFields];
      if (control instanceof HTMLInputElement && control.type === 'checkbox') control.checked = value === true;
      else control.value = String(value);
      control.disabled = !this.editable;
    }
    for (const [name, problem] of this.problems) setProblem(problem, this.controls.get(name), '');
    this.status.textContent = '';
    this.save.hidden = this.discard.hidden = !this.editable;
    this.joinCodeRow();
    this.renderTable();
    this.setDirty(false);
  }

  private joinCodeRow(): void {
    const row = this.controls.get('joinCode')!.parentElement!;
    row.hidden = !(this.controls.get('isPrivate') as HTMLInputElement).checked;
  }

  private renderTable(): void {
    const role = this.role.value as Role;
    const { permissions, quotas } = this.fields;
    for (const option of this.role.options) {
      const count = replacedCount(permissions, option.value as Role);
      option.text = count > 0 ? `${option.value} (${count} changed)` : option.value;
    }
    const reaches = ACTION_NAMES.map((action) => {
      const select = element('select');
      const usual = defaultReach(role, action);
      for (const reach of REACHES) select.add(new Option(reach === usual ? `${reach} (default)` : reach, reach, false, reach === reachIn(permissions, role, action)));
      select.name = `${role}.${action}`;
      select.onchange = () => {
        setReach(permissions, role, action, select.value as Reach);
        this.renderCounts();
      };
      return this.tableRow(ACTIONS[action][0], select, reachIn(permissions, role, action) !== usual);
    });
    const limits = (Object.keys(QUOTAS) as Quota[]).map((quota) => {
      const input = Object.assign(element('input'), { type: 'number', min: '0', step: 'any', name: `${role}.${quota}` });
      input.value = String(quotas[`${role}.${quota}`] ?? defaultQuota(role, quota));
      input.onchange = () => setQuota(quotas, role, quota, Math.max(0, Number(input.value) || 0));
      return this.tableRow(`${QUOTAS[quota][0]}, 0: any`, input, `${role}.${quota}` in quotas);
    });
    this.table.replaceChildren(...reaches, element('h3', 'Quotas'), ...limits);
  }

  private renderCounts(): void {
    for (const option of this.role.options) {
      const count = replacedCount(this.fields.permissions, option.value as Role);
      option.text = count > 0 ? `${option.value} (${count} changed)` : option.value;
    }
  }

  private tableRow(label: string, control: HTMLInputElement | HTMLSelectElement, changed: boolean): HTMLElement {
    const row = element('div', '', changed ? 'field changed' : 'field');
    const words = element('label', label);
    control.id = `room-${control.name}`;
    control.disabled = !this.editable;
    words.htmlFor = control.id;
    row.append(words, control);
    return row;
  }

  private submit(): void {
    if (!this.room || !this.editable) return;
    for (const [name, problem] of this.problems) setProblem(problem, this.controls.get(name), '');
    const value = (name: string) => this.controls.get(name)!.value;
    const checked = (name: string) => (this.controls.get(name) as HTMLInputElement).checked;
    const whole = (name: string, max: number): number | undefined => {
      const entered = Number(value(name));
      if (value(name) !== '' && Number.isInteger(entered) && entered >= 0 && entered <= max) return entered;
      this.refuse(name, `Enter a whole number from 0 to ${max}.`);
      return undefined;
    };
    const [capacity, timelineSeconds] = [whole('capacity', 10_000), whole('timelineSeconds', 60)];
    if (checked('isPrivate') && value('joinCode') === '') return this.refuse('joinCode', 'A private room needs a join code.');
    if (capacity === undefined || timelineSeconds === undefined) return;
    Object.assign(this.fields, {
      ...Object.fromEntries(['title', 'description', 'tags', 'joinCode', 'initialRole'].map((name) => [name, value(name)])),
      ...Object.fromEntries(['isPrivate', 'unlisted', 'closeWhenEmpty'].map((name) => [name, checked(name)])),
      capacity,
      timelineSeconds,
    });
    this.saving = true;
    this.status.textContent = 'Saving …';
    const settings = settingsOf(this.fields, this.room.settings?.areas ?? []);
    if (JSON.stringify(settings) === JSON.stringify(settingsOf(fieldsOf(this.room.settings), this.room.settings?.areas ?? []))) {
      this.saving = false;
      return this.fill();
    }
    this.send({ case: 'settings', value: settings }, (message) => {
      this.saving = false;
      this.status.textContent = '';
      this.refuse(fieldOfProblem(message) ?? 'other', message);
    });
  }

  private refuse(name: string, message: string): void {
    const problem = this.problems.get(name) ?? this.problems.get('other')!;
    const control = this.controls.get(name);
    setProblem(problem, control, message);
    (control ?? problem).scrollIntoView({ block: 'nearest' });
    control?.focus();
  }
}

/** The protected areas: a list, and a form that adds one. */
class AreaList {
  readonly element = element('section');
  private readonly list = element('ul', '', 'entries');
  private readonly note = element('p', '', 'note');
  private readonly form = element('form', '', 'form');
  private readonly name = Object.assign(element('input'), { type: 'text', maxLength: 32, placeholder: 'Name', autocomplete: 'off', dir: 'auto' });
  private readonly role = element('select');
  private readonly min = Object.assign(element('input'), { type: 'text', placeholder: 'x, y, z', autocomplete: 'off' });
  private readonly max = Object.assign(element('input'), { type: 'text', placeholder: 'x, y, z', autocomplete: 'off' });
  private readonly problem = problemOf('area');

  constructor(
    private readonly options: RoomPanelOptions,
    private readonly send: Send,
  ) {
    this.element.setAttribute('aria-label', 'Protected areas');
    for (const role of ['player', 'builder', 'owner']) this.role.add(new Option(role === 'owner' ? 'the owner' : `${role} or higher`, role, false, role === 'builder'));
    const field = (label: string, control: HTMLInputElement | HTMLSelectElement, name: string) => {
      const row = element('div', '', 'field');
      const words = element('label', label);
      control.id = `area-${name}`;
      control.name = name;
      control.setAttribute('aria-describedby', this.problem.id);
      words.htmlFor = control.id;
      row.append(words, control);
      return row;
    };
    const here = button('Around the selection', () => this.fillBox());
    here.title = 'The box of the selected body and 1 m around it, or a box where the camera looks';
    const add = element('button', 'Protect');
    add.type = 'submit';
    const buttons = element('div', '', 'button-row');
    buttons.append(here, add);
    const details = element('details');
    this.form.append(field('Name', this.name, 'areaName'), field('Who acts', this.role, 'areaRole'), field('Lowest corner, m', this.min, 'areaMin'), field('Highest corner, m', this.max, 'areaMax'), this.problem, buttons);
    details.append(element('summary', 'Protect an area'), this.form);
    this.element.append(element('h3', 'Protected areas'), this.list, this.note, details);
    this.form.onsubmit = (event) => {
      event.preventDefault();
      this.add();
    };
  }

  private fillBox(): void {
    const selected = this.options.selectedBox();
    const box = selected && !selected.isEmpty() ? selected.clone().expandByScalar(AREA_MARGIN) : undefined;
    const { x, y, z } = this.options.cameraTarget();
    const corner = (sign: number) => [x + sign * AREA_HALF, y + sign * AREA_HALF, z + sign * AREA_HALF];
    const write = (values: readonly number[]) => values.map((value) => Number(value.toFixed(2))).join(', ');
    this.min.value = write(box ? box.min.toArray() : corner(-1));
    this.max.value = write(box ? box.max.toArray() : corner(1));
  }

  private add(): void {
    const [min, max] = [parseValue('vector', this.min.value), parseValue('vector', this.max.value)];
    const name = this.name.value.trim();
    const text = name === '' ? 'Enter a name.' : typeof min === 'string' ? `Lowest corner: ${min}` : typeof max === 'string' ? `Highest corner: ${max}` : '';
    setProblem(this.problem, undefined, text);
    if (text || typeof min === 'string' || typeof max === 'string' || min.case !== 'vector' || max.case !== 'vector') return;
    this.send({ case: 'protect', value: { area: { name, min: min.value, max: max.value, minRole: this.role.value } } }, (message) => setProblem(this.problem, undefined, message));
  }

  show({ settings }: RoomUpdate, refusal: string): void {
    const areas = settings?.areas ?? [];
    this.form.parentElement!.hidden = refusal !== '';
    this.note.hidden = areas.length > 0;
    this.note.textContent = 'Everybody acts everywhere, as far as the permissions allow.';
    setProblem(this.problem, undefined, '');
    this.list.hidden = areas.length === 0;
    this.list.replaceChildren(
      ...areas.map(({ name, min, max, minRole }) => {
        const item = element('li');
        const words = element('span', '', 'words');
        const title = element('bdi', cleanText(name, 32));
        words.append(title, element('span', `${minRole || 'builder'} and higher · ${vectorText(min, 1)} to ${vectorText(max, 1)} m`, 'dim'));
        item.append(words);
        if (refusal === '') {
          const remove = button('Remove', () => this.send({ case: 'unprotect', value: { name } }, (message) => setProblem(this.problem, undefined, message)));
          remove.setAttribute('aria-label', `Remove the protection of ${cleanText(name, 32)}`);
          item.append(remove);
        }
        return item;
      }),
    );
  }
}
