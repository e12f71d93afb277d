// The lines of the chat: messages of players and notices about them. It knows no page.

export interface ChatLine {
  readonly number: number; // from 1, rising
  readonly kind: 'message' | 'notice';
  /** Client id of the sender; 0: the server or a notice. */
  readonly from: number;
  readonly name: string;
  readonly color: number;
  readonly text: string;
  readonly own: boolean;
  readonly timeMs: number; // Date.now()
  /** A message that the server refused: why. */
  readonly refused?: string;
}

export const CHAT_LINES_MAX = 200;

export class ChatLog {
  private all: ChatLine[] = [];
  private count = 0;
  private readonly hidden = new Set<number>();
  private readonly listeners = new Set<(line: ChatLine | undefined) => void>();
  unread = 0;
  /** The chat is on screen. */
  isOpen = false;

  add(line: Omit<ChatLine, 'number'>): void {
    if (line.kind === 'message' && this.hidden.has(line.from)) return;
    const added = { ...line, number: ++this.count };
    this.all.push(added);
    if (this.all.length > CHAT_LINES_MAX) this.all.shift();
    if (!this.isOpen && line.kind === 'message' && !line.own) this.unread++;
    for (const listener of this.listeners) listener(added);
  }

  /** Oldest first, without those of hidden clients. */
  get lines(): readonly ChatLine[] {
    return this.all.filter((line) => line.kind !== 'message' || !this.hidden.has(line.from));
  }
  /** The newest messages of a client, oldest first. */
  newestOf(client: number, count: number): readonly ChatLine[] {
    return this.all.filter((line) => line.kind === 'message' && line.from === client).slice(-count);
  }

  setOpen(isOpen: boolean): void {
    this.isOpen = isOpen;
    if (isOpen) this.unread = 0;
    this.changed();
  }

  isHidden(client: number): boolean {
    return this.hidden.has(client);
  }
  /** Hides the messages of a client from this user, also earlier ones. */
  setHidden(client: number, hidden: boolean): void {
    if (hidden) this.hidden.add(client);
    else this.hidden.delete(client);
    this.changed();
  }

  /** Another world has other client ids. */
  clear(): void {
    this.all = [];
    this.hidden.clear();
    this.unread = 0;
    this.changed();
  }

  /** Calls `listener` with each new line, and with undefined after other changes. */
  listen(listener: (line: ChatLine | undefined) => void): void {
    this.listeners.add(listener);
  }
  private changed(): void {
    for (const listener of this.listeners) listener(undefined);
  }
}
