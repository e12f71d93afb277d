#!/usr/bin/env python3
"""Record the traffic of real clients as inputs of the fuzz target whole_server.

Usage: record_sessions.py PROGRAMS FOLDER [--seconds SECONDS]
PROGRAMS is a folder with jostle-server, jostle-bot, jostle-load and jostlectl, such as build/release/bin.
FOLDER receives the inputs, with names that say what they contain; pack them with corpus_archive.py.

The clients connect to relays that store the bytes they send. A session is cut into inputs as raw bytes, as frames and
as messages, so that the fuzzer can change it at each of these levels. whole_server.cpp describes the records.
"""

import argparse
import json
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request

INPUT_BYTES_MAX = 8000  # len_max of the target in scripts/fuzz is 8192
RECORDS_MAX = 64
MESSAGE, RAW, PAUSE, CALL, FRAME, DATAGRAM, HALF_CLOSE, RESET = range(8)
GRPC, WEBSOCKET = 0, 2  # numbers of connections
PREFACE = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"


def record(kind, connection, content=b""):
    return struct.pack("<BH", kind | connection << 3, len(content)) + content


class Relay:
    """Accepts connections, forwards them and stores what each client sends."""

    def __init__(self, port):
        self.target, self.sessions = port, []
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            client, _ = self.listener.accept()
            server = socket.create_connection(("127.0.0.1", self.target))
            sent = bytearray()
            self.sessions.append(sent)
            for source, sink, kept in ((client, server, sent), (server, client, None)):
                threading.Thread(target=self._forward, args=(source, sink, kept), daemon=True).start()

    @staticmethod
    def _forward(source, sink, kept):
        try:
            while data := source.recv(65536):
                if kept is not None:
                    kept += data
                sink.sendall(data)
            sink.shutdown(socket.SHUT_WR)
        except OSError:
            pass


class DatagramRelay:
    """The same for datagrams; each client has a socket of its own to the server."""

    def __init__(self):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]
        self.target, self.packets, self.paths = None, [], {}
        threading.Thread(target=self._forward, daemon=True).start()

    def _forward(self):
        while True:
            data, address = self.socket.recvfrom(65536)
            self.packets.append(data)
            if address not in self.paths:
                self.paths[address] = path = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
                path.connect(("127.0.0.1", self.target))
                threading.Thread(target=self._back, args=(path, address), daemon=True).start()
            self.paths[address].send(data)

    def _back(self, path, address):
        while True:
            self.socket.sendto(path.recv(65536), address)


def http2_frames(data):
    """(type, flags, stream, payload) of each complete frame."""
    at = len(PREFACE)
    while at + 9 <= len(data):
        length = int.from_bytes(data[at:at + 3], "big")
        kind, flags, stream = data[at + 3], data[at + 4], int.from_bytes(data[at + 5:at + 9], "big")
        if at + 9 + length > len(data):
            return
        yield kind, flags, stream, data[at + 9:at + 9 + length]
        at += 9 + length


def grpc_messages(data):
    """Messages of all streams, in order of their ends."""
    buffers = {}
    for kind, _, stream, payload in http2_frames(data):
        if kind != 0:
            continue
        buffer = buffers[stream] = buffers.get(stream, b"") + payload
        while len(buffer) >= 5 and len(buffer) >= 5 + int.from_bytes(buffer[1:5], "big"):
            end = 5 + int.from_bytes(buffer[1:5], "big")
            yield buffer[5:end]
            buffer = buffer[end:]
        buffers[stream] = buffer


def websocket_frames(data):
    """(first byte, payload) of each complete frame after the request, without the mask."""
    at = data.find(b"\r\n\r\n") + 4
    while at + 6 <= len(data):
        first, length = data[at], data[at + 1] & 0x7f
        at += 2
        if length > 125:
            size = 2 if length == 126 else 8
            length, at = int.from_bytes(data[at:at + size], "big"), at + size
        mask, payload = data[at:at + 4], data[at + 4:at + 4 + length]
        at += 4 + length
        if at > len(data):
            return
        yield first, bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))


