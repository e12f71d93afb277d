"""Malformed messages, frames and requests, and cross-origin requests that a browser must not be able to send."""

import os
import random
import time

from . import http2, messages, websocket
from .arena import attack
from .net import SERVER, Closed, connect
from .player import TRANSPORTS, Player, open_stream
from .protobuf import double, nested, text, uint, varint
from .server import http_answers

INFINITY, NOT_A_NUMBER = float("inf"), float("nan")


def broken_messages(rng):
    """ClientMessages that are malformed in every possible way."""
    hello = messages.hello("target")
    yield hello[:-1]
    yield hello + b"\xff" * 20
    yield rng.randbytes(rng.randrange(1, 3000))
    yield b"\x0b" * 20000  # nested groups
    yield nested(2, nested(2, nested(1, nested(1, nested(15, nested(1, b"\x0a\x00" * 5000))))))
    nest = b""
    for _ in range(3000):
        nest = nested(1, nested(15, nest))  # nested compounds, as deep as 64 KiB allow
        if len(nest) > 60000:
            break
    yield nested(2, uint(1, 1) + nested(2, nested(1, nest)))
    yield varint(2**64 - 1)
    yield nested(1, uint(1, 99))
    yield nested(1, text(4, b"\xff\xfe"))  # a string that is not UTF-8
    yield b""
    yield messages.batch(2**32 - 1, [messages.release()] * 3)
    yield messages.batch(0, [messages.release()])
    yield messages.batch(1, [messages.release()] * 65)
    yield bytes(70000)


def wild_inputs():
    """Inputs with values that are not finite or far out of range."""
    for wild in (INFINITY, -INFINITY, NOT_A_NUMBER, 1e308, 5e-324):
        yield messages.spawn(messages.sphere(wild), (0, 1, 0))
        yield messages.spawn(messages.box(1, wild, 1), (wild, 1, 0))
        yield messages.spawn(messages.hull([(wild, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]), (0, 1, 0))
        yield messages.spawn(messages.hull([(0, 0, 0)] * 32), (0, 1, 0))
        yield messages.spawn(messages.sphere(0.5) + double(7, wild) + double(9, wild), (0, 1, 0), (wild, 0, 0))
        yield messages.impulse(5, (wild, wild, 0))
        yield messages.grab(5, (wild, 0, 0))
        yield messages.drag((wild, wild, wild))
        yield messages.explode((wild, 0, 0), wild, wild)


def _garble(number, ports, seconds):
    rng, until, done = random.Random(number), time.monotonic() + seconds, 0
    while time.monotonic() < until:
        for message in broken_messages(rng):
            try:
                if rng.random() < 0.5:
                    link = Player(ports, TRANSPORTS[done % 2]).link
                else:
                    link = open_stream(ports, TRANSPORTS[done % 2], timeout=1.0)
                link.send(message)
                link.receive(time.monotonic() + 0.005)
                link.close()
            except (OSError, Closed):
                pass
            done += 1
        try:
            player = Player(ports, TRANSPORTS[done % 2])
            for each in wild_inputs():
                player.act(each)
                player.receive(time.monotonic() + 0.002)
            player.close()
        except (OSError, Closed):
            pass
    return done


@attack("play-garbage", seconds=8)
def play_garbage(arena):
    """Malformed protobuf and non-finite numbers on Play, over both transports."""
    done = arena.fork(4, _garble, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done):,} malformed messages")


def _random_frames(number, ports, seconds):
    rng, until, done = random.Random(number), time.monotonic() + seconds, 0
    while time.monotonic() < until:
        try:
            sock = connect(ports.grpc, timeout=0.5)
            sock.sendall(http2.PREFACE + http2.settings() if rng.random() < 0.9 else rng.randbytes(60))
            for _ in range(rng.randrange(1, 30)):
                sock.sendall(http2.frame(rng.randrange(12), rng.randrange(256), rng.choice((0, 1, 3, 2, rng.randrange(2**31))),
                                         rng.randbytes(rng.choice((0, 4, 5, 8, 6, 40, 4000)))))
                done += 1
            sock.close()
        except OSError:
            pass
    return done


