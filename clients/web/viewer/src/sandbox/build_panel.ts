// Options of the spawn and joint tools.

import { JOINT_KINDS, type JointKind, type JointOptions } from './joint_options';
import { clamp, MASS, MATERIALS, SIZE, type MaterialName, type SpawnOptions } from './spawn_options';

export class BuildPanel {
  private readonly density = document.createElement('p');
  private readonly hint = document.createElement('p');
  // Rows of the joints that have them.
  private motorSpeed!: HTMLElement;
  private motorMax!: HTMLElement;
  private frequency!: HTMLElement;

  constructor(
    content: HTMLElement,
    private readonly spawn: SpawnOptions,
    private readonly joint: JointOptions,
    private readonly onChange: () => void,
  ) {
    content.className = 'form';
    this.density.className = 'note';
    content.append(heading('Bodies'), this.size(), this.material(), this.mass(), this.color(), this.density, heading('Joints'), this.kind(), this.hint, ...this.jointFields());
    this.hint.className = 'note';
    this.describe();
  }

  private changed(): void {
    this.describe();
    this.onChange();
  }

  private describe(): void {
    const { density, friction, restitution } = MATERIALS[this.spawn.material];
    const mass = this.spawn.mass === undefined ? `${density} kg/m³` : `${this.spawn.mass} kg`;
    this.density.textContent = `${mass} · friction ${friction} · restitution ${restitution}`;
    const { kind } = this.joint;
    this.hint.textContent = `${JOINT_KINDS[kind].hint}.`;
    this.motorSpeed.hidden = this.motorMax.hidden = kind !== 'hinge' && kind !== 'slider';
    this.frequency.hidden = kind !== 'spring';
    const [speed, limit] = kind === 'slider' ? ['m/s', 'N'] : ['rad/s', 'N m'];
    this.motorSpeed.querySelector('label')!.textContent = `Motor speed, ${speed}`;
    this.motorMax.querySelector('label')!.textContent = `Motor limit, ${limit}`;
  }

  private size(): HTMLElement {
    const input = Object.assign(document.createElement('input'), { type: 'range', name: 'size', min: String(SIZE.min), max: String(SIZE.max), step: '0.05' });
    input.value = String(this.spawn.size);
    const text = document.createElement('output');
    const show = () => (text.textContent = `${this.spawn.size.toFixed(2)} m`);
    input.oninput = () => {
      this.spawn.size = clamp(Number(input.value), SIZE.min, SIZE.max);
      show();
      this.changed();
    };
    show();
    const line = document.createElement('div');
    line.className = 'slider';
    const row = field('Size', input);
    line.append(input, text);
    row.append(line);
    return row;
  }

  private material(): HTMLElement {
    const select = Object.assign(document.createElement('select'), { name: 'material' });
    for (const [name, material] of Object.entries(MATERIALS)) select.add(new Option(material.name, name, false, name === this.spawn.material));
    select.onchange = () => {
      this.spawn.material = select.value as MaterialName;
      this.changed();
    };
    return field('Material', select);
  }

  private mass(): HTMLElement {
    const input = Object.assign(document.createElement('input'), { type: 'number', name: 'mass', min: String(MASS.min), max: String(MASS.max), step: 'any', placeholder: 'from the material' });
    input.onchange = () => {
      this.spawn.mass = input.value === '' ? undefined : clamp(Number(input.value), MASS.min, MASS.max);
      if (this.spawn.mass !== undefined) input.value = String(this.spawn.mass);
      this.changed();
    };
    return field('Mass, kg', input);
  }

  private color(): HTMLElement {
    const input = Object.assign(document.createElement('input'), { type: 'color', name: 'color', value: '#5b8def' });
    const reset = document.createElement('button');
    reset.type = 'button';
    reset.textContent = 'Automatic';
    reset.setAttribute('aria-pressed', String(this.spawn.color === undefined));
    input.oninput = () => {
      this.spawn.color = parseInt(input.value.slice(1), 16);
      reset.setAttribute('aria-pressed', 'false');
      this.changed();
    };
    reset.onclick = () => {
      this.spawn.color = undefined;
      reset.setAttribute('aria-pressed', 'true');
      this.changed();
    };
    return field('Color', input, reset);
  }

  private kind(): HTMLElement {
    const select = Object.assign(document.createElement('select'), { name: 'joint' });
    for (const [kind, { label }] of Object.entries(JOINT_KINDS)) select.add(new Option(label, kind, false, kind === this.joint.kind));
    select.onchange = () => {
      this.joint.kind = select.value as JointKind;
      this.changed();
    };
    return field('Kind', select);
  }

  private jointFields(): HTMLElement[] {
    const number = (label: string, name: 'motorSpeed' | 'motorMax' | 'frequency' | 'breakForce', min: number, max: number) => {
      const input = Object.assign(document.createElement('input'), { type: 'number', name, min: String(min), max: String(max), step: 'any', value: String(this.joint[name]) });
      input.onchange = () => {
        this.joint[name] = clamp(Number(input.value), min, max);
        input.value = String(this.joint[name]);
        this.changed();
      };
      return field(label, input);
    };
    this.motorSpeed = number('Motor speed', 'motorSpeed', -100, 100);
    this.motorMax = number('Motor limit', 'motorMax', 0, 1e6);
    this.frequency = number('Frequency, Hz', 'frequency', 0.1, 30);
    const breakForce = number('Break force, N', 'breakForce', 0, 1e9);
    breakForce.title = '0: the joint does not break';
    return [this.motorSpeed, this.motorMax, this.frequency, breakForce];
  }
}

function heading(text: string): HTMLElement {
  return Object.assign(document.createElement('h3'), { textContent: text });
}

function field(label: string, ...controls: HTMLElement[]): HTMLElement {
  const row = document.createElement('div');
  row.className = 'field';
  const name = document.createElement('label');
  const [control] = controls;
  control!.id ||= `build-${(control as HTMLInputElement).name}`;
  name.htmlFor = control!.id;
  name.textContent = label;
  row.append(name, ...controls);
  return row;
}
