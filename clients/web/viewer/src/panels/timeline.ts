// Playback controls of a recording: play and pause, a time slider, and the speed.

import type { RecordedStream } from '@jostle/client';

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

export class TimelinePanel {
  private readonly button = document.createElement('button');
  private readonly slider = document.createElement('input');
  private readonly readout = document.createElement('output');
  private readonly speed = document.createElement('select');
  private stream: RecordedStream | undefined;

  constructor(private readonly panel: HTMLElement) {
    this.button.type = 'button';
    this.button.onclick = () => this.toggle();
    Object.assign(this.slider, { type: 'range', min: '0', step: '0.01' });
    this.slider.setAttribute('aria-label', 'Playback time');
    this.slider.oninput = () => this.stream?.seek(Number(this.slider.value));
    this.speed.setAttribute('aria-label', 'Playback speed');
    for (const times of SPEEDS) this.speed.add(new Option(`${times} ×`, String(times), times === 1, times === 1));
    this.speed.onchange = () => {
      if (this.stream) this.stream.speed = Number(this.speed.value);
    };
    panel.append(this.button, this.slider, this.readout, this.speed);
  }

  /** undefined: no recording is played. */
  show(stream: RecordedStream | undefined): void {
    this.stream = stream;
    this.panel.hidden = stream === undefined;
    if (!stream) return;
    this.slider.max = String(stream.length);
    this.speed.value = String(stream.speed);
  }

  toggle(): void {
    if (!this.stream) return;
    if (this.stream.playing) this.stream.playing = false;
    else this.stream.play();
  }

  /** Call once per rendered frame. */
  update(): void {
    const { stream } = this;
    if (!stream) return;
    const label = stream.playing ? 'Pause' : 'Play';
    if (this.button.textContent !== label) this.button.textContent = label;
    this.slider.value = String(stream.seconds);
    this.readout.textContent = `${stream.seconds.toFixed(1)} / ${stream.length.toFixed(1)} s · tick ${stream.tick}`;
  }
}
