// A socket for tests: records what the client sends, and delivers messages of the server.

import { create, fromBinary, toBinary } from '@bufbuild/protobuf';
import type { Socket } from '../connection/connection.js';
import { ClientMessageSchema, ServerMessageSchema } from '../gen/jostle/v1/play_pb.js';

export class FakeSocket implements Socket {
  binaryType = '';
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  sent: Uint8Array[] = [];
  closed = false;

  send(bytes: Uint8Array): void {
    this.sent.push(bytes);
  }
  close(): void {
    this.closed = true;
  }

  /** Removes and returns the sent messages. */
  take() {
    return this.sent.splice(0).map((bytes) => fromBinary(ClientMessageSchema, bytes).message);
  }
  deliver(message: Parameters<typeof create<typeof ServerMessageSchema>>[1]): void {
    const bytes = toBinary(ServerMessageSchema, create(ServerMessageSchema, message));
    this.onmessage?.({ data: bytes.slice().buffer as ArrayBuffer });
  }
}