class Recorder:
    def __init__(self, folder):
        self.folder, self.written = folder, 0

    def write(self, name, records):
        """Splits the records into inputs. The first record, such as a Hello, begins each of them."""
        first, part, size, number = records[:1], [], 0, 0
        for each in records[1:] + [None]:
            if each is None or len(part) + 2 > RECORDS_MAX or size + len(each) + len(first[0]) > INPUT_BYTES_MAX:
                if number < 4 and (part or number == 0):
                    (self.folder / f"{name}_{number}.session").write_bytes(b"".join(first + part))
                    self.written += 1
                number, part, size = number + 1, [], 0
            if each is not None and len(each) + len(first[0]) <= INPUT_BYTES_MAX:
                part.append(each)
                size += len(each)

    def grpc(self, name, data):
        raw = [data[at:at + 1000] for at in range(0, min(len(data), 7000), 1000)]
        self.write(f"{name}_bytes", [record(RAW, GRPC, piece) for piece in raw])
        self.write(f"{name}_frames", [
            record(FRAME, GRPC, bytes([kind, flags, stream & 0xff]) + payload)
            for kind, flags, stream, payload in http2_frames(data)])
        self.write(f"{name}_messages", [record(MESSAGE, GRPC, each) for each in grpc_messages(data)])
        self.write(f"{name}_messages_websocket", [record(MESSAGE, WEBSOCKET, each) for each in grpc_messages(data)])

    def http(self, name, data):
        if b"Upgrade: websocket" not in data[:1000]:
            return self.write(f"{name}_bytes", [record(RAW, WEBSOCKET, data[:7000])])
        head = data[:data.find(b"\r\n\r\n") + 4]
        rest = data[len(head):len(head) + 6000]
        self.write(f"{name}_bytes", [record(RAW, WEBSOCKET, head), record(PAUSE, WEBSOCKET, b"\3")] + [
            record(RAW, WEBSOCKET, rest[at:at + 1000]) for at in range(0, len(rest), 1000)])
        self.write(f"{name}_messages", [record(FRAME, WEBSOCKET, bytes([first]) + payload)
                                        for first, payload in websocket_frames(data)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=4)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    datagrams = DatagramRelay()
    with tempfile.TemporaryDirectory() as scratch:
        ports_file = pathlib.Path(scratch, "ports.json")
        settings = pathlib.Path(scratch, "server.toml")
        settings.write_text(f'[datagrams]\nlisten = "127.0.0.1:0"\nadvertised_port = {datagrams.port}\n')
        server = subprocess.Popen([options.programs / "jostle-server", "--config", settings, "--listen", "127.0.0.1:0",
                                   "--http", "127.0.0.1:0", "--admin", "", "--scene", "stack",
                                   "--port-file", ports_file], stderr=subprocess.DEVNULL)
        try:
            until = time.monotonic() + 20
            while not ports_file.exists():
                if server.poll() is not None or time.monotonic() > until:
                    raise RuntimeError("jostle-server did not start")
                time.sleep(0.05)
            ports = json.loads(ports_file.read_text())
            datagrams.target = ports["datagrams"]
            play(options, Relay(ports["grpc"]), Relay(ports["http"]), datagrams)
        finally:
            server.terminate()
            server.wait()


def play(options, grpc, http, datagrams):
    recorder, seconds = Recorder(options.folder), str(options.seconds)

    def run(program, *flags):
        subprocess.run([options.programs / program, *flags], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       timeout=60)
        time.sleep(0.3)

    def take(relay):
        sessions = [bytes(session) for session in relay.sessions if session]
        relay.sessions.clear()
        return sessions

    address = f"127.0.0.1:{grpc.port}"
    run("jostle-bot", "--server", address, "--count", "5", "--seconds", seconds, "--events")
    for number, session in enumerate(take(grpc)):
        recorder.grpc(f"bot{number}", session)
    run("jostle-bot", "--server", address, "--count", "1", "--seconds", seconds, "--datagrams")
    packets = [packet for packet in datagrams.packets if len(packet) < 2000]
    recorder.write("datagrams", [record(DATAGRAM, 0, packet) for packet in packets[:200]])
    for session in take(grpc)[:1]:
        recorder.grpc("bot_with_datagrams", session)
    run("jostle-load", "--server", f"127.0.0.1:{http.port}", "--passive", "--websocket", "--clients", "1", "--ramp", "0",
        "--seconds", seconds)
    for session in take(http)[:1]:
        recorder.http("passive_websocket", session)
    run("jostle-load", "--server", address, "--passive", "--clients", "1", "--ramp", "0", "--seconds", seconds,
        "--interest-radius", "20")
    for session in take(grpc)[:1]:
        recorder.grpc("passive", session)
    for name, flags in {"worlds": ["worlds"], "clients": ["clients", "stack"], "pause": ["pause", "stack"],
                        "resume": ["resume", "stack"], "create": ["world", "create", "second", "--scene", "stack"],
                        "export": ["export", "stack", "-"], "bans": ["bans"]}.items():
        run("jostlectl", "--server", address, *flags)
        for session in take(grpc)[:1]:
            recorder.grpc(f"ctl_{name}", session)
    for name, path, body in (("viewer", "/", None), ("worlds", "/api/worlds", None), ("health", "/healthz", None),
                             ("create", "/api/worlds", b'{"name": "third", "sceneName": "stack"}'),
                             ("rays", "/api/query/CastRays", b'{"world": "stack", "rays": [{"origin": {"y": 9}, '
                                                             b'"direction": {"y": -1}, "maxDistance": 20}]}')):
        request = urllib.request.Request(f"http://127.0.0.1:{http.port}{path}", data=body,
                                         headers={"Content-Type": "application/json"} if body else {})
        try:
            urllib.request.urlopen(request, timeout=5).read()
        except urllib.error.HTTPError:
            pass
        for session in take(http)[:1]:
            recorder.http(f"http_{name}", session)
    print(f"{recorder.written} inputs in {options.folder}")


if __name__ == "__main__":
    sys.exit(main())
