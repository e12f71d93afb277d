// Time of the world: pause, single step, slow motion, reset and a timeline of the last minute. The room
// decides who may use them.

import type { WorldStats } from '@jostle/client/gen/play_pb';
import type { Action } from '../room/room_rules';
import type { SandboxCommands } from './sandbox_commands';
import { button } from '../ui/elements';

const SPEEDS = [100, 50, 25, 10, 5]; // percent
const CONFIRM_MS = 4000;

export interface TimePanelOptions {
  readonly commands: SandboxCommands;
  /** The rule that refuses an action; empty: none. */
  refusal(action: Action): string;
  tickHz(): number;
}

export class TimePanel {
  private readonly pause = button('Pause', () => this.options.commands.setPaused(!this.paused));
  private readonly step = button('Step', () => this.options.commands.step());
  private readonly speed = document.createElement('select');
  private readonly slider = document.createElement('input');
  private readonly sliderText = document.createElement('output');
  private readonly rewind = button('Rewind', () => this.rewindNow());
  private readonly reset = button('Reset world', () => this.confirmReset());
  private readonly state = document.createElement('p');
  private readonly rights = document.createElement('p');
  private readonly timeline = document.createElement('div');
  private ticks: readonly number[] = [];
  private tick = 0;
  private paused = false;
  private confirmUntilMs = 0;

  constructor(
    content: HTMLElement,
    private readonly options: TimePanelOptions,
  ) {
    content.className = 'time-panel';
    this.state.className = 'note';
    this.state.setAttribute('role', 'status');
    this.rights.className = 'note';
    this.pause.title = 'Pauses or resumes the world (K)';
    this.step.title = 'Simulates one step of a paused world (.)';
    for (const percent of SPEEDS) this.speed.add(new Option(percent === 100 ? 'Real time' : `${percent} % speed`, String(percent)));
    this.speed.setAttribute('aria-label', 'Speed of the world');
    this.speed.onchange = () => this.options.commands.setSpeed(Number(this.speed.value));
    Object.assign(this.slider, { type: 'range', min: '0', step: '1' });
    this.slider.setAttribute('aria-label', 'Earlier state of the world');
    this.slider.oninput = () => this.showTimeline();
    const controls = row(this.pause, this.step, this.speed);
    const heading = document.createElement('h3');
    heading.textContent = 'Timeline';
    this.timeline.className = 'restore';
    this.timeline.append(this.slider, this.sliderText, this.rewind);
    this.reset.classList.add('danger');
    content.append(this.state, controls, heading, this.timeline, row(this.reset), this.rights);
    this.update(undefined);
  }

  /** Call with each statistics message of the world; undefined: none was received. */
  update(stats: WorldStats | undefined): void {
    this.paused = (stats?.paused ?? '') !== '';
    this.tick = stats?.tick ?? 0;
    this.ticks = stats?.restorableTicks ?? [];
    const percent = stats?.speedPercent || 100;
    this.pause.textContent = this.paused ? 'Resume' : 'Pause';
    this.pause.setAttribute('aria-pressed', String(this.paused));
    this.step.disabled = !this.paused;
    this.showRights();
    if (document.activeElement !== this.speed) this.speed.value = String(SPEEDS.includes(percent) ? percent : 100);
    const seconds = (this.tick / this.options.tickHz()).toFixed(1);
    const state = this.paused ? `Paused: ${stats!.paused}` : percent < 100 ? `Runs at ${percent} % of real time` : 'Runs in real time';
    this.state.textContent = stats ? `${state} · tick ${this.tick} · ${seconds} s` : 'No statistics yet.';
    this.showTimeline();
    if (performance.now() > this.confirmUntilMs) this.reset.textContent = 'Reset world';
  }

  /** Disables what the rules refuse, and names them. */
  private showRights(): void {
    const { refusal } = this.options;
    const [pause, speed, rewind, reset] = (['pause', 'speed', 'rewind', 'reset'] as const).map(refusal) as [string, string, string, string];
    this.pause.disabled = pause !== '';
    this.step.disabled ||= pause !== '';
    this.speed.disabled = speed !== '';
    this.reset.disabled = reset !== '';
    this.rights.textContent = [...new Set([pause, speed, rewind, reset])].filter((rule) => rule !== '').join('. ');
  }

  private showTimeline(): void {
    const { ticks } = this;
    const empty = ticks.length === 0;
    this.slider.disabled = empty;
    this.rewind.disabled = empty || this.options.refusal('rewind') !== '';
    const atEnd = this.slider.value === this.slider.max;
    this.slider.max = String(Math.max(0, ticks.length - 1));
    if (atEnd && document.activeElement !== this.slider) this.slider.value = this.slider.max;
    const chosen = ticks[Number(this.slider.value)];
    const text = chosen === undefined ? 'The room stores no timeline.' : `${secondsAgo(this.tick, chosen, this.options.tickHz())} s ago`;
    this.sliderText.textContent = text;
    this.slider.setAttribute('aria-valuetext', text);
  }

  private rewindNow(): void {
    const tick = this.ticks[Number(this.slider.value)];
    if (tick !== undefined) this.options.commands.rewind(tick);
  }

  /** A second click within some seconds resets. */
  private confirmReset(): void {
    if (performance.now() < this.confirmUntilMs) {
      this.confirmUntilMs = 0;
      this.reset.textContent = 'Reset world';
      return this.options.commands.reset();
    }
    this.confirmUntilMs = performance.now() + CONFIRM_MS;
    this.reset.textContent = 'Click again to reset';
  }
}

export function secondsAgo(now: number, tick: number, hz: number): string {
  return (Math.max(0, now - tick) / hz).toFixed(1);
}

function row(...elements: HTMLElement[]): HTMLElement {
  const element = document.createElement('div');
  element.className = 'button-row';
  element.append(...elements);
  return element;
}
