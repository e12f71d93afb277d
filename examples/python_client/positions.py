#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Python client: joins a world and decodes the positions and rotations of its bodies from 60 snapshots.

Shows: the decoder of codec 1 (proto/WIRE.md), its checksum, and the play stream.
Run:   jostle-server &
       python3 examples/python_client/positions.py localhost:50051
Needs the Debian packages python3-grpcio, protobuf-compiler and protobuf-compiler-grpc.
"""

import collections
import math
import queue
import struct
import sys
import zlib

import grpc

import stubs  # noqa: F401  generates jostle.v1
from jostle.v1 import play_pb2, play_pb2_grpc

# Integers: position p in 1/units_per_meter m; rotation as the index `lg` of the omitted component and the others in r.
State = collections.namedtuple("State", "p lg r rest")
POSITION_BITS = (0, 0, 0, 1, 2, 2, 3, 3, 4, 5, 6, 7)
ROTATION_BITS = (0, 0, 0, 1, 2, 3, 4, 4, 5, 6, 7, 8)


class Bits:
    """Reads codes from packed bytes, least significant bit first."""

    def __init__(self, data):
        self.value, self.size, self.at = int.from_bytes(data, "little"), 8 * len(data), 0

    def peek(self, count):
        return self.value >> self.at & (1 << count) - 1

    def take(self, count):
        if self.at + count > self.size:
            raise ValueError("the snapshot ends early")
        result = self.peek(count)
        self.at += count
        return result

    def rice(self, k):
        high = 0
        while high < 15 and self.take(1):
            high += 1
        return high << k | self.take(k) if high < 15 else self.take(33)

    def expg(self, k):
        width = self.rice(0) + k
        return (1 << width | self.take(width)) - (1 << k)

    def positions(self):
        found, following = [], 0
        for _ in range(self.expg(0)):
            found.append(following + self.expg(4))
            following = found[-1] + 1
        return found


def unzig(value):
    return value >> 1 ^ -(value & 1)


def div(a, b):
    return (a + b // 2) // b if a >= 0 else -((-a + b // 2) // b)


def scaled(value, numerator, denominator):
    return value if numerator == denominator else div(value * numerator, denominator)


def same_pose(a, b):
    return a[:3] == b[:3]


class Decoder:
    """Frames of one stream. Each is encoded against up to three earlier ones."""

    def __init__(self, units_per_meter, rotation_max):
        self.units, self.m = units_per_meter, rotation_max
        self.component_bits = rotation_max.bit_length() + 1
        self.frames = {}  # frame: {id: State}

    def decode(self, snapshot):
        """Returns {id: State}; raises ValueError or KeyError if the snapshot cannot be decoded."""
        spacing = snapshot.baselines
        d1, e2, e3 = spacing & 255, spacing >> 8 & 255, spacing >> 16
        frame, bases, dts = snapshot.frame, [{}, {}, {}], [1, 1, 1]
        if d1:
            dts[0], bases[0] = d1, self.frames[frame - d1]
            if e2 != 255:
                dts[1] = e2 or d1
                bases[1] = self.frames[frame - dts[0] - dts[1]]
                if e3 != 255:
                    dts[2] = e3 or dts[1]
                    bases[2] = self.frames[frame - sum(dts)]
        states = self.read(Bits(snapshot.packed), bases, dts)
        packed = b"".join(struct.pack("<I3iB3hB", entity, *s.p, s.lg, *s.r, s.rest)
                          for entity, s in sorted(states.items()))
        if zlib.crc32(packed) != snapshot.crc:
            raise ValueError(f"wrong checksum of frame {frame}")
        self.frames[frame] = states
        for old in [number for number in self.frames if number < frame - 3 * 254]:
            del self.frames[old]
        return states

    def read(self, bits, bases, dts):
        base = bases[0]
        known = sorted(base)
        removed = {known[k] for k in bits.positions()} if base else set(bits.positions())
        states, following = {}, 1
        for _ in range(bits.expg(0)):
            entity = following + bits.expg(4)
            following = entity + 1
            p = tuple(unzig(bits.expg(12)) for _ in range(3))
            states[entity] = State(p, *self.components(bits), bits.take(1))
        survivors = [entity for entity in known if entity not in removed]
        run, kept = bits.expg(5), []
        for entity in survivors:
            b1, b2, b3 = (frame.get(entity) for frame in bases)
            b3 = b3 if b2 else None
            motionless = b1.rest or not b2 or (same_pose(b1, b2) and (not b3 or same_pose(b1, b3)))
            if motionless:
                changes, run = run == 0, run - 1
            else:
                changes = bits.take(1)
            if not changes:
                kept.append((entity, b1))
                continue
            if b1.rest:
                b2 = b3 = None
            kept.append((entity, self.pose(bits, b1, b2, b3, dts, motionless)))
            if motionless:
                run = bits.expg(5)
        toggled = set(bits.positions())
        for k, (entity, state) in enumerate(kept):
            states[entity] = state._replace(rest=state.rest ^ (k in toggled))
        return states

    def components(self, bits):
        lg, sign = bits.take(2), 1 << self.component_bits - 1
        return lg, tuple((bits.take(self.component_bits) ^ sign) - sign for _ in range(3))

    def unpack(self, state):
        largest = math.isqrt(max(0, 2 * self.m * self.m - sum(r * r for r in state.r)))
        return [*state.r[:state.lg], largest, *state.r[state.lg:]]

    def pose(self, bits, b1, b2, b3, dts, motionless):
        dt1, dt2, dt3 = dts
        position, change_p = [], 0
        for axis in range(3):
            d = b1.p[axis] - b2.p[axis] if b2 else 0
            change_p += abs(d - (scaled(b2.p[axis] - b3.p[axis], dt2, dt3) if b3 else d))
            position.append(min(max(b1.p[axis] + scaled(d, dt1, dt2), -2**31), 2**31 - 1))
        lg, rotation, change_r = self.predicted_rotation(b1, b2, b3, dts)
        if motionless or not b3 or same_pose(b1, b2):
            change_p, change_r = max(change_p, 4 * dt1), max(change_r, 4 * dt1)
        kp, kr = POSITION_BITS[min(change_p.bit_length(), 11)], ROTATION_BITS[min(change_r.bit_length(), 11)]
        p = tuple(value + unzig(bits.rice(kp)) for value in position)
        if change_r == 0 and bits.take(1):
            return State(p, lg, tuple(rotation), 0)
        if bits.peek(15) == 0x7FFF:
            bits.take(15)
            return State(p, *self.components(bits), 0)
        return State(p, lg, tuple(value + unzig(bits.rice(kr)) for value in rotation), 0)

    def predicted_rotation(self, b1, b2, b3, dts):
        dt1, dt2, dt3 = dts
        n, q1 = 2 * self.m * self.m, self.unpack(b1)
        q, changes = list(q1), [0] * 4
        turning = b2 and not (b1[1:3] == b2[1:3] and (not b3 or b2[1:3] == b3[1:3]))
        if turning:
            q2 = self.aligned(b2, q1)
            dq = [a - b for a, b in zip(q1, q2)]
            if b3:
                changes = [d - scaled(a - b, dt2, dt3) for d, a, b in zip(dq, q2, self.aligned(b3, q2))]
            n2 = sum(d * d for d in dq)
            if n2 <= n // 2:
                bend = n2 if dt1 == dt2 else div(n2 * dt1 * (dt1 + dt2), 2 * dt2 * dt2)
                bends = bend * self.m >= n // 4
                q = [a + scaled(d, dt1, dt2) - (div(a * bend, n) if bends else 0) for a, d in zip(q1, dq)]
        lg = max(range(4), key=lambda k: (abs(q[k]), -k))
        sign = -1 if q[lg] < 0 else 1
        others = [k for k in range(4) if k != lg]
        return lg, [sign * q[k] for k in others], sum(abs(changes[k]) for k in others)

    def aligned(self, state, reference):
        q = self.unpack(state)
        return [-a for a in q] if sum(a * b for a, b in zip(q, reference)) < 0 else q

    def meters(self, state):
        return tuple(value / self.units for value in state.p)

    def quaternion(self, state):
        """x, y, z, w"""
        small = [r / (self.m * math.sqrt(2)) for r in state.r]
        small.insert(state.lg, math.sqrt(max(0, 1 - sum(c * c for c in small))))
        return tuple(small)


def main():
    target = sys.argv[1] if len(sys.argv) > 1 else "localhost:50051"
    outgoing = queue.Queue()
    outgoing.put(play_pb2.ClientMessage(hello=play_pb2.Hello(protocol=1, name="python")))
    decoder, decoded = None, 0
    with grpc.insecure_channel(target) as channel:
        for message in play_pb2_grpc.PlayServiceStub(channel).Play(iter(outgoing.get, None)):
            kind = message.WhichOneof("message")
            if kind == "welcome":
                decoder = Decoder(message.welcome.quant.units_per_meter, message.welcome.quant.rotation_component)
            elif kind == "snapshot":
                states = decoder.decode(message.snapshot)
                outgoing.put(play_pb2.ClientMessage(ack=play_pb2.Ack(frame=message.snapshot.frame)))
                decoded += 1
                if decoded == 60:
                    break
        outgoing.put(play_pb2.ClientMessage(leave=play_pb2.Leave()))
        outgoing.put(None)
    print(f"decoded 60 snapshots of {len(states)} entities; every checksum is correct")
    for entity in sorted(states)[:3]:
        x, y, z = decoder.meters(states[entity])
        print(f"entity {entity} is at {x:.3f} {y:.3f} {z:.3f} m")


if __name__ == "__main__":
    main()
