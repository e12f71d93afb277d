// Short messages that disappear after 4 s.

export class Toasts {
  private last = '';
  private lastAt = 0;

  constructor(private readonly box: HTMLElement) {}

  show(text: string): void {
    const now = performance.now();
    if (text === this.last && now - this.lastAt < 1500) return;
    this.last = text;
    this.lastAt = now;
    const toast = document.createElement('p');
    toast.textContent = text;
    this.box.append(toast);
    while (this.box.childElementCount > 3) this.box.firstElementChild!.remove();
    setTimeout(() => toast.remove(), 4000);
  }
}
