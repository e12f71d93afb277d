# SPDX-License-Identifier: MIT
"""The client of the golden conversation: what it sends, and what it knows at the end, as JSON."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "examples/python_client"))

import stubs  # noqa: E402,F401  generates jostle.v1
from jostle.v1 import common_pb2, play_pb2, scene_pb2  # noqa: E402

from world_client import WorldClient  # noqa: E402

CONVERSATION = ROOT / "proto/golden/conversation.jcnv"
EXPECTED = ROOT / "proto/golden/conversation.json"
SNAPSHOTS = 20


def new_client():
    return WorldClient("golden", events=True)


def sphere(radius):
    shape = scene_pb2.Shape(sphere=scene_pb2.Sphere(radius=radius))
    return play_pb2.Input(spawn=play_pb2.SpawnInput(shape=shape, position=common_pb2.Vec3(x=0.25, y=4, z=-0.5)))


def after_snapshot(client, number):
    """The inputs of the conversation: after the fifth snapshot one that is applied and two that are rejected."""
    if number == 5:
        client.send_input(sphere(0.3))
        client.send_input(sphere(3))  # larger than allowed
        client.send_input(play_pb2.Input(impulse=play_pb2.ImpulseInput(entity=4000000)))
    if number == SNAPSHOTS:
        client.leave()


class Observation:
    """The knowledge of a correct client, message by message."""

    def __init__(self):
        self.snapshots = []

    def after(self, client, message):
        if message.WhichOneof("message") != "snapshot":
            return
        snapshot = message.snapshot
        self.snapshots.append({
            "frame": snapshot.frame, "due_on_server_us": client.due_us(snapshot) + client.offset_us,
            "entities": [[entity, *s.p, s.lg, *s.r, s.rest] for entity, s in sorted(client.states.items())],
            "events": [event.tick for event in snapshot.events],
        })

    def report(self, client):
        welcome = client.welcome
        codes = play_pb2.InputCode
        return {
            "welcome": {"client_id": welcome.client_id, "world_name": welcome.world_name, "tick_hz": welcome.tick_hz,
                        "codec": welcome.codec, "ack_interval_ms": welcome.ack_interval_ms,
                        "units_per_meter": welcome.quant.units_per_meter,
                        "rotation_component": welcome.quant.rotation_component},
            "snapshots": self.snapshots,
            "known_entities": sorted(client.entities),
            "results": [[r.sequence, codes.Name(r.code), r.tick, r.entity] for _, r in sorted(client.results.items())],
            "offset_us": client.offset_us,
            "first_position_m": [round(v, 6) for v in client.decoder.meters(client.states[min(client.states)])],
        }