@attack("http2-garbage", seconds=8)
def http2_garbage(arena):
    """Random HTTP/2 frames of every kind."""
    done = arena.fork(4, _random_frames, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done):,} frames")


def invalid_header_blocks():
    """Header blocks that gRPC 1.5x mistreats, one connection each, with the advisory."""
    call = b"".join(http2.literal(*pair) for pair in (
        (":method", "POST"), (":path", messages.LIST_WORLDS), (":authority", "localhost"),
        ("content-type", "application/grpc")))
    good = http2.literal(":scheme", "http") + http2.literal("te", "trailers")
    # CVE-2023-1428: an invalid header, then more than 8 KiB.
    for size in (8000, 9000, 15000):
        large = http2.literal("x-large", "y" * size)
        yield call + http2.literal(":scheme", "http") + http2.literal("te", "x") + large
        yield call + http2.literal(":scheme", "x") + http2.literal("te", "trailers") + large
        yield call + good + http2.literal("grpclb_client_stats", "x") + large
        # CVE-2023-32731: an entry of the dynamic table after the limit is exceeded.
        yield call + good + large + b"\x40\x03x-a\x01b"
    yield call + good + http2.literal("x-bad-bin", "!!!!")  # CVE-2023-32732: not base64
    yield call + good + b"\x40\x09x-bad-bin\x04!!!!" + b"\xbe" * 10  # CVE-2024-7246: indexed, and then referenced
    # CVE-2023-33953: a length with padding.
    yield call + good + b"\x00\x7f" + b"\x80" * 14000 + b"\x00"


def _invalid_headers(number, ports, seconds):
    until, done = time.monotonic() + seconds, 0
    while time.monotonic() < until:
        for block in invalid_header_blocks():
            try:
                sock = connect(ports.grpc, timeout=1.0)
                sock.sendall(http2.PREFACE + http2.frame(http2.SETTINGS, 0, 0)
                             + http2.frame(http2.HEADERS, http2.END_HEADERS | http2.END_STREAM, 1, block))
                sock.recv(65536)
                sock.close()
                done += 1
            except OSError:
                time.sleep(0.01)
    return done


@attack("invalid-headers", seconds=8)
def invalid_headers(arena):
    """Header blocks for which advisories exist against gRPC 1.51 (docs/design/security_model.md)."""
    done = arena.fork(2, _invalid_headers, arena.ports, arena.seconds)
    total = sum(each or 0 for each in done)
    arena.note(f"{total:,} header blocks")
    arena.check(total >= 15, "the server answered each kind of header block")


def websocket_abuses(rng):
    frame = websocket.frame
    yield frame(messages.hello("target"), masked=False)
    yield frame(b"", declared=2**63 - 1)
    yield frame(b"x" * 1000, declared=2**40)
    yield frame(b"x", opcode=websocket.PING, final=False)  # a fragmented control frame
    yield frame(b"x" * 126, opcode=websocket.PING)  # a control frame that is too long
    yield frame(b"x", opcode=3) + frame(b"x", opcode=11)               # reserved
    yield b"\xf2\x80\0\0\0\0"                                          # reserved bits
    yield frame(b"x", opcode=websocket.CONTINUATION)  # a continuation without a first fragment
    yield frame(b"x", final=False) + frame(b"y")  # a new message between fragments
    yield frame(b"", final=False) + frame(b"", websocket.CONTINUATION, final=False) * 50000
    yield frame(b"", opcode=websocket.PING) * 50000
    yield frame(b"\xff\xff\xff", opcode=websocket.TEXT)
    yield frame(b"\x03", opcode=websocket.CLOSE)
    yield frame(b"\x00\x00" + b"\xff" * 100, opcode=websocket.CLOSE)
    yield frame(b"x" * 65536)
    yield rng.randbytes(5000)


def _abuse(number, ports, seconds):
    rng, until, done = random.Random(number), time.monotonic() + seconds, 0
    while time.monotonic() < until:
        for data in websocket_abuses(rng):
            try:
                link = websocket.WebSocket(ports.http, timeout=1.0)
                if rng.random() < 0.5:
                    link.send(messages.hello("target"))
                link.send_raw(data)
                link.receive(time.monotonic() + 0.005)
                link.close()
            except (OSError, Closed):
                pass
            done += 1
    return done


