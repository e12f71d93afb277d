"""A minimal HTTP/2 client for regular gRPC calls and for frames that no library would send.

It writes headers as HPACK literals without indexing and announces a header table size of 0, so neither side needs a dynamic
table. Its own windows have the maximum size. `send_data` respects the windows of the peer; an attack that writes frames
directly ignores them.
"""

import struct
import time

from .net import Closed, connect

PREFACE = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"
DATA, HEADERS, PRIORITY, RST_STREAM, SETTINGS, PUSH_PROMISE, PING, GOAWAY, WINDOW_UPDATE, CONTINUATION = range(10)
END_STREAM, ACK, END_HEADERS = 1, 1, 4
BIGGEST_WINDOW = 2**31 - 1


def frame(kind, flags, stream, payload=b""):
    return struct.pack(">IBI", len(payload) << 8 | kind, flags, stream) + payload


def settings(**values):
    ids = {"header_table_size": 1, "enable_push": 2, "streams": 3, "initial_window": 4, "max_frame_size": 5}
    return frame(SETTINGS, 0, 0, b"".join(struct.pack(">HI", ids[name], value) for name, value in values.items()))


def _prefixed(value, bits, first=0):
    limit = (1 << bits) - 1
    if value < limit:
        return bytes([first | value])
    out, value = bytearray([first | limit]), value - limit
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes(out) + bytes([value])


def literal(name, value):
    name, value = (part.encode() if isinstance(part, str) else part for part in (name, value))
    return b"\0" + _prefixed(len(name), 7) + name + _prefixed(len(value), 7) + value


def request_headers(path, **more):
    head = [(":method", "POST"), (":scheme", "http"), (":path", path), (":authority", "localhost"),
            ("content-type", "application/grpc"), ("te", "trailers")]
    return b"".join(literal(*pair) for pair in head + [(k.replace("_", "-"), v) for k, v in more.items()])


def grpc_message(payload, compressed=0, declared=None):
    return struct.pack(">BI", compressed, len(payload) if declared is None else declared) + payload


