"""Attacks on play streams: players that use every limit, players that stop reading, and a server that was suspended."""

import os
import random
import signal
import time

from . import messages
from .arena import attack
from .http2 import call
from .net import Closed
from .player import TRANSPORTS, ClientPool, GrpcStream, Player
from .protobuf import all_of, as_double, field, uint
from .server import DEFAULT_TARGET
from .websocket import WebSocket
from .worlds import world_info

SPEED_MAX = 50  # m/s, the largest speed that impulses give a body (docs/guides/operator/size.md)

# 3,000 balls that never come to rest and continuously hit the floor.
BOUNCERS = {"name": "target", "world": {"sleeping": False}, "bodies": [DEFAULT_TARGET["bodies"][0], {
    "name": "ball", "position": {"x": -30, "y": 0.6, "z": -30}, "shapes": [{"sphere": {"radius": 0.3}, "restitution": 1}],
    "repeat": [{"count": 60, "offset": {"x": 1, "y": 0.01}}, {"count": 50, "offset": {"z": 1, "y": 0.013}}]}]}

ONE_BALL = {"name": "target", "bodies": [
    {"name": "ball", "gravity_scale": 0, "position": {"x": 0, "y": 5, "z": 0}, "shapes": [{"sphere": {"radius": 0.5}}]}]}


def run_clients(number, ports, seconds, count, act=None, every=0.1, hello={}):
    """One process of a client pool, half of it per transport. Return (players still connected, result codes, ends, snapshots)."""
    pool = ClientPool().add(count, lambda i: Player(ports, TRANSPORTS[i % 2], **hello))
    pool.play(seconds, act, every)
    codes = {}
    for player in pool.players:
        for code, times in player.codes.items():
            codes[code] = codes.get(code, 0) + times
    snapshots = pool.total(messages.SNAPSHOT)
    return len(pool.players), codes, pool.ends, snapshots