@attack("websocket-abuse", seconds=8)
def websocket_abuse(arena):
    """Unmasked, endless, reserved and wrongly fragmented frames; tens of thousands of pings and empty fragments."""
    done = arena.fork(4, _abuse, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done):,} malformed frames")


def _endless_pings(number, ports, seconds, data):
    until, sent = time.monotonic() + seconds, 0
    while time.monotonic() < until:
        try:
            link = websocket.WebSocket(ports.http, timeout=1.0)
            link.send(messages.hello("target"))
            while time.monotonic() < until:
                link.send_raw(data)
                sent += len(data)
                link.receive(time.monotonic())
        except (OSError, Closed):
            pass
    return sent


@attack("websocket-pings", seconds=8)
def websocket_pings(arena):
    """Four players send pings and empty fragments endlessly. They never complete a message, so no message limit counts them."""
    pings = websocket.frame(b"", opcode=websocket.PING) * 2000
    sent = arena.fork(4, _endless_pings, arena.ports, arena.seconds, pings)
    arena.note(f"{sum(each or 0 for each in sent) / 1e6:,.0f} MB")


# --- HTTP ---

def request(ports, data, seconds=3.0):
    """Send raw bytes. Return the status of the response, 0 if there is none, and its bytes."""
    response = b""
    try:
        sock = connect(ports.http, timeout=seconds)
        try:
            sock.sendall(data)
        except OSError:
            # The server rejected the request before it read all of it; the response is still
            # available.
            pass
        until = time.monotonic() + seconds
        while time.monotonic() < until and len(response) < 100000:
            sock.settimeout(max(0.01, until - time.monotonic()))
            more = sock.recv(65536)
            response += more
            if not more or b"\r\n\r\n" in response:
                break
        sock.close()
    except OSError:
        pass
    return int(response.split()[1]) if response.startswith(b"HTTP/1.1 ") else 0, response


def post(path, body, host, length=None, **headers):
    lines = [f"POST {path} HTTP/1.1", f"Host: {host}", "Content-Type: application/json", "Connection: close",
             f"Content-Length: {len(body) if length is None else length}"]
    lines += [f"{name}: {value}" for name, value in headers.items()]
    return ("\r\n".join(lines) + "\r\n\r\n").encode() + body


@attack("http-abuse", seconds=12)
def http_abuse(arena):
    """Path traversal, cross-origin requests, oversized bodies and headers, and JSON nested 100,000 deep."""
    host = f"{SERVER}:{arena.ports.http}"
    for path in ("/../../../../etc/passwd", "/..%2f..%2f..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd",
                 "/assets/../../../../../etc/passwd", "/..\\..\\etc\\passwd", "/%00/etc/passwd", "/api/worlds/..%2f..", "/proc/self/environ"):
        status, response = request(arena.ports, f"GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n".encode())
        if b"root:" in response or status not in (400, 403, 404):
            arena.check(False, f"GET {path}: status {status}; expected 400, 403 or 404 and no file content")
    create = b'{"name": "stolen", "sceneName": "pyramid"}'
    expected = [
        ("a POST from another origin", post("/api/worlds", create, host, Origin="http://evil.example"), (403,)),
        ("a POST from origin null", post("/api/worlds", create, host, Origin="null"), (403,)),
        ("/play from another origin", websocket.upgrade(arena.ports.http, Origin="http://evil.example"), (403,)),
        ("40 MB of JSON", post("/api/worlds", b" " * 40_000_000, host), (413,)),
        ("a content length of 40 MB", post("/api/worlds", b"", host, length=40_000_000), (413,)),
        ("JSON nested 100,000 deep", post("/api/worlds", b'{"scene":' * 100000, host), (400,)),
        ("arrays nested 500,000 deep", post("/api/worlds", b"[" * 500000, host), (400,)),
        ("a deeply nested query", post("/api/query/CastRays", b'{"rays":[' * 20000, host), (400,)),
        ("a header of 100 kB", b"GET / HTTP/1.1\r\nX: " + b"y" * 100000 + b"\r\n\r\n", (431, 400)),
        ("bytes that are not HTTP", b"\x16\x03\x01\x02\x00\x01\x00" + b"\0" * 200, (400, 0)),
        ("Content-Length with chunked encoding", post("/api/worlds", create, host, Transfer_Encoding="chunked"), (400, 411, 501)),
        ("a negative Content-Length", post("/api/worlds", b"", host, length=-1), (400,)),
        ("a POST of text/plain", post("/api/worlds", create, host).replace(b"application/json", b"text/plain"), (415,)),
        ("a name of 60,000 bytes", post("/api/worlds", b'{"name": "' + b"n" * 60000 + b'", "sceneName": "pyramid"}', host), (400,)),
    ]
    for what, data, accepted in expected:
        status, _ = request(arena.ports, data.replace(b"Transfer_Encoding", b"Transfer-Encoding"))
        if status not in accepted:
            arena.check(False, f"{what}: status {status}; expected {' or '.join(map(str, accepted))}")


