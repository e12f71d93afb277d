// The body or joint that the user selected.

export interface Selected {
  readonly kind: 'body' | 'joint';
  readonly id: number;
}

export class Selection {
  private selected: Selected | undefined;
  private readonly listeners: ((selected: Selected | undefined) => void)[] = [];

  get current(): Selected | undefined {
    return this.selected;
  }
  /** The entity id of the selected body; 0: no body is selected. */
  get body(): number {
    return this.selected?.kind === 'body' ? this.selected.id : 0;
  }

  onChange(listener: (selected: Selected | undefined) => void): void {
    this.listeners.push(listener);
  }

  select(selected: Selected | undefined): void {
    if (selected?.kind === this.selected?.kind && selected?.id === this.selected?.id) return;
    this.selected = selected;
    for (const listener of this.listeners) listener(selected);
  }

  /** Clears the selection if its body or joint no longer exists. */
  retain(hasBody: (id: number) => boolean, hasJoint: (id: number) => boolean): void {
    const { selected } = this;
    if (selected && !(selected.kind === 'body' ? hasBody : hasJoint)(selected.id)) this.select(undefined);
  }
}