def storm(arena, count, act=None, every=0.1, processes=4, **hello):
    results = [each for each in arena.fork(processes, run_clients, arena.ports, arena.seconds, count // processes, act, every, hello) if each]
    codes, ends = {}, {}
    for _, some, reasons, _ in results:
        for into, these in ((codes, some), (ends, reasons)):
            for key, times in these.items():
                into[key] = into.get(key, 0) + times
    snapshots = sum(each[3] for each in results)
    arena.note(f"{sum(each[0] for each in results)} of {count} players stayed connected, with {snapshots / arena.seconds / count:.0f} snapshots per second each; "
               f"inputs by code: {codes or 'none'}" + (f"; ends: {dict(sorted(ends.items(), key=lambda e: -e[1])[:3])}" if ends else ""))


def _push(player):
    player.act(*[messages.impulse(random.randrange(2, 102), (50, 300, 0)) for _ in range(30)])


@attack("inputs-at-the-limit", seconds=8)
def inputs_at_the_limit(arena):
    """100 players send 300 inputs per second each, in batches of 30."""
    storm(arena, 100, act=_push)


def _spawn(player):
    player.act(*[messages.spawn(messages.box(0.5, 0.5, 0.5), (30, 1, 30)) for _ in range(10)])


@attack("spawn-overlapping", seconds=10)
def spawn_overlapping(arena):
    """100 players each spawn all the bodies that they may own, 50, at one position."""
    storm(arena, 100, act=_spawn, every=0.5)


def _tug(player):
    where = random.uniform(-20, 20)
    player.act(messages.grab(50, (where, 0.5, 0)), messages.drag((where, 5, -where)), messages.drag((-where, 50, where)),
               *([messages.release()] if random.random() < 0.3 else []))


@attack("grab-storm", seconds=8)
def grab_storm(arena):
    """100 players grab and drag the same body."""
    storm(arena, 100, act=_tug)


@attack("events-for-all", seconds=8, target=BOUNCERS)
def events_for_all(arena):
    """100 players subscribe to the events of 3,000 bouncing balls."""
    storm(arena, 100, events=True)


@attack("keyframes-for-all", seconds=8, target=BOUNCERS)
def keyframes_for_all(arena):
    """200 players request a keyframe with every acknowledgement."""
    storm(arena, 200, keyframes=True)


def _client_rate_group(number, ports, seconds, count):
    return run_clients(number, ports, seconds, count, hello={"snapshot_hz": 60 // (number + 1)})


@attack("snapshot-rates", seconds=8, target=BOUNCERS)
def snapshot_rates(arena):
    """120 players of 3,000 moving bodies at 12 snapshot rates, so that few of them share an encoded snapshot."""
    results = arena.fork(12, _client_rate_group, arena.ports, arena.seconds, 10)
    arena.note(f"{sum(each[0] for each in results if each)} of 120 players stayed connected")


def _join_and_leave(number, ports, seconds):
    until, done = time.monotonic() + seconds, 0
    while time.monotonic() < until:
        try:
            player = Player(ports, TRANSPORTS[number % 2], name="brief visitor")
            if done % 2:
                player.until(messages.WELCOME, 0.5)
                player.link.send(messages.leave())
            player.close()
            done += 1
        except (OSError, Closed):
            time.sleep(0.005)
    return done


@attack("join-and-leave", seconds=8)
def join_and_leave(arena):
    """Eight processes join and leave in a loop, half of the time without a Leave message."""
    done = arena.fork(8, _join_and_leave, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done):,} joins")


# --- clients that do not read ---

NON_READER_TIMEOUT = 4


@attack("non-readers", seconds=12, target=BOUNCERS, settings=f"[stream]\nclient_timeout_seconds = {NON_READER_TIMEOUT}")
def non_readers(arena):
    """60 clients that never read: silent ones, ones that send pings, and ones that acknowledge blindly. The server must disconnect all."""
    def link(i):
        if i % 2:
            return GrpcStream(arena.ports.grpc, window=65535, receive_buffer=4096)
        return WebSocket(arena.ports.http, receive_buffer=4096)

    links = [link(i) for i in range(60)]
    for each in links:
        each.send(messages.hello("target"))
    time.sleep(0.5)
    tick = field(world_info(arena.ports, "target"), 8, 0)
    began, at, left = time.monotonic(), 0.0, -1
    limit = NON_READER_TIMEOUT + 2
    while left != 0 and at < limit + 3:
        tick += 3  # 20 rounds per second in a world at 60 Hz
        for i, each in enumerate(links):
            try:
                if i % 3 == 1:
                    each.send(messages.ping())
                elif i % 3 == 2:
                    for frame in range(tick - 6, tick + 1):
                        each.send(messages.ack(frame))
            except (OSError, Closed):
                pass
        left = field(world_info(arena.ports, "target"), 7, 0)
        at = time.monotonic() - began
        time.sleep(0.05)
    arena.check(left == 0 and at <= limit, f"{60 - left} of 60 clients that never read were disconnected after {at:.1f} s; at most {limit} s are allowed")


@attack("sigstop", seconds=17, starves=True)
def sigstop(arena):
    """The server is suspended for 12 s (SIGSTOP, like a paused machine). It must not disconnect its clients for this."""
    os.kill(arena.server_pid, signal.SIGSTOP)
    time.sleep(12)
    os.kill(arena.server_pid, signal.SIGCONT)
    time.sleep(4)


# --- limits that players must not exceed ---

def _shove(number, ports, seconds):
    """Send as many impulses along x as one client may send. Return the number of applied inputs."""
    player = Player(ports, TRANSPORTS[number % 2])
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        player.act(*[messages.impulse(1, (1e6, 0, 0)) for _ in range(10)])
        pause = time.monotonic() + 1 / 30
        while player.receive(pause) is not None:
            pass
    return player.codes.get(1, 0)


def _ball_position(arena):
    """(tick, x of the ball), from its bounding box."""
    response = call(arena.ports.grpc, messages.DEBUG, messages.text(1, "target") + uint(4, 1))[2]
    bounds = all_of(response, 4)
    if not bounds:
        return None
    low, high = (as_double(field(field(bounds[0], corner, b""), 1, 0)) for corner in (1, 2))
    return field(response, 1, 0), (low + high) / 2


@attack("impulses", seconds=5, target=ONE_BALL)
def impulses(arena):
    """Three clients each push one ball 300 times per second. Its speed must not exceed 50 m/s."""
    # The clients send impulses while this process measures.
    if (child := os.fork()) == 0:
        applied = arena.fork(3, _shove, arena.ports, arena.seconds)
        arena.note(f"{sum(each or 0 for each in applied):,} impulses were applied")
        os._exit(0)
    fastest, last, until = 0.0, None, time.monotonic() + arena.seconds
    while time.monotonic() < until:
        now = _ball_position(arena)
        if now and last and now[0] > last[0]:
            fastest = max(fastest, abs(now[1] - last[1]) * 60 / (now[0] - last[0]))
        last = now or last
        time.sleep(0.1)
    os.waitpid(child, 0)
    arena.check(0 < fastest <= SPEED_MAX * 1.02, f"the ball reached {fastest:,.0f} m/s; at most {SPEED_MAX} m/s are allowed")


@attack("close-reasons", seconds=4)
def close_reasons(arena):
    """Rejections that quote a name with multi-byte letters. The truncated reason in the close frame must be valid UTF-8."""
    for letter in ("ä", "€", "𝄞"):
        for shift in range(4):
            try:
                link = WebSocket(arena.ports.http)
                link.send(messages.hello(world="x" * shift + letter * 80))
                while link.receive(time.monotonic() + 2) is not None:
                    pass
                arena.check(False, f"{letter} after {shift} letters: the server did not reject the world name within 2 s")
            except Closed as closed:
                try:
                    closed.reason.decode()
                except UnicodeDecodeError:
                    arena.check(False, f"{letter} after {shift} letters: the reason ends within a letter: {closed.reason[-6:]!r}")
