"""A minimal WebSocket client. Its mask is zero, so masking costs nothing. `frame` also writes forbidden frames."""

import struct
import time

from .net import Closed, connect

CONTINUATION, TEXT, BINARY, CLOSE, PING, PONG = 0, 1, 2, 8, 9, 10


def frame(payload, opcode=BINARY, final=True, masked=True, declared=None):
    size = len(payload) if declared is None else declared
    head = bytes([(0x80 if final else 0) | opcode])
    mask = 0x80 if masked else 0
    if size < 126:
        head += bytes([mask | size])
    elif size < 65536:
        head += struct.pack(">BH", mask | 126, size)
    else:
        head += struct.pack(">BQ", mask | 127, size)
    return head + (b"\0\0\0\0" if masked else b"") + payload


def upgrade(port, path="/play", **headers):
    lines = [f"GET {path} HTTP/1.1", f"Host: 127.0.0.1:{port}", "Upgrade: websocket", "Connection: Upgrade",
             "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==", "Sec-WebSocket-Version: 13"]
    lines += [f"{name}: {value}" for name, value in headers.items()]
    return ("\r\n".join(lines) + "\r\n\r\n").encode()


class WebSocket:
    def __init__(self, port, source=None, timeout=5.0, receive_buffer=None, **headers):
        self.sock, self.timeout = connect(port, source, timeout, receive_buffer), timeout
        self.buffer = bytearray()
        try:
            self.sock.sendall(upgrade(port, **headers))
            while b"\r\n\r\n" not in self.buffer:
                self._more()
        except OSError:
            self.sock.close()
            raise
        head, _, rest = bytes(self.buffer).partition(b"\r\n\r\n")
        self.buffer = bytearray(rest)
        if b" 101 " not in head.split(b"\r\n")[0]:
            self.sock.close()
            raise Closed(head.split(b"\r\n")[0].decode("latin-1"))

    def send(self, message):
        self.send_raw(frame(message))

    def send_raw(self, data):
        self.sock.settimeout(self.timeout)
        self.sock.sendall(data)

    def receive(self, until):
        """The next message, or None if none arrived until then."""
        while True:
            message = self._next()
            if message is not None:
                return message
            left = until - time.monotonic()
            if left <= 0:
                return None
            self.sock.settimeout(left)
            try:
                self._more()
            except TimeoutError:
                return None

    def buffered(self):
        return self._next()

    def _more(self):
        data = self.sock.recv(1 << 18)
        if not data:
            raise Closed("connection closed")
        self.buffer += data

    def _next(self):
        while len(self.buffer) >= 2:
            size, at = self.buffer[1] & 0x7F, 2
            if size >= 126:
                wide = 2 if size == 126 else 8
                if len(self.buffer) < 2 + wide:
                    return None
                size, at = int.from_bytes(self.buffer[2:2 + wide], "big"), 2 + wide
            if len(self.buffer) < at + size:
                return None
            opcode, payload = self.buffer[0] & 15, bytes(self.buffer[at:at + size])
            del self.buffer[:at + size]
            if opcode == CLOSE:
                raise Closed(int.from_bytes(payload[:2], "big"), payload[2:])
            if opcode == PING:
                self.send_raw(frame(payload, PONG))
            elif opcode in (BINARY, TEXT):
                return payload
        return None

    def close(self):
        self.sock.close()
