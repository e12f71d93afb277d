// Keys of the page. Each command has one key, which help lists.

export interface Command {
  /** KeyboardEvent.key, in lower case. */
  readonly key: string;
  readonly label: string;
  run(): void;
}

/** Whether the user is typing, so that keys are text. */
export function isTextInput(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && !['checkbox', 'radio', 'button', 'range', 'color'].includes(target.type);
}

export class Commands {
  private readonly byKey = new Map<string, Command>();

  register(command: Command): void {
    if (this.byKey.has(command.key)) throw new Error(`two commands have the key ${command.key}: ${command.label}`);
    this.byKey.set(command.key, command);
  }

  get all(): readonly Command[] {
    return [...this.byKey.values()];
  }

  /** Runs the command of a key; returns whether there is one. */
  run(key: string): boolean {
    const command = this.byKey.get(key.toLowerCase());
    command?.run();
    return command !== undefined;
  }
}
