// The rate of user messages, so that the server does not refuse them: a token bucket like
// client.user_messages_per_second. Chat has precedence over cursors.

export const MESSAGES_PER_SECOND = 5; // the server's default
const BURST = 10;

export class MessageBudget {
  private tokens = BURST;
  private atMs: number | undefined;
  private closedUntilMs = -Infinity;

  /** Takes one message if more than `reserve` others remain; returns whether it may be sent. */
  take(nowMs: number, reserve: number): boolean {
    this.tokens = Math.min(BURST, this.tokens + ((nowMs - (this.atMs ?? nowMs)) / 1000) * MESSAGES_PER_SECOND);
    this.atMs = nowMs;
    if (nowMs < this.closedUntilMs || this.tokens < 1 + reserve) return false;
    this.tokens--;
    return true;
  }

  /** The server refused a message: its limit is lower. */
  close(nowMs: number, milliseconds: number): void {
    this.closedUntilMs = nowMs + milliseconds;
    this.tokens = Math.min(this.tokens, 1);
  }
}
