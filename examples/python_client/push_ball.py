#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Python client: joins a world, spawns a ball, pushes it, and measures with a ray cast how far it moved.

Shows: the play stream (Hello, InputBatch, Ack, EntityUpdate, Snapshot) and QueryService, over gRPC.
Run:   jostle-server &
       python3 examples/python_client/push_ball.py localhost:50051
Needs the Debian packages python3-grpcio, protobuf-compiler and protobuf-compiler-grpc.
"""

import queue
import sys
import threading
import time

import grpc

import stubs  # noqa: F401  generates jostle.v1
from jostle.v1 import play_pb2, play_pb2_grpc, query_pb2, query_pb2_grpc, scene_pb2


class Player:
    """One client in one world. Reads its stream in a thread of its own."""

    def __init__(self, channel, world=""):
        self.entities, self.results, self.sequence = {}, {}, 0
        self.welcome, self.error = None, None
        self.changed = threading.Condition()
        self.outgoing = queue.Queue()
        self.send(hello=play_pb2.Hello(protocol=1, world=world, name="python"))
        self.stream = play_pb2_grpc.PlayServiceStub(channel).Play(iter(self.outgoing.get, None))
        threading.Thread(target=self.read, daemon=True).start()

    def send(self, **message):
        self.outgoing.put(play_pb2.ClientMessage(**message))

    def read(self):
        try:
            for message in self.stream:
                with self.changed:
                    self.handle(message)
                    self.changed.notify_all()
        except grpc.RpcError as error:
            with self.changed:
                self.error = error.details()
                self.changed.notify_all()

    def handle(self, message):
        kind = message.WhichOneof("message")
        if kind == "welcome":
            self.welcome = message.welcome
        elif kind == "entity_update":  # entities that appeared and disappeared
            for entity in message.entity_update.added:
                self.entities[entity.id] = entity
            for entity in message.entity_update.removed:
                self.entities.pop(entity, None)
        elif kind == "snapshot":
            for result in message.snapshot.client_update.results:
                self.results[result.sequence] = result
            # The server sends at most 30 snapshots that are not acknowledged. positions.py decodes their poses.
            self.send(ack=play_pb2.Ack(frame=message.snapshot.frame))
        elif kind == "notice":
            self.error = message.notice.message

    def wait(self, condition, seconds=10):
        with self.changed:
            self.changed.wait_for(lambda: condition() or self.error, seconds)
            if not condition():
                raise SystemExit(f"push_ball.py: {self.error or 'the server does not respond'}")
            return condition()

    def apply(self, **kind):
        """Sends one input and returns its result."""
        self.sequence += 1
        number = self.sequence
        self.send(input=play_pb2.InputBatch(first_sequence=number, inputs=[play_pb2.Input(**kind)]))
        result = self.wait(lambda: self.results.get(number))
        if result.code != play_pb2.INPUT_CODE_APPLIED:
            raise SystemExit(f"push_ball.py: input rejected: {result.message}")
        return result


def ball_front(queries, ball):
    """x of the front of the ball: a ray along -x hits it."""
    ray = query_pb2.Ray(origin={"x": 9, "y": 0.3, "z": 6.8}, motion={"x": -18})
    hits = queries.CastRays(query_pb2.CastRaysRequest(rays=[ray])).rays[0].hits
    return next((hit.point.x for hit in hits if hit.entity == ball), None)


def main():
    target = sys.argv[1] if len(sys.argv) > 1 else "localhost:50051"
    with grpc.insecure_channel(target) as channel:
        queries = query_pb2_grpc.QueryServiceStub(channel)
        me = Player(channel)
        me.wait(lambda: me.welcome)
        print(f"joined world {me.welcome.world_name} as client {me.welcome.client_id}")

        shape = scene_pb2.Shape(sphere=scene_pb2.Sphere(radius=0.3))
        ball = me.apply(spawn=play_pb2.SpawnInput(shape=shape, position={"x": 0, "y": 0.3, "z": 6.8})).entity
        mass = me.wait(lambda: me.entities.get(ball)).mass
        start = ball_front(queries, ball)
        print(f"spawned a ball of {mass:.0f} kg as entity {ball}")

        me.apply(impulse=play_pb2.ImpulseInput(entity=ball, impulse={"x": 3 * mass}))  # N s: 3 m/s
        time.sleep(1)
        front = ball_front(queries, ball)
        if front is None:
            print("one second after the push the ball is not on the line of the ray")
        else:
            print(f"one second after the push it is {front - start:.1f} m further")

        me.send(leave=play_pb2.Leave())
        me.outgoing.put(None)
    return 0


if __name__ == "__main__":
    sys.exit(main())
