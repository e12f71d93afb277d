#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Decodes proto/golden/*.bin with the Python decoders, and compares proto/initial_models.txt with the tables of the C++ and
TypeScript clients. Exit status 77: a package is missing."""

import pathlib
import re
import struct
import sys
import types

try:
    import google.protobuf  # noqa: F401
    import grpc  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; install python3-grpcio")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "examples/python_client"))

from positions import Decoder  # noqa: E402
from range_frames import RangeFrames  # noqa: E402

SNAPSHOT = ROOT / "proto/snapshot/src"
SDK = ROOT / "clients/web/sdk/src/snapshot"


def baselines(frame, first, second, third):
    """Snapshot.baselines."""
    if not first:
        return 0
    dt1, dt2, dt3 = frame - first, first - second, second - third
    e2 = 255 if not second else 0 if dt2 == dt1 else dt2
    e3 = 0 if not second else 255 if not third else 0 if dt3 == dt2 else dt3
    return dt1 + 256 * e2 + 65536 * e3


def decode_file(path):
    """Number of decoded frames; raises if one differs from the file, by its checksum."""
    data = path.read_bytes()
    _, codec, units, rotation_max, count = struct.unpack_from("<4s4I", data)
    decoder, at = (RangeFrames if codec == 2 else Decoder)(units, rotation_max), 20
    for _ in range(count):
        frame, first, second, third, crc, entities, size = struct.unpack_from("<7I", data, at)
        at += 28 + 24 * entities
        snapshot = types.SimpleNamespace(frame=frame, crc=crc, packed=data[at:at + size],
                                         baselines=baselines(frame, first, second, third))
        decoded = decoder.decode(snapshot)
        if len(decoded) != entities:
            raise ValueError(f"frame {frame} has {len(decoded)} entities instead of {entities}")
        at += size
    return count


def main():
    faults = []
    for path in sorted((ROOT / "proto/golden").glob("*.bin")):
        try:
            print(f"{path.name}: {decode_file(path)} frames")
        except (ValueError, KeyError) as error:
            faults.append(f"{path.name}: {error!r}")
    first, second, points = (ROOT / "proto/initial_models.txt").read_text().splitlines()
    if (len(first), len(second), len(points)) != (6001, 6001, 803):
        faults.append("initial_models.txt must have lines of 6001, 6001 and 803 letters")
    for name, tables in (("start_models", first + second), ("start_point_models", points)):
        for folder, ending, quote in ((SNAPSHOT, "cpp", '"'), (SDK, "ts", "'")):
            source = (folder / f"{name}.{ending}").read_text()
            letters = "".join(re.findall(rf"^\s*{quote}([^{quote}\n]*){quote}[,;}}]*$", source, re.M))
            if letters != tables:
                faults.append(f"{name}.{ending} and initial_models.txt differ")
    print("\n".join(faults) or "all as expected")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
