# SPDX-License-Identifier: MIT
"""Decoder of snapshot codec 2, written from proto/WIRE.md ("Prediction" and "Codec 2") alone.

The quantized state, the prediction and the checksum are those of codec 1 in positions.py; only the bytes are read in another way.
Pure Python: about 0.1 ms for each moving body, so it suits tools and tests, not games.
"""

import pathlib

from positions import Decoder, State, div, same_pose, scaled

TABLES = pathlib.Path(__file__).resolve().parents[2] / "proto" / "initial_models.txt"
LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+,-./:;<=>"
LEVELS = (64, 64, 64, 89, 133, 198, 295, 439, 652, 968, 1434, 2117, 3108, 4531, 6537, 9296, 12964, 17625, 23222, 29502)
COUNT, NUMBER, TAIL = 40, 5, 25  # models of a count, of a number and of a tail

# Groups of models in the order of the document, each with the number of its models.
GROUPS = (("changes_entities", 1), ("removed", COUNT), ("removed_gap", COUNT), ("spawned", COUNT), ("id_gap", COUNT),
          ("position_step", 3 * COUNT), ("position_negative", 1), ("turned", 1), ("spawned_at_rest", 1), ("none_wake", 1),
          ("resting_run", COUNT), ("stays_at_rest", 1), ("changes", 3), ("falls_asleep", 3 * 2),
          ("position", 4 * 2 * 7 * 3 * 4 * NUMBER), ("position_tail", 4 * TAIL), ("same_largest", 4), ("other_largest", 2),
          ("rotation", 4 * 7 * 3 * 5 * NUMBER), ("rotation_tail", 4 * TAIL))


def initial_models():
    """[one, seen] of every model, for both tables."""
    tables = []
    for line in TABLES.read_text().splitlines()[:2]:
        models = []
        for letter in line:
            level, known = divmod(LETTERS.index(letter), 2)
            models.append((LEVELS[level] if level < 20 else 65536 - LEVELS[39 - level], 8 if known else 0))
        tables.append(models)
    return tables


INITIAL = initial_models()
START, _size = {}, 0
for _name, _count in GROUPS:
    START[_name], _size = _size, _size + _count
assert all(len(table) == _size for table in INITIAL), "the tables have one letter for each model"


