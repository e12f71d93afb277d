"""gRPC calls and streams: many at once, expensive calls, calls that never finish, and messages that expand when decoded."""

import collections
import math
import time
import zlib

from . import messages
from .arena import attack
from .http2 import Connection, call, grpc_message
from .net import ATTACKER, PROBE, Closed
from .player import TRANSPORTS, Player
from .protobuf import field, nested, uint
from .server import DEFAULT_TARGET, grpc_answers, new_player_joins

# 10,000 boxes at rest: a Debug response about them has about 3 MB.
MANY_BOXES = {"name": "target", "bodies": [DEFAULT_TARGET["bodies"][0], {
    "name": "box", "position": {"x": -100, "y": 0.5, "z": -100}, "shapes": [{"box": {"half_extents": {"x": 0.5, "y": 0.5, "z": 0.5}}}],
    "repeat": [{"count": 100, "offset": {"x": 2}}, {"count": 100, "offset": {"z": 2}}]}]}


def call_repeatedly(number, ports, seconds, path, request, connections=1, at_once=100):
    """Keep `at_once` calls in flight for `seconds`; count them by status. `number`: index of this process."""
    ends, until = collections.Counter(), time.monotonic() + seconds
    open_connections = []
    while time.monotonic() < until:
        try:
            if len(open_connections) < connections:
                open_connections.append(Connection(ports.grpc, timeout=2.0))
            for connection in open_connections:
                for stream_number, stream in list(connection.streams.items()):
                    if stream.ended is not None:
                        ends[f"{stream.status} {stream.headers.get('grpc-message', '')[:60]}".strip()] += 1
                        del connection.streams[stream_number]
                while len(connection.streams) < at_once:
                    stream_number = connection.open(path, keep=False)
                    connection.send_data(stream_number, grpc_message(request), end=True, patience=0.5)
                connection.pump(time.monotonic() + 0.05)
        except (OSError, Closed) as ended:
            ends[f"connection: {ended}"[:60]] += 1
            for connection in open_connections:
                connection.close()
            open_connections = []
            time.sleep(0.05)
    ends["no response"] += sum(len(connection.streams) for connection in open_connections)
    return ends


def flood(arena, processes, path, request, connections=1, at_once=100):
    ends = collections.Counter()
    for each in arena.fork(processes, call_repeatedly, arena.ports, arena.seconds, path, request, connections, at_once):
        ends.update(each or {"process failed": 1})
    arena.note("statuses: " + ", ".join(f"{status}: {count:,}" for status, count in ends.most_common(6)))


@attack("debug-2000", seconds=8, target=MANY_BOXES)
def debug_calls(arena):
    """2,000 concurrent Debug calls about 10,000 boxes, repeatedly."""
    everything = b"".join(uint(number, 1) for number in range(2, 7))
    flood(arena, 4, messages.DEBUG, messages.text(1, "target") + everything, connections=5)


def ball_of_points(count):
    """Points of a spiral on a sphere. All are vertices of their hull."""
    golden = math.pi * (3 - math.sqrt(5))
    points = []
    for i in range(count):
        y = 1 - 2 * (i + 0.5) / count
        r = math.sqrt(1 - y * y)
        points.append((r * math.cos(golden * i), y, r * math.sin(golden * i)))
    return points


@attack("hull-casts", seconds=8, target=MANY_BOXES)
def hull_casts(arena):
    """20 clients each cast 100 hulls of 1,000 points through 10,000 boxes in a loop."""
    # a hull may have 252 vertices
    points = ball_of_points(250) + [tuple(0.9 * x for x in point) for point in ball_of_points(750)]
    moving = nested(1, messages.hull(points) + nested(5, messages.vector(-100, 1, -90))) + nested(2, messages.vector(200, 0, 180))
    flood(arena, 20, messages.CAST_SHAPES, messages.text(1, "target") + nested(2, moving) * 100 + uint(3, 3), at_once=1)


@attack("list-flood", seconds=8)
def list_flood(arena):
    """Eight connections with 100 ListWorlds calls in flight each."""
    flood(arena, 8, messages.LIST_WORLDS, b"")


@attack("join-world-flood", seconds=10)
def join_world_flood(arena):
    """At least 13,000 JoinWorld calls. A ticket that another client obtained earlier must remain valid."""
    ticket = field(call(arena.ports.grpc, messages.JOIN_WORLD, messages.text(1, "sandbox"), source=PROBE)[2], 4, b"").decode()
    flood(arena, 4, messages.JOIN_WORLD, messages.text(1, "sandbox"))
    try:
        player = Player(arena.ports, "websocket", PROBE, "sandbox", ticket=ticket)
        arena.check(player.until(messages.SNAPSHOT, 3), f"the ticket from before the flood: {player.notice or 'valid'}")
    except (OSError, Closed) as ended:
        arena.check(False, f"the ticket from before the flood: {ended}")


# --- messages that never end ---

def _send_unfinished(number, ports, seconds, path, streams, size, declared, pause):
    """Open the streams of one connection and send `size` bytes on each, of a message whose header declares `declared` bytes."""
    until = time.monotonic() + seconds
    connection = Connection(ports.grpc)
    piece, sent = bytes(65536), {}
    for _ in range(streams):
        stream_number = connection.open(path)
        sent[stream_number] = connection.send_data(stream_number, grpc_message(b"", declared=declared), patience=0.5)
    while time.monotonic() < until and len(connection.streams):
        for stream_number in list(connection.streams):
            if connection.streams[stream_number].ended is not None:
                del connection.streams[stream_number]
            elif sent[stream_number] < size:
                part = piece[:size - sent[stream_number]]
                sent[stream_number] += connection.send_data(stream_number, part, patience=0.05)
        connection.pump(time.monotonic() + pause)
    time.sleep(max(0.0, until - time.monotonic()))
    return sum(sent.values())


