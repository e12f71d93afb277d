"""Scenes that are cheap to send but expensive to store, to replicate or to step, and many worlds."""

import time

from . import messages
from .arena import attack
from .http2 import Connection, call
from .messages import body, box, create_world, floor, scene, sphere
from .net import Closed
from .player import TRANSPORTS, Player
from .protobuf import field
from .server import DEFAULT_TARGET

STOCK_MESSAGE_MAX = 4 << 20  # default limit of a gRPC client for one message, bytes
OK, INVALID_ARGUMENT, RESOURCE_EXHAUSTED = 0, 3, 8
REFUSALS = (INVALID_ARGUMENT, RESOURCE_EXHAUSTED)


def create(arena, name, scene_bytes, timeout=8.0):
    """Create a world. Return whether it exists; a rejection is a valid response."""
    began = time.monotonic()
    status, why, _ = call(arena.ports.grpc, messages.CREATE_WORLD, create_world(name, scene_bytes), timeout)
    what = f"CreateWorld of {len(scene_bytes):,} bytes: {'created' if status == OK else f'{status} {why[:100]}'} in {time.monotonic() - began:.1f} s"
    arena.check(status == OK or status in REFUSALS, what)
    return status == OK


def world_info(ports, world, timeout=3.0):
    """The bytes of WorldInfo, empty without a response."""
    return field(call(ports.grpc, messages.GET_WORLD, messages.text(1, world), timeout)[2], 1, b"")


def join(arena, world, seconds=6.0):
    """Players of both transports join and receive all entities in messages below the default limit of gRPC clients."""
    for transport in TRANSPORTS:
        try:
            player = Player(arena.ports, transport, world=world)
            joined = player.until(messages.SNAPSHOT, seconds)
            arena.check(joined and player.largest <= STOCK_MESSAGE_MAX,
                        f"joining the world ({transport}): {'a snapshot' if joined else 'no snapshot'}, {player.bytes:,} bytes in total, {player.largest:,} in the largest message")
            player.close()
        except (OSError, Closed) as ended:
            arena.check(False, f"joining the world ({transport}): {type(ended).__name__} {ended}")


@attack("calm", seconds=5)
def calm(arena):
    """No attack. Shows what this machine achieves under its present load."""
    time.sleep(arena.seconds)


@attack("mesh-copies", seconds=15)
def mesh_copies(arena):
    """CreateWorld with one mesh of 1.9 MB and 2,000 copies of its body. Then players join."""
    one = body(messages.grid_mesh(205), "rock", messages.STATIC, repeat=[(2000, (25, 0, 0))])
    if create(arena, "copies", scene([one])):
        join(arena, "copies")


@attack("mesh-twice", seconds=12)
def mesh_twice(arena):
    """Two bodies with a mesh of 3.3 MB. Two copies exceed the default message limit of gRPC clients."""
    one = body(messages.grid_mesh(270), "rock", messages.STATIC, repeat=[(2, (30, 0, 0))])
    if create(arena, "twice", scene([one])):
        join(arena, "twice")


# --- scenes that block the thread of their world ---

def stuck_world(arena, name, scene_bytes):
    """Create the world and fill its queue from players of both transports, which then leave with and without a Leave message."""
    if not create(arena, name, scene_bytes):
        return False
    players = []
    for i in range(40):
        try:
            players.append(Player(arena.ports, TRANSPORTS[i % 2], world=name, name="leaver"))
        except (OSError, Closed):
            pass
    for _ in range(5):  # 300 inputs per second each: more than the queue of a stalled world holds
        for player in players:
            try:
                player.act(*[messages.impulse(1, (1, 0, 0))] * 60)
            except (OSError, Closed):
                pass
    for i, player in enumerate(players):
        try:
            if i % 4 < 2:
                player.link.send(messages.leave())
            else:
                player.close()
        except OSError:
            pass
    time.sleep(4)
    info = world_info(arena.ports, name)
    arena.note(f"the world is at tick {field(info, 8, 0)} with {field(info, 7, 0)} clients after 4 s; paused: {field(info, 10, b'').decode() or 'no'}")
    return True


@attack("overlap-900", seconds=10)
def overlap_900(arena):
    """A scene of 63 bytes: 900 boxes at one position, 64 sub-steps. 40 players join, fill the queue and leave. Then SIGTERM."""
    stuck_world(arena, "t", scene([body(box(1, 1, 1), repeat=[(900, (0, 0, 0))])], substeps=64))