def _unfinished_bodies(number, ports, seconds, count):
    head = post("/api/worlds", b"", "127.0.0.1", length=4 << 20)
    until, socks = time.monotonic() + seconds, []
    for _ in range(count):
        try:
            sock = connect(ports.http, timeout=1.0)
            sock.sendall(head)
            for _ in range(63):
                sock.sendall(b" " * 65536)
            socks.append(sock)
        except OSError:
            pass
    time.sleep(max(0, until - time.monotonic()))
    return len(socks)


@attack("http-unfinished-bodies", seconds=9)
def http_unfinished_bodies(arena):
    """300 POST requests of 4 MiB that stop before the end of the body."""
    held = arena.fork(6, _unfinished_bodies, arena.ports, arena.seconds, 50)
    arena.note(f"{sum(each or 0 for each in held)} of 300 were accepted")
    holds, what = http_answers(arena.ports)
    arena.check(holds, what)


def _pipeline(number, ports, seconds, path):
    """Send requests continuously and never read."""
    until, sent, line = time.monotonic() + seconds, 0, f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n".encode() * 100
    socks = []
    for _ in range(60):
        try:
            socks.append(connect(ports.http, timeout=1.0, receive_buffer=4096))
            socks[-1].setblocking(False)
        except OSError:
            pass
    while time.monotonic() < until:
        for sock in socks:
            try:
                sent += sock.send(line)
            except OSError:
                pass
        time.sleep(0.01)
    return sent


@attack("http-pipeline-unread", seconds=8)
def http_pipeline_unread(arena):
    """240 connections request the worlds and the viewer continuously and never read a response."""
    arena.fork(2, _pipeline, arena.ports, arena.seconds, "/api/worlds")
    arena.fork(2, _pipeline, arena.ports, arena.seconds / 2, "/index.html")


def _post_flood(number, ports, seconds):
    """Queries over HTTP. One thread runs the slow requests of all clients."""
    until, done = time.monotonic() + seconds, 0
    rays = b",".join(b'{"origin":{"x":-50,"y":%d,"z":0},"motion":{"x":100,"y":0,"z":%d}}' % (i % 5, i) for i in range(1000))
    data = post("/api/query/CastRays", b'{"world":"target","mode":"HIT_MODE_ALL","rays":[' + rays + b"]}", "127.0.0.1")
    while time.monotonic() < until:
        done += request(ports, data)[0] == 200
    return done


@attack("http-query-flood", seconds=8)
def http_query_flood(arena):
    """Twenty clients cast 1,000 rays as JSON in a loop. The server must still return the list of worlds."""
    if (child := os.fork()) == 0:
        done = arena.fork(20, _post_flood, arena.ports, arena.seconds)
        arena.note(f"{sum(each or 0 for each in done):,} responses with 1,000 rays")
        os._exit(0)
    time.sleep(arena.seconds / 2)
    holds, what = http_answers(arena.ports, "/api/worlds", seconds=2.0)
    arena.check(holds, f"during the queries: {what}")
    os.waitpid(child, 0)
