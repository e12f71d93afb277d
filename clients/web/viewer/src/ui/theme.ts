// Light and dark theme: that of the system, unless the user selected one.

export type Theme = 'dark' | 'light';

const KEY = 'jostle-theme';

export class ThemeSwitch {
  private readonly system = matchMedia('(prefers-color-scheme: light)');

  constructor(private readonly onChange: (theme: Theme) => void) {
    this.system.addEventListener('change', () => this.apply());
    this.apply();
  }

  get theme(): Theme {
    const stored = this.stored;
    if (stored === 'dark' || stored === 'light') return stored;
    return this.system.matches ? 'light' : 'dark';
  }

  toggle(): void {
    const next: Theme = this.theme === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(KEY, next);
    } catch {
      document.documentElement.dataset['chosenTheme'] = next; // pages without storage
    }
    this.apply();
  }

  private get stored(): string | undefined {
    try {
      return localStorage.getItem(KEY) ?? undefined;
    } catch {
      return document.documentElement.dataset['chosenTheme'];
    }
  }

  private apply(): void {
    document.documentElement.dataset['theme'] = this.theme;
    this.onChange(this.theme);
  }
}
