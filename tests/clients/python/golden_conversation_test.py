#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Replays proto/golden/conversation.jcnv with the Python client: it must send the same bytes at the same times, and know what
conversation.json says. Exit status 77: a package is missing."""

import json
import sys

try:
    import google.protobuf  # noqa: F401
    import grpc  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; install python3-grpcio")
    sys.exit(77)

import conversation
import golden_client
from jostle.v1 import play_pb2


def main():
    client, observation, number, faults = golden_client.new_client(), golden_client.Observation(), 0, []
    records = conversation.read(golden_client.CONVERSATION)
    for k, (direction, time_us, data) in enumerate(records):
        if direction == conversation.TO_SERVER:
            sent = client.next_message(time_us)
            expected = play_pb2.ClientMessage.FromString(data)
            if sent != expected:
                faults.append(f"message {k} at {time_us} us: sends\n{sent}instead of\n{expected}")
            continue
        message = play_pb2.ServerMessage.FromString(data)
        client.receive(message, time_us)
        observation.after(client, message)
        if message.HasField("snapshot"):
            number += 1
            golden_client.after_snapshot(client, number)
    faults += client.decode_errors
    expected = json.loads(golden_client.EXPECTED.read_text())
    for key, value in json.loads(json.dumps(observation.report(client))).items():
        if value != expected.get(key):
            faults.append(f"{key} is\n{value}\ninstead of\n{expected.get(key)}")
    print("\n".join(faults) or f"{len(records)} messages, {number} snapshots: as expected")
    return 1 if faults or number != golden_client.SNAPSHOTS else 0


if __name__ == "__main__":
    sys.exit(main())
