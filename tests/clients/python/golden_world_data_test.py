#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Applies proto/golden/world_data.jdat with the Python client, which must know what proto/WIRE.md lists. Exit status 77: a package is
missing."""

import pathlib
import struct
import sys

try:
    import google.protobuf  # noqa: F401
    import grpc  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; install python3-grpcio")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "examples/python_client"))

import stubs  # noqa: E402,F401  generates jostle.v1
from jostle.v1 import play_pb2  # noqa: E402

from world_data import WorldData  # noqa: E402


def snapshots(data):
    magic, version, count = struct.unpack_from("<4sII", data)
    assert (magic, version) == (b"JDAT", 1)
    at = 12
    for _ in range(count):
        size, = struct.unpack_from("<I", data, at)
        yield play_pb2.Snapshot.FromString(data[at + 4:at + 4 + size])
        at += 4 + size
    assert at == len(data)


def main():
    world = WorldData()
    for snapshot in snapshots((ROOT / "proto/golden/world_data.jdat").read_bytes()):
        world.apply(snapshot)
    players = [(p.client, p.name, play_pb2.PlayerRole.Name(p.role), p.ping_ms) for _, p in sorted(world.players.items())]
    attributes = {(target, key): getattr(a, a.WhichOneof("value")) for target, keys in world.attributes.items() for key, a in keys.items()}
    gravity = attributes.pop((("world", 0), "gravity"))
    checks = [
        (players, [(3, "Zoë", "PLAYER_ROLE_BUILDER", 26), (4, "rob", "PLAYER_ROLE_OWNER", 140)]),
        ((gravity.x, gravity.y, gravity.z), (0, -9.81, 0)),
        (attributes, {(("world", 0), "round"): 3, (("player", 3), "secret"): "open"}),
        ([(m.number, m.data, m.direct) for m in world.messages], [(1, b"hi", False), (3, b"\x00\xff", True)]),
        (world.messages_missed, 2),
    ]
    faults = [f"{found} instead of {expected}" for found, expected in checks if found != expected]
    print("\n".join(faults) or "as expected")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
