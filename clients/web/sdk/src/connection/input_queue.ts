// Inputs under ascending sequence numbers from 1: those waiting to be sent, and those sent without a
// result, which are resent if the connection breaks before the server received them.
// clients/cpp/core/src/input_outbox.h is the counterpart in the C++ client library, which also supports
// datagrams.

const AWAITING_RESULT_MAX = 8192; // bounds the memory if the server sends no results: older inputs are not resent

export class InputQueue<Input> {
  private waiting: Input[] = [];
  private awaitingResult: { sequence: number; input: Input }[] = []; // rising
  private nextUnsent = 1; // sequence of waiting[0]
  private resumed = false; // results may arrive twice

  /** The newest unsent input. */
  get last(): Input | undefined {
    return this.waiting[this.waiting.length - 1];
  }
  get length(): number {
    return this.waiting.length;
  }
  get lastSent(): number {
    return this.nextUnsent - 1;
  }
  /** Sequence of the newest input, sent or not. */
  get newest(): number {
    return this.lastSent + this.waiting.length;
  }

  push(input: Input): void {
    this.waiting.push(input);
  }

  replaceLast(input: Input): void {
    this.waiting[this.waiting.length - 1] = input;
  }

  /** Takes at max `max` inputs to send. */
  take(max: number): { firstSequence: number; inputs: Input[] } {
    const firstSequence = this.nextUnsent;
    const inputs = this.waiting.splice(0, max);
    for (const input of inputs) this.awaitingResult.push({ sequence: this.nextUnsent++, input });
    if (this.awaitingResult.length > AWAITING_RESULT_MAX) this.awaitingResult.splice(0, this.awaitingResult.length - AWAITING_RESULT_MAX);
    return { firstSequence, inputs };
  }

  /** Returns false for a result that the previous connection already delivered. */
  onResult(sequence: number): boolean {
    const at = this.awaitingResult.findIndex((sent) => sent.sequence >= sequence);
    if (at < 0 || this.awaitingResult[at]!.sequence !== sequence) return !this.resumed;
    this.awaitingResult.splice(at, 1);
    return true;
  }

  /** Starts a new session: sequences restart at 1 and no input waits. */
  startNewSession(): void {
    this.waiting = [];
    this.awaitingResult = [];
    this.nextUnsent = 1;
    this.resumed = false;
  }

  /**
   * Resumes a session of which the server has all inputs up to `lastSequence`; later inputs are resent.
   */
  resumeAfter(lastSequence: number): void {
    const last = Math.min(lastSequence, this.lastSent);
    const resent = this.awaitingResult.filter((sent) => sent.sequence > last).map((sent) => sent.input);
    this.awaitingResult = this.awaitingResult.filter((sent) => sent.sequence <= last);
    this.waiting = [...resent, ...this.waiting];
    this.nextUnsent = last + 1;
    this.resumed = true;
  }
}