@attack("overlap-900-deleted", seconds=10)
def overlap_900_deleted(arena):
    """The same; then a client deletes the stalled world. The server must respond."""
    if stuck_world(arena, "t", scene([body(box(1, 1, 1), repeat=[(900, (0, 0, 0))])], substeps=64)):
        began = time.monotonic()
        status, why, _ = call(arena.ports.grpc, messages.DELETE_WORLD, messages.text(1, "t"), timeout=4)
        arena.check(status == OK, f"DeleteWorld of the stalled world: {status} {why} in {time.monotonic() - began:.1f} s")


@attack("overlap-20000", seconds=12)
def overlap_20000(arena):
    """20,000 boxes at one position: 200 million pairs from 63 bytes."""
    stuck_world(arena, "t", scene([body(box(1, 1, 1), repeat=[(20000, (0, 0, 0))])]))


@attack("implosion", seconds=12)
def implosion(arena):
    """10,000 balls that do not touch at the start and all reach the origin one second later."""
    def towards_origin(i):
        position = ((i % 100 - 50) * 2.0, (i // 100 - 50) * 2.0, 60.0)
        return body(sphere(0.4), position=position, velocity=tuple(-x for x in position), gravity_scale=0)
    stuck_world(arena, "t", scene([towards_origin(i) for i in range(10000)], substeps=64))


@attack("joints-60000", seconds=12)
def many_joints(arena):
    """60,000 ball joints between the same two bodies."""
    bodies = [body(box(0.5, 0.5, 0.5), "a"), body(box(0.5, 0.5, 0.5), "b", position=(2, 0, 0))]
    stuck_world(arena, "t", scene(bodies, joints=[messages.ball_joint("a", "b")] * 60000))


@attack("joints-hub", seconds=12)
def joints_hub(arena):
    """A hub with 5,000 spokes on joints that select the direct solver."""
    spokes = body(sphere(0.1), "spoke", position=(2, 0, 0), repeat=[(5000, (0.3, 0, 0))])
    joints = [messages.ball_joint("hub", f"spoke[{i}]", direct=True) for i in range(5000)]
    stuck_world(arena, "t", scene([body(box(0.5, 0.5, 0.5), "hub"), spokes], joints=joints))


@attack("triangle-soup", seconds=12)
def triangle_soup(arena):
    """40,000 triangles within 1 m and 1,500 boxes that contain all of them and ignore each other: few pairs, 60 million contacts."""
    vertices = [((i * 7919 % 1000) / 1000, (i * 104729 % 1009) / 1000, (i * 1299709 % 1013) / 1000) for i in range(40000)]
    soup = messages.mesh(vertices, [index for i in range(39998) for index in (i, i + 1, i + 2)])
    boxes = body(box(2, 2, 2) + messages.no_self_collision(), repeat=[(1500, (0, 0.0001, 0))])
    stuck_world(arena, "t", scene([body(soup, kind=messages.STATIC), boxes]))


@attack("compounds", seconds=12)
def compounds(arena):
    """Two bodies of 30,000 boxes each, all at one position: one pair, 900 million pairs of child shapes."""
    parts = messages.compound([box(0.5, 0.5, 0.5)] * 30000)
    stuck_world(arena, "t", scene([body(parts, repeat=[(2, (0.1, 0, 0))])]))


@attack("hz-1000", seconds=12)
def fast_world(arena):
    """5,000 boxes in stacks at 1,000 steps per second with 64 sub-steps each."""
    heap = body(box(0.5, 0.5, 0.5), position=(0, 0.6, 0), repeat=[(20, (0, 1.1, 0)), (250, (1.3, 0, 0))])
    stuck_world(arena, "t", scene([floor(), heap], substeps=64, hz=1000))


# --- many worlds ---

def create_many(arena, scene_bytes, count=62, seconds=12):
    created, why, until = 0, "", time.monotonic() + seconds
    for i in range(count):
        if time.monotonic() > until:
            break
        status, why, _ = call(arena.ports.grpc, messages.CREATE_WORLD, create_world(f"many{i}", scene_bytes), timeout=6)
        if status != OK:
            arena.check(status in REFUSALS, f"CreateWorld number {i + 1}: {status} {why[:120]}")
            break
        created += 1
    arena.note(f"{created} worlds were created; the server uses {arena.server_rss_mb():.0f} MB")


@attack("worlds-asleep", seconds=15)
def worlds_asleep(arena):
    """The maximum number of worlds with 19,600 boxes at rest each: memory."""
    boxes = body(box(0.5, 0.5, 0.5), position=(-140, 0.5, -140), repeat=[(140, (2, 0, 0)), (140, (0, 0, 2))])
    create_many(arena, scene([floor(), boxes]))
    time.sleep(2)


@attack("worlds-awake", seconds=15)
def worlds_awake(arena):
    """The maximum number of worlds with 1,500 balls each that never come to rest: CPU time."""
    balls = body(sphere(0.3) + messages.double(9, 1.0), position=(0, 2, 0), repeat=[(15, (0.9, 0.1, 0)), (100, (0, 0.05, 0.9))])
    create_many(arena, scene([floor(), balls]), seconds=5)
    time.sleep(6)


def _churn(number, ports, seconds):
    until, done = time.monotonic() + seconds, 0
    heavy = scene([floor(), body(box(0.5, 0.5, 0.5), position=(0, 0.5, 0), repeat=[(50, (2, 0, 0)), (50, (0, 0, 2))])])
    connection = Connection(ports.grpc)
    while time.monotonic() < until:
        name = f"churn{number}_{done}"
        connection.call(messages.CREATE_WORLD, create_world(name, heavy))
        connection.call(messages.DELETE_WORLD, messages.text(1, name))
        done += 1
    return done


@attack("world-churn", seconds=8)
def world_churn(arena):
    """Eight clients create and delete worlds of 2,500 boxes as fast as possible."""
    done = arena.fork(8, _churn, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done)} worlds created and deleted")


def _build_hulls(number, ports, seconds):
    points = [(((i * 7919) % 2003) / 1000 - 1, ((i * 104729) % 2011) / 1000 - 1, ((i * 1299709) % 2017) / 1000 - 1) for i in range(100000)]
    heavy, until, done = scene([body(messages.hull(points))]), time.monotonic() + seconds, 0
    while time.monotonic() < until:
        call(ports.grpc, messages.CREATE_WORLD, create_world(f"hull{number}_{done}", heavy), timeout=6)
        call(ports.grpc, messages.DELETE_WORLD, messages.text(1, f"hull{number}_{done}"), timeout=6)
        done += 1
    return done


@attack("heavy-builds", seconds=10)
def heavy_builds(arena):
    """Twelve clients each create worlds with a hull of 100,000 points (2.9 MB) in a loop."""
    done = arena.fork(12, _build_hulls, arena.ports, arena.seconds)
    arena.note(f"{sum(each or 0 for each in done)} worlds created")


# --- a world of sleeping bodies ---

SLEEPERS = {"name": "target", "bodies": [DEFAULT_TARGET["bodies"][0], {
    "name": "box", "position": {"x": -140, "y": 0.5, "z": -140}, "shapes": [{"box": {"half_extents": {"x": 0.5, "y": 0.5, "z": 0.5}}}],
    "repeat": [{"count": 140, "offset": {"x": 2}}, {"count": 140, "offset": {"z": 2}}]}]}


def _explode(number, ports, seconds):
    player = Player(ports, TRANSPORTS[number % 2], snapshot_hz=10)
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        player.act(*[messages.explode((3000, 3000, 3000), 0.1, 1)] * 10)
        pause = time.monotonic() + 1 / 30
        while player.receive(pause) is not None:
            pass
    return player.codes.get(1, 0)


@attack("explosions", seconds=8, target=SLEEPERS)
def explosions(arena):
    """19,600 sleeping boxes. Ten clients each trigger 300 explosions per second in empty space."""
    rest = time.monotonic() + 15
    while time.monotonic() < rest and field(world_info(arena.ports, "target"), 6, 0) > 0:
        time.sleep(0.2)
    arena.begin()
    start_tick, began = field(world_info(arena.ports, "target"), 8, 0), time.monotonic()
    applied = sum(each or 0 for each in arena.fork(10, _explode, arena.ports, arena.seconds))
    info = world_info(arena.ports, "target")
    ticks = (field(info, 8, start_tick) - start_tick) / (time.monotonic() - began)
    arena.check(ticks >= 55, f"the world of sleeping bodies ran at {ticks:.0f} ticks per second under {applied:,} explosions; at least 55 are required" if info
                else f"GetWorld of the world of sleeping bodies failed after {applied:,} explosions")
