"""Players who do all that the rules allow, or stop reading, or meet a server that stood still: the play streams themselves."""

import os
import random
import signal
import time

from . import messages
from .arena import attack
from .http2 import call
from .net import Closed
from .player import TRANSPORTS, Crowd, GrpcStream, Player
from .protobuf import all_of, as_double, field, uint
from .server import DEFAULT_TARGET
from .websocket import WebSocket
from .worlds import world_info

SPEED_MAX = 50           # m/s that pushes may give a body, however many come (docs/operations.md)

# 3,000 balls that never come to rest, and hit the floor all the time.
BOUNCERS = {"name": "target", "world": {"sleeping": False}, "bodies": [DEFAULT_TARGET["bodies"][0], {
    "name": "ball", "position": {"x": -30, "y": 0.6, "z": -30}, "shapes": [{"sphere": {"radius": 0.3}, "restitution": 1}],
    "repeat": [{"count": 60, "offset": {"x": 1, "y": 0.01}}, {"count": 50, "offset": {"z": 1, "y": 0.013}}]}]}

ONE_BALL = {"name": "target", "bodies": [
    {"name": "ball", "gravity_scale": 0, "position": {"x": 0, "y": 5, "z": 0}, "shapes": [{"sphere": {"radius": 0.5}}]}]}


def run_clients(number, ports, seconds, count, act=None, every=0.1, hello={}):
    """One process of a crowd, half of it over each transport: (how many are still in, codes of results, ends, snapshots)."""
    crowd = Crowd().add(count, lambda i: Player(ports, TRANSPORTS[i % 2], **hello))
    crowd.play(seconds, act, every)
    codes = {}
    for player in crowd.players:
        for code, times in player.codes.items():
            codes[code] = codes.get(code, 0) + times
    snapshots = crowd.total(messages.SNAPSHOT)
    return len(crowd.players), codes, crowd.ends, snapshots


