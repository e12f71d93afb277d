// A socket with simulated network conditions: a NetworkSimulator delays the messages of each direction.

import { nowUs } from '../clock/clock_sync.js';
import type { Socket } from '../connection/connection.js';
import { NetworkSimulator, type NetworkConditions } from './network_simulator.js';

/** Messages in flight in one direction, in order. */
class DelayedMessages {
  private readonly due: { readonly at: number; readonly deliver: () => void }[] = [];
  private readonly simulator: NetworkSimulator;

  constructor(conditions: NetworkConditions, path: number) {
    this.simulator = new NetworkSimulator(conditions, path);
  }

  push(bytes: number, deliver: () => void): void {
    this.due.push({ at: this.simulator.send(Math.round(nowUs()), bytes).arrivalUs, deliver });
    if (this.due.length === 1) this.schedule();
  }

  private schedule(): void {
    setTimeout(() => this.deliverDue(), Math.max(0, Math.ceil((this.due[0]!.at - nowUs()) / 1000)));
  }

  private deliverDue(): void {
    while (this.due.length > 0 && this.due[0]!.at <= nowUs()) this.due.shift()!.deliver();
    if (this.due.length > 0) this.schedule();
  }
}

/** Wraps `open` so that its sockets have the given conditions. */
export function simulatedSocket(open: (url: string) => Socket, conditions: NetworkConditions): (url: string) => Socket {
  return (url) => {
    const real = open(url);
    const incoming = new DelayedMessages(conditions, 0);
    const outgoing = new DelayedMessages(conditions, 1);
    let closed = false;
    const simulated: Socket = {
      get binaryType() {
        return real.binaryType;
      },
      set binaryType(type) {
        real.binaryType = type;
      },
      onopen: null,
      onmessage: null,
      onclose: null,
      send: (bytes) => outgoing.push(bytes.byteLength, () => closed || real.send(bytes)),
      close: () => {
        closed = true;
        real.close();
      },
    };
    real.onopen = () => simulated.onopen?.();
    real.onmessage = (event) => incoming.push(event.data.byteLength, () => simulated.onmessage?.(event));
    real.onclose = (event) => {
      closed = true;
      incoming.push(0, () => simulated.onclose?.(event));
    };
    return simulated;
  };
}
