"""A minimal protobuf encoder and decoder: it writes any message, valid or malformed, and reads the fields that a player needs.

A message is bytes. The function of its wire type writes a field; fields are joined with +:
    hello = uint(1, 1) + text(2, "sandbox")
    message = nested(1, hello)
"""

import struct


def varint(value):
    out = bytearray()
    value &= 0xFFFFFFFFFFFFFFFF
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def uint(number, value):
    return varint(number << 3) + varint(value)


def double(number, value):
    return varint(number << 3 | 1) + struct.pack("<d", value)


def fixed32(number, value):
    return varint(number << 3 | 5) + struct.pack("<I", value & 0xFFFFFFFF)


def fixed64(number, value):
    return varint(number << 3 | 1) + struct.pack("<Q", value)


def nested(number, payload):
    return varint(number << 3 | 2) + varint(len(payload)) + payload


def text(number, value):
    return nested(number, value.encode() if isinstance(value, str) else value)


def packed_uints(number, values):
    return nested(number, b"".join(map(varint, values)))


def read_varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value, at
        shift += 7


def fields(data):
    """Yield (number, value): an int for varint and fixed32/64 fields, bytes for length-delimited fields."""
    at, end = 0, len(data)
    while at < end:
        key, at = read_varint(data, at)
        kind = key & 7
        if kind == 0:
            value, at = read_varint(data, at)
        elif kind == 1:
            value, at = int.from_bytes(data[at:at + 8], "little"), at + 8
        elif kind == 5:
            value, at = int.from_bytes(data[at:at + 4], "little"), at + 4
        elif kind == 2:
            size, at = read_varint(data, at)
            value, at = bytes(data[at:at + size]), at + size
        else:
            raise ValueError(f"wire type {kind}")
        yield key >> 3, value


def field(data, number, default=None):
    """The last value of one field."""
    found = default
    for this, value in fields(data):
        if this == number:
            found = value
    return found


def all_of(data, number):
    return [value for this, value in fields(data) if this == number]


def as_double(bits):
    return struct.unpack("<d", bits.to_bytes(8, "little"))[0]
