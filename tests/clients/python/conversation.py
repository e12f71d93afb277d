# SPDX-License-Identifier: MIT
"""Files of conversations between a client and a server (proto/WIRE.md, "Golden conversation")."""

import struct

MAGIC, VERSION = b"JCNV", 1
TO_SERVER, TO_CLIENT = 0, 1


def read(path):
    """[(direction, time in us since the start, bytes of the message)]"""
    data = path.read_bytes()
    magic, version, count = struct.unpack_from("<4s2I", data)
    if magic != MAGIC or version != VERSION:
        raise ValueError(f"{path} is not a conversation of version {VERSION}")
    records, at = [], 12
    for _ in range(count):
        direction, time_us, size = struct.unpack_from("<3I", data, at)
        records.append((direction, time_us, data[at + 12:at + 12 + size]))
        at += 12 + size
    if at != len(data):
        raise ValueError(f"{path} continues after its last message")
    return records


def write(path, records):
    out = [struct.pack("<4s2I", MAGIC, VERSION, len(records))]
    for direction, time_us, message in records:
        out += struct.pack("<3I", direction, time_us, len(message)), message
    path.write_bytes(b"".join(out))
