"""The log: forged lines, and an output that is not read or is closed."""

import re
import time

from . import messages
from .arena import attack
from .http2 import call
from .net import Closed
from .player import TRANSPORTS, Player
from .websocket import WebSocket

LINE_MAX = 2048  # bytes; a longer line was not truncated
LOG_MAX_MB = 4  # for 2,000 rejections with a name of 60 kB each


def knock(ports, transport="websocket", **hello):
    """Send a Hello and wait for the response."""
    try:
        player = Player(ports, transport, **hello)
        player.until(messages.SNAPSHOT, 0.5)
        player.close()
    except (OSError, Closed):
        pass


@attack("log-forgery", seconds=6)
def log_forgery(arena):
    """Names with line breaks and escape sequences in Hellos, tickets, worlds and scenes. Then the test reads the log."""
    tricks = ["x\n2026-01-01 info FORGED", "x\r\nFORGED", "x\x1b[2J\x1b[31mFORGED", "x\u2028FORGED\u0085FORGED", "x\0FORGED", "{}{:n}%s%n FORGED"]
    for trick in tricks:
        for transport in TRANSPORTS:
            knock(arena.ports, transport, name=trick)
            knock(arena.ports, transport, name="n", world=trick)
            knock(arena.ports, transport, name="n", ticket=trick)
        one = messages.scene([messages.floor()], name=trick)
        call(arena.ports.grpc, messages.CREATE_WORLD, messages.create_world(trick, one))
        call(arena.ports.grpc, messages.CREATE_WORLD, messages.create_world("plain", messages.scene([messages.body(messages.sphere(-1), name=trick)])))
        call(arena.ports.grpc, messages.DELETE_WORLD, messages.text(1, trick))
    time.sleep(0.5)
    log = arena.server_log()
    lines = log.split(b"\n")
    forged = [line for line in lines if line.startswith(b"FORGED") or line.startswith(b"2026-01-01 info")]
    arena.check(not forged, f"{len(forged)} forged lines in the log" + (f", for example {forged[0][:60]!r}" if forged else ""))
    control = sorted(set(re.findall(rb"[\x00-\x09\x0b-\x1f\x7f]|\xe2\x80[\xa8\xa9]|\xc2\x85", log)))
    arena.check(not control, f"control characters in the log: {control}" if control else "no control characters in the log")


@attack("log-long-names", seconds=8)
def log_long_names(arena):
    """2,000 Hellos whose world or ticket has 60,000 bytes. The server rejects them and truncates them in the log."""
    arena.fork(4, _send_long_names, arena.ports)
    log = arena.server_log()
    longest = max(map(len, log.split(b"\n")))
    arena.check(longest <= LINE_MAX, f"the longest line of the log has {longest:,} bytes; at most {LINE_MAX:,} are allowed")
    arena.check(len(log) <= LOG_MAX_MB * 1e6, f"the log has {len(log) / 1e6:.1f} MB; at most {LOG_MAX_MB} MB are allowed")


def _send_long_names(number, ports, count=500):
    for i in range(count):
        knock(ports, **{("world", "ticket")[i % 2]: "w" * 60000})


def _provoke_rejections(number, ports, seconds):
    until, done = time.monotonic() + seconds, 0
    while time.monotonic() < until:
        try:
            link = WebSocket(ports.http, timeout=1.0)
            link.send(messages.hello(world="nobody hosts a world with so long a name that it fills the log in little time"))
            done += 1
            link.receive(time.monotonic() + 1.0)
            link.close()
        except (OSError, Closed):
            time.sleep(0.01)
    return done


def fill_log(arena):
    done = arena.fork(6, _provoke_rejections, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done):,} rejections, one line of the log each")


@attack("log-unread", seconds=8, output="unread", log_level="debug")
def log_unread(arena):
    """Standard output and error are a pipe that nobody reads; clients fill it."""
    fill_log(arena)


@attack("log-closed", seconds=6, output="closed", log_level="debug")
def log_closed(arena):
    """Standard output and error are a pipe whose reader has closed: the next line raises SIGPIPE."""
    fill_log(arena)
