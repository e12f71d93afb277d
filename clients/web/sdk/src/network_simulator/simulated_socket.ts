// A socket behind a bad link: messages in both directions arrive when a NetworkSimulator says so. For tests and demonstrations; the
// viewer takes one from its address line (?delay=80&jitter=20&stalls=250).

import { nowUs } from '../clock/clock.js';
import type { Socket } from '../connection/connection.js';
import { NetworkSimulator, type NetworkConditions } from './network_simulator.js';

/** What is on its way in one direction, in order. */
class DelayedMessages {
  private readonly due: { readonly at: number; readonly arrive: () => void }[] = [];
  private readonly link: NetworkSimulator;

  constructor(settings: NetworkConditions) {
    this.link = new NetworkSimulator(settings);
  }

  push(arrive: () => void): void {
    this.due.push({ at: this.link.arrivalUs(Math.round(nowUs())), arrive });
    if (this.due.length === 1) this.wait();
  }

  private wait(): void {
    setTimeout(() => this.arrive(), Math.max(0, Math.ceil((this.due[0]!.at - nowUs()) / 1000)));
  }

  private arrive(): void {
    while (this.due.length > 0 && this.due[0]!.at <= nowUs()) this.due.shift()!.arrive();
    if (this.due.length > 0) this.wait();
  }
}

/** Opens sockets as `open` does. */
export function simulatedSocket(open: (url: string) => Socket, settings: NetworkConditions): (url: string) => Socket {
  return (url) => {
    const real = open(url);
    const incoming = new DelayedMessages(settings);
    const outgoing = new DelayedMessages({ ...settings, seed: (settings.seed ^ 0x9e3779b9) >>> 0 }); // another link back
    let closed = false;
    const shown: Socket = {
      get binaryType() {
        return real.binaryType;
      },
      set binaryType(type) {
        real.binaryType = type;
      },
      onopen: null,
      onmessage: null,
      onclose: null,
      send: (bytes) => outgoing.push(() => closed || real.send(bytes)),
      close: () => {
        closed = true;
        real.close();
      },
    };
    real.onopen = () => shown.onopen?.();
    real.onmessage = (event) => incoming.push(() => shown.onmessage?.(event));
    real.onclose = (event) => {
      closed = true;
      incoming.push(() => shown.onclose?.(event));
    };
    return shown;
  };
}
