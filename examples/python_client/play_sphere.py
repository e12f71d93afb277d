#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Python client: joins a world with codec 2, spawns a sphere, and prints where it falls.

Shows: a complete client (world_client.py) with acknowledgements by a timer, inputs and their results, and the server's clock.
Run:   jostle-server &
       python3 examples/python_client/play_sphere.py localhost:50051
Needs the Debian packages python3-grpcio, protobuf-compiler and protobuf-compiler-grpc.
"""

import queue
import sys
import threading
import time

import grpc

import stubs  # noqa: F401  generates jostle.v1
from jostle.v1 import common_pb2, play_pb2, play_pb2_grpc, scene_pb2

from world_client import WorldClient


def now_us():
    return time.monotonic_ns() // 1000


def sphere(x, y, z, radius):
    """An input that spawns a sphere."""
    shape = scene_pb2.Shape(sphere=scene_pb2.Sphere(radius=radius))
    return play_pb2.Input(spawn=play_pb2.SpawnInput(shape=shape, position=common_pb2.Vec3(x=x, y=y, z=z)))


class Connection:
    """The transport: one thread reads messages; the caller's thread does everything else."""

    def __init__(self, channel, client):
        self.client, self.outgoing, self.incoming = client, queue.Queue(), queue.Queue()
        call = play_pb2_grpc.PlayServiceStub(channel).Play(iter(self.outgoing.get, None))

        def read():
            try:
                for message in call:
                    self.incoming.put(message)
            except grpc.RpcError as error:
                print(f"the stream ended: {error.code().name}: {error.details()}", file=sys.stderr)
            self.incoming.put(None)

        threading.Thread(target=read, daemon=True).start()

    def run_until(self, done):
        """Exchanges messages until done(message) is true; returns False if the server ended the stream."""
        while True:
            while message := self.client.next_message(now_us()):
                self.outgoing.put(message)
            if self.client.left:
                while self.incoming.get() is not None:  # the server closes the stream
                    pass
                self.outgoing.put(None)
                return True
            try:
                message = self.incoming.get(timeout=self.client.wait_us(now_us()) / 1e6)
            except queue.Empty:
                continue
            if message is None:
                return False
            self.client.receive(message, now_us())
            if done(message):
                return True


def main():
    target = sys.argv[1] if len(sys.argv) > 1 else "localhost:50051"
    client = WorldClient("python")
    with grpc.insecure_channel(target) as channel:
        connection = Connection(channel, client)
        connection.run_until(lambda message: client.states)
        sequence = client.send_input(sphere(0.5, 6, 0.5, 0.3))
        connection.run_until(lambda message: sequence in client.results)
        result = client.results[sequence]
        if result.code != play_pb2.INPUT_CODE_APPLIED:
            raise SystemExit(f"the input was rejected: {result.message}")
        print(f"entity {result.entity} was spawned in tick {result.tick}")
        last = result.tick + 60
        connection.run_until(lambda message: client.frame >= last and result.entity in client.states)
        x, y, z = client.decoder.meters(client.states[result.entity])
        print(f"after 60 ticks it is at {x:.2f} {y:.2f} {z:.2f} m")
        client.leave()
        connection.run_until(lambda message: False)
    if client.decode_errors:
        raise SystemExit(f"snapshots could not be decoded: {client.decode_errors}")


if __name__ == "__main__":
    main()