def unfinished(arena, path, processes, streams, size, declared, pause=0.002):
    taken = arena.fork(processes, _send_unfinished, arena.ports, arena.seconds, path, streams, size, declared, pause)
    arena.note(f"{sum(each or 0 for each in taken) / 1e6:,.0f} MB sent; the server cut {taken.count(None)} of {processes} connections")


FOUR_MIB = 4 << 20


@attack("unfinished-play", seconds=10)
def unfinished_play(arena):
    """300 messages of 4 MiB on Play streams, each one byte short."""
    unfinished(arena, messages.PLAY, 10, 30, FOUR_MIB - 1, FOUR_MIB)


@attack("unfinished-create", seconds=10)
def unfinished_create(arena):
    """300 messages of 4 MiB to CreateWorld, each one byte short."""
    unfinished(arena, messages.CREATE_WORLD, 10, 30, FOUR_MIB - 1, FOUR_MIB)


@attack("unfinished-2gb", seconds=8)
def unfinished_huge(arena):
    """Messages that declare 2 GB, sent as fast as the server reads."""
    unfinished(arena, messages.CREATE_WORLD, 4, 5, 512 << 20, 2**31 - 1)
    unfinished(arena, messages.PLAY, 4, 5, 512 << 20, 2**31 - 1)


@attack("unfinished-slow", seconds=10)
def unfinished_slow(arena):
    """1,000 calls that send 64 KiB every two seconds and never finish."""
    unfinished(arena, messages.CREATE_WORLD, 10, 100, FOUR_MIB - 1, FOUR_MIB, pause=2)


def bomb():
    """2.6 GB of zeros as 2.6 MB of gzip. A block that ends at a byte boundary and has no back references can be repeated."""
    packer = zlib.compressobj(9, zlib.DEFLATED, 31)
    head = packer.compress(b"") + packer.flush(zlib.Z_FULL_FLUSH)
    block = packer.compress(bytes(64 << 20)) + packer.flush(zlib.Z_FULL_FLUSH)
    return head + block * 40


def _drop_bombs(number, ports, seconds, payload, path):
    ends = collections.Counter()
    connection = Connection(ports.grpc)
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        stream_number = connection.open(path, grpc_encoding="gzip")
        connection.send_data(stream_number, grpc_message(payload, compressed=1), end=True)
        while connection.streams[stream_number].ended is None and connection.pump(until):
            pass
        ends[connection.streams[stream_number].status] += 1
    return ends


@attack("gzip-bomb", seconds=6)
def gzip_bomb(arena):
    """Messages of 2.6 MB that decompress to 2.6 GB, sent to CreateWorld and on Play."""
    payload, ends = bomb(), collections.Counter()
    for path in (messages.CREATE_WORLD, messages.PLAY):
        for each in arena.fork(2, _drop_bombs, arena.ports, arena.seconds / 2, payload, path):
            ends.update(each or {"cut": 1})
    arena.note(f"statuses: {dict(ends)}")


# --- streams that hold a thread or a session ---

def hold_streams(arena, path, first, connections=10, streams=100):
    held = []
    for _ in range(connections):
        try:
            connection = Connection(arena.ports.grpc)
            held.append(connection)
            for _ in range(streams):
                stream_number = connection.open(path, keep=False)
                if first is not None:
                    connection.send_data(stream_number, grpc_message(first), patience=0.2)
        except (OSError, Closed):
            pass
    until = time.monotonic() + 3
    for connection in held:
        try:
            while connection.pump(min(until, time.monotonic() + 0.1)):
                pass
        except (OSError, Closed):
            pass
    for probe in (grpc_answers, new_player_joins):
        holds, what = probe(arena.ports)
        arena.check(holds, f"while the streams are open: {what}")
    ended = collections.Counter(stream.status for connection in held for stream in connection.streams.values())
    arena.note(f"of {connections * streams} streams: " + ", ".join(f"{'open' if status is None else status}: {count}" for status, count in ended.items()))


@attack("reflection-streams", seconds=10)
def reflection_streams(arena):
    """1,000 reflection streams that send no request and stay open."""
    hold_streams(arena, messages.REFLECTION, None)


@attack("health-watches", seconds=10)
def health_watches(arena):
    """1,000 health watch streams."""
    hold_streams(arena, messages.HEALTH_WATCH, b"")


@attack("play-without-hello", seconds=10)
def play_without_hello(arena):
    """2,000 Play streams without a Hello. Players that send one must still be able to join."""
    hold_streams(arena, messages.PLAY, None, connections=20)


def _fill(ports, transport, count):
    """Connect `count` players; return those that connected. They send nothing after Hello; this takes less time than the timeout."""
    players = []
    for i in range(count):
        try:
            players.append(Player(ports, transport, ATTACKER, snapshot_hz=1, spectator=True))
        except (OSError, Closed):
            pass
    return players


@attack("fill-the-server", seconds=10)
def fill_the_server(arena):
    """1,100 players from one address. Players from other addresses must still be able to join."""
    players = _fill(arena.ports, TRANSPORTS[0], 550) + _fill(arena.ports, TRANSPORTS[1], 550)
    holds, what = new_player_joins(arena.ports)
    arena.check(holds, f"with {len(players)} players from one address: {what}")
