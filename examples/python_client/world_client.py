# SPDX-License-Identifier: MIT
"""The client side of a play stream without a network, written from proto/WIRE.md alone: messages in, messages out.

A transport calls receive() with every ServerMessage and sends what next_message() returns, until it returns None; it calls
next_message() again after each message, and at the latest after wait_us(). Times are microseconds of one monotonic clock.
play_sphere.py is such a transport; tests/clients/python replays the golden conversation with another one.
"""

import collections

from positions import Decoder
from range_frames import RangeFrames
from world_data import WorldData

from jostle.v1 import play_pb2

FIRST_PINGS, FIRST_PING_US, PING_US = 3, 100_000, 5_000_000
CLOCK_SAMPLES_US = 30_000_000
FRAMES_MAX = 32          # stored frames
BATCH_US = 1_000_000 // 30
INPUTS_PER_BATCH = 64


class WorldClient:
    """One stream, from Hello to Leave."""

    def __init__(self, name, world="", codec=2, events=False):
        self.hello = play_pb2.Hello(protocol=1, world=world, name=name, codec=codec, events=events)
        self.hello_sent = self.leaving = self.left = False
        self.welcome, self.decoder = None, None
        self.entities, self.states, self.frame = {}, {}, 0
        self.events, self.results, self.notices, self.decode_errors = [], {}, [], []
        self.samples, self.offset_us, self.pings, self.next_ping_us = [], 0, 0, 0
        self.need_keyframe, self.unacked, self.last_ack_us, self.decoded_us = False, False, 0, 0
        self.data = WorldData()  # set hello.players, attributes and topics before the first message
        self.inputs, self.next_sequence, self.next_batch_us = collections.deque(), 1, 0

    # Receiving

    def receive(self, message, now_us):
        kind = message.WhichOneof("message")
        if kind == "welcome":
            self.on_welcome(message.welcome, now_us)
        elif kind == "entity_update":
            for entity in message.entity_update.removed:
                self.entities.pop(entity, None)
            self.entities.update((entity.id, entity) for entity in message.entity_update.added)
        elif kind == "snapshot":
            self.on_snapshot(message.snapshot, now_us)
        elif kind == "pong":
            self.on_pong(message.pong, now_us)
        elif kind == "notice":
            self.notices.append(message.notice)

    def on_welcome(self, welcome, now_us):
        self.welcome = welcome
        decoder = RangeFrames if welcome.codec == 2 else Decoder
        self.decoder = decoder(welcome.quant.units_per_meter, welcome.quant.rotation_component)
        self.next_ping_us = self.last_ack_us = now_us

    def on_snapshot(self, snapshot, now_us):
        try:
            self.states = self.decoder.decode(snapshot)
            self.frame, self.need_keyframe = snapshot.frame, False
            for old in sorted(self.decoder.frames)[:-FRAMES_MAX]:
                del self.decoder.frames[old]
        except (ValueError, KeyError) as error:
            self.decode_errors.append(f"frame {snapshot.frame}: {error!r}")
            self.need_keyframe = True
        self.unacked, self.decoded_us = True, now_us
        self.events.extend(snapshot.events)
        self.data.apply(snapshot)
        self.results.update((result.sequence, result) for result in snapshot.client_update.results)

    def on_pong(self, pong, now_us):
        """The sample with the shortest round trip of the last 30 s gives the offset of the server's clock."""
        round_trip = now_us - pong.client_time_us
        offset = pong.server_time_us - pong.client_time_us - round_trip // 2
        self.samples = [s for s in self.samples if s[2] + CLOCK_SAMPLES_US >= now_us] + [(round_trip, offset, now_us)]
        self.offset_us = min(self.samples)[1]

    # The time of a frame

    def due_us(self, snapshot):
        """When the tick of a snapshot was due, on this client's clock."""
        server = self.welcome.epoch_us + round(snapshot.frame * 1e6 / self.welcome.tick_hz) + snapshot.late_us
        return server - self.offset_us

    # Sending

    def send_input(self, value):
        """Queues an Input and returns its sequence number."""
        self.inputs.append(value)
        return self.next_sequence + len(self.inputs) - 1

    def leave(self):
        self.leaving = True

    def next_message(self, now_us):
        """The next ClientMessage that is due, or None."""
        if not self.hello_sent:
            self.hello_sent = True
            return play_pb2.ClientMessage(hello=self.hello)
        if not self.welcome or self.left:
            return None
        if self.leaving:
            self.left = True
            return play_pb2.ClientMessage(leave=play_pb2.Leave())
        if self.inputs and now_us >= self.next_batch_us:
            return self.batch(now_us)
        if self.ack_is_due(now_us):
            return play_pb2.ClientMessage(ack=self.ack(now_us))
        if now_us >= self.next_ping_us:
            self.pings += 1
            self.next_ping_us = now_us + (FIRST_PING_US if self.pings < FIRST_PINGS else PING_US)
            return play_pb2.ClientMessage(ping=play_pb2.Ping(client_time_us=now_us))
        return None

    def ack_is_due(self, now_us):
        """A timer, and not a look at the clock when a snapshot arrives: the server may wait for the Ack."""
        if not self.unacked:
            return False
        return self.need_keyframe or now_us >= self.last_ack_us + 1000 * self.welcome.ack_interval_ms

    def ack(self, now_us):
        self.unacked, self.last_ack_us = False, now_us
        return play_pb2.Ack(frame=self.frame, need_keyframe=self.need_keyframe,
                            ack_delay_ms=(now_us - self.decoded_us) // 1000)

    def batch(self, now_us):
        inputs = [self.inputs.popleft() for _ in range(min(len(self.inputs), INPUTS_PER_BATCH))]
        batch = play_pb2.InputBatch(first_sequence=self.next_sequence, inputs=inputs, client_time_us=now_us % 2**32)
        if self.unacked:
            batch.ack.CopyFrom(self.ack(now_us))
        self.next_sequence += len(inputs)
        self.next_batch_us = now_us + BATCH_US
        return play_pb2.ClientMessage(input=batch)

    def wait_us(self, now_us):
        """Time until next_message() may return something although no message arrives."""
        if not self.welcome:
            return 5_000_000
        due = [self.next_ping_us]
        if self.unacked:
            due.append(self.last_ack_us + 1000 * self.welcome.ack_interval_ms)
        if self.inputs:
            due.append(self.next_batch_us)
        return max(0, min(due) - now_us)