def _read_int(block, at, bits):
    limit = (1 << bits) - 1
    value = block[at] & limit
    at += 1
    shift = 0
    while value >= limit and shift < 35:
        byte = block[at]
        value += (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if byte < 0x80:
            break
    return value, at


def _read_string(block, at):
    size, end = _read_int(block, at, 7)
    # Huffman-coded strings are not decoded; the attacks do not need them.
    return block[end:end + size].decode("latin-1"), end + size


def read_headers(block):
    """The literal headers of a header block by name. Of the static table, only :status 200 is decoded."""
    out, at = {}, 0
    while at < len(block):
        byte = block[at]
        if byte & 0x80:
            index, at = _read_int(block, at, 7)
            if index == 8:
                out[":status"] = "200"
            continue
        if byte & 0xE0 == 0x20:
            _, at = _read_int(block, at, 5)
            continue
        index, at = _read_int(block, at, 6 if byte & 0x40 else 4)
        name, at = _read_string(block, at) if index == 0 else (f"static {index}", at)
        value, at = _read_string(block, at)
        out[name] = value
    return out


class Stream:
    def __init__(self, keep):
        self.data, self.headers, self.ended, self.keep, self.bytes, self.window = bytearray(), {}, None, keep, 0, 0

    def next_message(self):
        if len(self.data) < 5:
            return None
        size = int.from_bytes(self.data[1:5], "big")
        if len(self.data) < 5 + size:
            return None
        message = bytes(self.data[5:5 + size])
        del self.data[:5 + size]
        return message

    @property
    def status(self):
        """The gRPC status as a number, or the reason why the stream ended without one."""
        code = self.headers.get("grpc-status")
        return int(code) if code is not None else self.ended


class Connection:
    def __init__(self, port, source=None, timeout=5.0, window=BIGGEST_WINDOW, receive_buffer=None):
        self.sock, self.timeout = connect(port, source, timeout, receive_buffer), timeout
        self.streams, self.buffer, self.next_id = {}, bytearray(), 1
        self.peer_window, self.peer_stream_window, self.goaway = 65535, 65535, None
        preface = PREFACE + settings(header_table_size=0, enable_push=0, initial_window=window)
        if window > 65535:
            preface += frame(WINDOW_UPDATE, 0, 0, struct.pack(">I", window - 65535))
        self.send(preface)

    def send(self, data):
        """Send all of it. After a timeout only a part of a frame may have been sent, so the connection is unusable."""
        self.sock.settimeout(self.timeout)
        try:
            self.sock.sendall(data)
        except TimeoutError:
            raise Closed("the server does not read") from None

    def open(self, path, end=False, keep=True, **headers):
        number, self.next_id = self.next_id, self.next_id + 2
        self.streams[number] = stream = Stream(keep)
        stream.window = self.peer_stream_window
        self.send(frame(HEADERS, END_HEADERS | (END_STREAM if end else 0), number, request_headers(path, **headers)))
        return number

    def send_data(self, number, payload, end=False, patience=5.0):
        """Send the payload as the windows of the peer allow. Return the number of bytes sent."""
        until, sent, stream = time.monotonic() + patience, 0, self.streams[number]
        while True:
            room = min(16384, self.peer_window, stream.window, len(payload) - sent)
            last = sent + room == len(payload)
            if room > 0 or len(payload) == 0:
                self.send(frame(DATA, END_STREAM if end and last else 0, number, payload[sent:sent + room]))
                sent += room
                self.peer_window -= room
                stream.window -= room
                if last:
                    return sent
            elif stream.ended is not None or not self.pump(until):
                return sent

    def pump(self, until):
        """Read once and process each complete frame. Return False if nothing arrived until then."""
        left = until - time.monotonic()
        if left <= 0:
            return False
        self.sock.settimeout(left)
        try:
            data = self.sock.recv(1 << 18)
        except TimeoutError:
            return False
        if not data:
            raise Closed(self.goaway or "connection closed")
        self.buffer += data
        at = 0
        while len(self.buffer) - at >= 9:
            size = int.from_bytes(self.buffer[at:at + 3], "big")
            if len(self.buffer) - at < 9 + size:
                break
            kind, flags = self.buffer[at + 3], self.buffer[at + 4]
            number = int.from_bytes(self.buffer[at + 5:at + 9], "big") & 0x7FFFFFFF
            self._on_frame(kind, flags, number, bytes(self.buffer[at + 9:at + 9 + size]))
            at += 9 + size
        del self.buffer[:at]
        return True

    def _on_frame(self, kind, flags, number, payload):
        stream = self.streams.get(number)
        if kind == SETTINGS and not flags & ACK:
            for i in range(0, len(payload) - 5, 6):
                name, value = struct.unpack_from(">HI", payload, i)
                if name == 4:
                    for known in self.streams.values():
                        known.window += value - self.peer_stream_window
                    self.peer_stream_window = value
            self.send(frame(SETTINGS, ACK, 0))
        elif kind == PING and not flags & ACK:
            self.send(frame(PING, ACK, 0, payload))
        elif kind == WINDOW_UPDATE:
            more = int.from_bytes(payload, "big") & 0x7FFFFFFF
            if number == 0:
                self.peer_window += more
            elif stream:
                stream.window += more
        elif kind == GOAWAY:
            self.goaway = f"GOAWAY {int.from_bytes(payload[4:8], 'big')} {payload[8:].decode('latin-1')}"
        elif stream is None:
            return
        elif kind == DATA:
            stream.bytes += len(payload)
            if stream.keep:
                stream.data += payload
        elif kind == HEADERS:
            stream.headers.update(read_headers(payload))
        elif kind == RST_STREAM:
            stream.ended = f"RST_STREAM {int.from_bytes(payload, 'big')}"
        if kind in (DATA, HEADERS) and flags & END_STREAM:
            stream.ended = stream.ended or "end"

    def call(self, path, payload=b"", timeout=5.0):
        """One unary call: (status, error message, response)."""
        number = self.open(path)
        until = time.monotonic() + timeout
        self.send_data(number, grpc_message(payload), end=True, patience=timeout)
        stream = self.streams[number]
        while stream.ended is None:
            if not self.pump(until):
                del self.streams[number]
                return "no response", f"within {timeout:g} s", b""
        del self.streams[number]
        return stream.status, stream.headers.get("grpc-message", ""), stream.next_message() or b""

    def close(self):
        self.sock.close()


def call(port, path, payload=b"", timeout=5.0, source=None):
    """Make one call on a connection of its own. The end of the connection counts as a status."""
    try:
        connection = Connection(port, source, timeout)
        try:
            return connection.call(path, payload, timeout)
        finally:
            connection.close()
    except (OSError, Closed) as ended:
        return "no connection", str(ended), b""