class RangeDecoder:
    """Bits and numbers of one frame."""

    def __init__(self, data, table):
        self.data, self.at = data, 4
        self.code = int.from_bytes(data[:4].ljust(4, b"\0"), "big")
        self.range = 2**32 - 1
        self.models = [list(model) for model in INITIAL[table]]

    def shift_in(self):
        while self.range < 2**24:
            self.range <<= 8
            byte = self.data[self.at] if self.at < len(self.data) else 0
            self.code, self.at = (self.code << 8 | byte) & 0xFFFFFFFF, self.at + 1

    def bit(self, index):
        model = self.models[index]
        one, seen = model
        bound = (self.range >> 16) * one
        rate = 655360 // (10 * seen + 16)
        if self.code < bound:
            value, self.range = 1, bound
            one += (65535 - one) * rate >> 16
        else:
            value, self.code, self.range = 0, self.code - bound, self.range - bound
            one -= one * rate >> 16
        model[0], model[1] = min(max(one, 64), 65472), min(seen + 1, 100)
        self.shift_in()
        return value

    def raw(self, count):
        value = 0
        while count > 0:
            size = min(count, 16)
            self.range >>= size
            piece = min(self.code // self.range, (1 << size) - 1)
            self.code -= piece * self.range
            self.shift_in()
            value, count = value << size | piece, count - size
        return value

    def count(self, start):
        width = 0
        while width < COUNT and self.bit(start + width):
            width += 1
        return (1 << width) + self.raw(width) - 1

    def number(self, start, tail):
        nonzero, negative, above_1, above_3, odd = range(start, start + NUMBER)
        if not self.bit(nonzero):
            return 0
        sign = -1 if self.bit(negative) else 1
        if not self.bit(above_1):
            return sign
        if not self.bit(above_3):
            return sign * (2 + self.bit(odd))
        k = 0
        while k < 12 and self.bit(tail + k):
            k += 1
        width = 2 + k + (self.raw(5) if k == 12 else 0)
        second = self.bit(tail + 12 + k)
        return sign * ((2 + second << width - 1) + self.raw(width - 1))

    def finish(self):
        if not len(self.data) <= self.at <= len(self.data) + 4:
            raise ValueError("the snapshot ends early or continues")


def width_of(value, most):
    return min(abs(value).bit_length(), most)


def is_back(d, dd):
    return d < 0 or (d == 0 and dd < 0)


def bent(dd, back):
    dd = -dd if back else dd
    if dd <= -2:
        return 0 if dd <= -4 else 1
    if dd <= 1:
        return dd + 3
    return 5 if dd <= 3 else 6


def rest_class(total):
    return 0 if total == 0 else 1 if total <= 3 else 2


class RangeFrames(Decoder):
    """Decoder of a stream whose Welcome has codec 2; decode() and the other methods are those of codec 1."""

    def read(self, bits, bases, dts):
        coder = RangeDecoder(bits.value.to_bytes(bits.size // 8, "little"), 0 if dts[0] <= 2 else 1)
        known = sorted(bases[0])
        removed, spawned = set(), {}
        if coder.bit(START["changes_entities"]):
            removed = {known[k] for k in self.removed_positions(coder)}
            spawned = self.spawned(coder)
        states = {}
        survivors = [entity for entity in known if entity not in removed]
        resting = sum(bases[0][entity].rest for entity in survivors)
        run = self.run(coder, resting)
        for entity in survivors:
            b1, b2, b3 = (frame.get(entity) for frame in bases)
            b3 = b3 if b2 else None
            if b1.rest:
                resting -= 1
                if run > 0:
                    run, states[entity] = run - 1, b1
                    continue
                rest = coder.bit(START["stays_at_rest"])
                states[entity] = self.coded_pose(coder, b1, None, None, dts)._replace(rest=rest)
                run = self.run(coder, resting)
                continue
            group = self.motion_class(b1, b2, b3)
            changes = coder.bit(START["changes"] + group)
            rest = coder.bit(START["falls_asleep"] + 2 * group + changes)
            states[entity] = (self.coded_pose(coder, b1, b2, b3, dts) if changes else b1)._replace(rest=rest)
        coder.finish()
        if spawned.keys() & bases[0].keys():
            raise ValueError("a spawned entity is in the baseline")
        return {**states, **spawned}

    @staticmethod
    def removed_positions(coder):
        found, following = [], 0
        for _ in range(coder.count(START["removed"])):
            found.append(following + coder.count(START["removed_gap"]))
            following = found[-1] + 1
        return found

    def spawned(self, coder):
        states, entity, previous = {}, 0, State((0, 0, 0), 3, (0, 0, 0), 0)
        for _ in range(coder.count(START["spawned"])):
            entity += 1 + coder.count(START["id_gap"])
            p = []
            for axis in range(3):
                step = coder.count(START["position_step"] + COUNT * axis)
                if step > 0 and coder.bit(START["position_negative"]):
                    step = -step
                p.append(previous.p[axis] + step)
            lg, r = previous.lg, previous.r
            if coder.bit(START["turned"]):
                width = self.m.bit_length()
                lg, r = coder.raw(2), tuple(coder.raw(width + 1) - (1 << width) for _ in range(3))
            previous = states[entity] = State(tuple(p), lg, r, coder.bit(START["spawned_at_rest"]))
        return states

    @staticmethod
    def run(coder, remaining):
        if remaining == 0 or coder.bit(START["none_wake"]):
            return remaining
        return coder.count(START["resting_run"])

    @staticmethod
    def motion_class(b1, b2, b3):
        if not b2 or b2.rest or not same_pose(b1, b2):
            return 1
        return 0 if b3 and same_pose(b1, b3) else 2

    def coded_pose(self, coder, b1, b2, b3, dts):
        position, moved = self.coded_position(coder, b1, b2, b3, dts)
        q, dq, ddq = self.rotation(b1, b2, b3, dts)
        largest = max(range(4), key=lambda k: (abs(q[k]), -k))
        second = max(abs(q[k]) for k in range(4) if k != largest)
        lead = width_of(abs(q[largest]) - second, 15) // 4
        lg = largest
        if not coder.bit(START["same_largest"] + lead):
            j = 2 if coder.bit(START["other_largest"]) else coder.bit(START["other_largest"] + 1)
            lg = (largest + 1 + j) % 4
        sign = -1 if q[lg] < 0 else 1
        others = [k for k in range(4) if k != lg]
        q, dq, ddq = ([sign * values[k] for k in others] for values in (q, dq, ddq))
        r, off = [], 0
        for k in range(3):
            back = is_back(dq[k], ddq[k])
            total = sum(abs(value) for j, value in enumerate(ddq) if j != k)
            context = (int(moved) if k == 0 else 2 + width_of(off, 2))
            size = width_of(dq[k], 3)
            index = ((size * 7 + bent(ddq[k], back)) * 3 + rest_class(total)) * 5 + context
            number = coder.number(START["rotation"] + NUMBER * index, START["rotation_tail"] + TAIL * size)
            off += abs(number)
            r.append(q[k] - number if back else q[k] + number)
        return State(tuple(position), lg, tuple(r), 0)

    @staticmethod
    def coded_position(coder, b1, b2, b3, dts):
        dt1, dt2, dt3 = dts
        d = [b1.p[k] - b2.p[k] if b2 else 0 for k in range(3)]
        dd = [d[k] - (scaled(b2.p[k] - b3.p[k], dt2, dt3) if b3 else d[k]) for k in range(3)]
        position, off = [], 0
        for k in range(3):
            expected = min(max(b1.p[k] + scaled(d[k], dt1, dt2), -2**31), 2**31 - 1)
            back, size = is_back(d[k], dd[k]), width_of(d[k], 3)
            total = sum(abs(value) for j, value in enumerate(dd) if j != k)
            context = 0 if k == 0 else 1 + width_of(off, 4) // 2
            index = (((size * 2 + int(k == 1)) * 7 + bent(dd[k], back)) * 3 + rest_class(total)) * 4 + context
            number = coder.number(START["position"] + NUMBER * index, START["position_tail"] + TAIL * size)
            off += abs(number)
            position.append(expected - number if back else expected + number)
        return position, off > 0

    def rotation(self, b1, b2, b3, dts):
        """Q, dq and ddq of "Prediction"."""
        dt1, dt2, dt3 = dts
        n, q1 = 2 * self.m * self.m, self.unpack(b1)
        if not b2 or (b1[1:3] == b2[1:3] and (not b3 or b2[1:3] == b3[1:3])):
            return q1, [0] * 4, [0] * 4
        q2 = self.aligned(b2, q1)
        dq, ddq = [a - b for a, b in zip(q1, q2)], [0] * 4
        if b3:
            ddq = [d - scaled(a - b, dt2, dt3) for d, a, b in zip(dq, q2, self.aligned(b3, q2))]
        n2 = sum(d * d for d in dq)
        if n2 > n // 2:
            return q1, [0] * 4, ddq
        bend = n2 if dt1 == dt2 else div(n2 * dt1 * (dt1 + dt2), 2 * dt2 * dt2)
        bends = bend * self.m >= n // 4
        return [a + scaled(d, dt1, dt2) - (div(a * bend, n) if bends else 0) for a, d in zip(q1, dq)], dq, ddq