def storm(arena, count, act=None, every=0.1, processes=4, **hello):
    results = [each for each in arena.fork(processes, run_clients, arena.ports, arena.seconds, count // processes, act, every, hello) if each]
    codes, ends = {}, {}
    for _, some, reasons, _ in results:
        for into, these in ((codes, some), (ends, reasons)):
            for key, times in these.items():
                into[key] = into.get(key, 0) + times
    snapshots = sum(each[3] for each in results)
    arena.note(f"{sum(each[0] for each in results)} of {count} were in to the end, with {snapshots / arena.seconds / count:.0f} snapshots a second each; "
               f"inputs by code: {codes or 'none'}" + (f"; ends: {dict(sorted(ends.items(), key=lambda e: -e[1])[:3])}" if ends else ""))


def _push(player):
    player.act(*[messages.impulse(random.randrange(2, 102), (50, 300, 0)) for _ in range(30)])


@attack("inputs-at-the-limit", seconds=8)
def inputs_at_the_limit(arena):
    """100 players send 300 inputs a second each, in batches of 30."""
    storm(arena, 100, act=_push)


def _spawn(player):
    player.act(*[messages.spawn(messages.box(0.5, 0.5, 0.5), (30, 1, 30)) for _ in range(10)])


@attack("spawn-in-one-place", seconds=10)
def spawn_in_one_place(arena):
    """100 players each spawn all the bodies they may own, 50, in one place."""
    storm(arena, 100, act=_spawn, every=0.5)


def _tug(player):
    where = random.uniform(-20, 20)
    player.act(messages.grab(50, (where, 0.5, 0)), messages.drag((where, 5, -where)), messages.drag((-where, 50, where)),
               *([messages.release()] if random.random() < 0.3 else []))


@attack("grab-storm", seconds=8)
def grab_storm(arena):
    """100 players tear at one body with their grabs."""
    storm(arena, 100, act=_tug)


@attack("events-for-all", seconds=8, target=BOUNCERS)
def events_for_all(arena):
    """100 players want the events of 3,000 bouncing balls."""
    storm(arena, 100, events=True)


@attack("keyframes-for-all", seconds=8, target=BOUNCERS)
def keyframes_for_all(arena):
    """200 players ask for an absolute snapshot with every acknowledgement."""
    storm(arena, 200, keyframes=True)


def _many_cadences(number, ports, seconds, count):
    return run_clients(number, ports, seconds, count, hello={"snapshot_hz": 60 // (number + 1)})


@attack("cadences", seconds=8, target=BOUNCERS)
def cadences(arena):
    """120 players of 3,000 moving bodies at a dozen rates, so that few of them share an encoding."""
    results = arena.fork(12, _many_cadences, arena.ports, arena.seconds, 10)
    arena.note(f"{sum(each[0] for each in results if each)} of 120 were in to the end")


def _join_and_leave(number, ports, seconds):
    until, done = time.monotonic() + seconds, 0
    while time.monotonic() < until:
        try:
            player = Player(ports, TRANSPORTS[number % 2], name="here and gone")
            if done % 2:
                player.until(messages.WELCOME, 0.5)
                player.link.send(messages.leave())
            player.close()
            done += 1
        except (OSError, Closed):
            time.sleep(0.005)
    return done


@attack("come-and-go", seconds=8)
def join_and_leave(arena):
    """Eight processes join and leave in a loop, politely and not."""
    done = arena.fork(8, _join_and_leave, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done):,} joins")


# --- those who do not read ---

NON_READER_TIMEOUT = 4


@attack("non-readers", seconds=12, target=BOUNCERS, settings=f"[stream]\nsilence_seconds = {NON_READER_TIMEOUT}")
def non_readers(arena):
    """60 clients that never read: mute ones, ones that ping, ones that acknowledge blindly. All must be cut."""
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
        tick += 3  # 20 rounds a second of a world at 60 Hz
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
    arena.check(left == 0 and at <= limit, f"{60 - left} of 60 that never read were cut after {at:.1f} s; at most {limit} s are allowed")


@attack("sigstop", seconds=17, starves=True)
def sigstop(arena):
    """The server stands still for 12 s (SIGSTOP, as a paused machine does): that is not its clients' silence."""
    os.kill(arena.server_pid, signal.SIGSTOP)
    time.sleep(12)
    os.kill(arena.server_pid, signal.SIGCONT)
    time.sleep(4)


# --- what players may not achieve ---

def _shove(number, ports, seconds):
    """All the impulses that one client may send, along x; some aim at the edge, to make it spin."""
    player = Player(ports, TRANSPORTS[number % 2])
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        player.act(*[messages.impulse(1, (1e6, 0, 0)) for _ in range(10)])
        pause = time.monotonic() + 1 / 30
        while player.receive(pause) is not None:
            pass
    return player.codes.get(1, 0)


def _where(arena):
    """(tick, x of the ball) by its bounds."""
    answer = call(arena.ports.grpc, messages.DEBUG, messages.text(1, "target") + uint(4, 1))[2]
    bounds = all_of(answer, 4)
    if not bounds:
        return None
    low, high = (as_double(field(field(bounds[0], corner, b""), 1, 0)) for corner in (1, 2))
    return field(answer, 1, 0), (low + high) / 2


@attack("impulses", seconds=5, target=ONE_BALL)
def impulses(arena):
    """Three clients each push one ball 300 times a second: however many pushes, it gets no faster than 50 m/s."""
    # The clients push while this process measures.
    if (child := os.fork()) == 0:
        applied = arena.fork(3, _shove, arena.ports, arena.seconds)
        arena.note(f"{sum(each or 0 for each in applied):,} impulses were applied")
        os._exit(0)
    fastest, last, until = 0.0, None, time.monotonic() + arena.seconds
    while time.monotonic() < until:
        now = _where(arena)
        if now and last and now[0] > last[0]:
            fastest = max(fastest, abs(now[1] - last[1]) * 60 / (now[0] - last[0]))
        last = now or last
        time.sleep(0.1)
    os.waitpid(child, 0)
    arena.check(0 < fastest <= SPEED_MAX * 1.02, f"the ball moved at {fastest:,.0f} m/s")


@attack("close-reasons", seconds=4)
def close_reasons(arena):
    """Refusals that quote a name of many bytes a letter: the reason is cut to fit a close frame, and must stay whole UTF-8."""
    for letter in ("ä", "€", "𝄞"):
        for shift in range(4):
            try:
                link = WebSocket(arena.ports.http)
                link.send(messages.hello(world="x" * shift + letter * 80))
                while link.receive(time.monotonic() + 2) is not None:
                    pass
                arena.check(False, f"{letter} {shift}: not refused within 2 s")
            except Closed as closed:
                try:
                    closed.reason.decode()
                except UnicodeDecodeError:
                    arena.check(False, f"{letter} after {shift} letters: the reason ends in half a letter: {closed.reason[-6:]!r}")
