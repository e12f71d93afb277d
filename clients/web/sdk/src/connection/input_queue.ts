// Inputs on their way to the server, under numbers that rise from 1: those that wait to be sent, and those that were sent and are not
// answered yet, which are sent again when the connection broke before they came. The C++ client library has the same
// (clients/cpp/core/src/input_outbox.h), with datagrams beside the stream.

const AWAITING_RESULT_MAX = 8192; // a server that answers nothing: the oldest are not sent again

export class InputQueue<Input> {
  private waiting: Input[] = [];
  private awaitingResult: { sequence: number; input: Input }[] = []; // rising
  private nextUnsent = 1; // of waiting[0]
  private resumed = false; // answers may come twice

  /** The newest one that was not sent. */
  get last(): Input | undefined {
    return this.waiting[this.waiting.length - 1];
  }
  get length(): number {
    return this.waiting.length;
  }
  get lastSent(): number {
    return this.nextUnsent - 1;
  }
  /** The number of the newest one, sent or not. */
  get newest(): number {
    return this.lastSent + this.waiting.length;
  }

  push(input: Input): void {
    this.waiting.push(input);
  }

  replaceLast(input: Input): void {
    this.waiting[this.waiting.length - 1] = input;
  }

  /** The next ones to send, at most so many. */
  take(most: number): { firstSequence: number; inputs: Input[] } {
    const firstSequence = this.nextUnsent;
    const inputs = this.waiting.splice(0, most);
    for (const input of inputs) this.awaitingResult.push({ sequence: this.nextUnsent++, input });
    if (this.awaitingResult.length > AWAITING_RESULT_MAX) this.awaitingResult.splice(0, this.awaitingResult.length - AWAITING_RESULT_MAX);
    return { firstSequence, inputs };
  }

  /** One was answered. False: it was so before, on the connection that broke. */
  onResult(sequence: number): boolean {
    const at = this.awaitingResult.findIndex((sent) => sent.sequence >= sequence);
    if (at < 0 || this.awaitingResult[at]!.sequence !== sequence) return !this.resumed;
    this.awaitingResult.splice(at, 1);
    return true;
  }

  /** A new client: numbers begin anew, and nothing waits. */
  startNewSession(): void {
    this.waiting = [];
    this.awaitingResult = [];
    this.nextUnsent = 1;
    this.resumed = false;
  }

  /** The same client, of which the server has the inputs up to that one: those after it are sent again. */
  resumeAfter(lastSequence: number): void {
    const last = Math.min(lastSequence, this.lastSent);
    const again = this.awaitingResult.filter((sent) => sent.sequence > last).map((sent) => sent.input);
    this.awaitingResult = this.awaitingResult.filter((sent) => sent.sequence <= last);
    this.waiting = [...again, ...this.waiting];
    this.nextUnsent = last + 1;
    this.resumed = true;
  }
}
