#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Records proto/golden/conversation.jcnv and conversation.json: a client in a small world, from Hello to the end of the stream.
    record_golden_conversation.py FOLDER      FOLDER has jostle-server
Run it only when the protocol changes, with an entry in docs/design/format_changes.md; the bytes differ from run to run.
"""

import json
import pathlib
import queue
import socket
import subprocess
import sys
import threading
import time

import grpc

import conversation
import golden_client
from jostle.v1 import play_pb2

SCENE = pathlib.Path(__file__).with_name("golden_scene.json")
METHOD = "/jostle.v1.PlayService/Play"


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def record(channel):
    """The records, and the report of the client."""
    began = time.monotonic_ns() // 1000
    client, observation, records, number = golden_client.new_client(), golden_client.Observation(), [], 0
    outgoing, incoming = queue.Queue(), queue.Queue()
    call = channel.stream_stream(METHOD, bytes, bytes)(iter(outgoing.get, None))

    def read():
        for data in call:
            incoming.put(data)
        incoming.put(None)

    threading.Thread(target=read, daemon=True).start()
    while True:
        now = time.monotonic_ns() // 1000 - began
        while message := client.next_message(now):
            records.append((conversation.TO_SERVER, now, message.SerializeToString()))
            outgoing.put(records[-1][2])
        try:
            data = incoming.get(timeout=client.wait_us(now) / 1e6 if not client.left else 5)
        except queue.Empty:
            continue
        if data is None:
            outgoing.put(None)
            return records, observation.report(client)
        if client.left:
            continue  # sent before the server read the Leave
        now = time.monotonic_ns() // 1000 - began
        message = play_pb2.ServerMessage.FromString(data)
        records.append((conversation.TO_CLIENT, now, data))
        client.receive(message, now)
        observation.after(client, message)
        if message.HasField("snapshot"):
            number += 1
            golden_client.after_snapshot(client, number)


def main():
    programs = pathlib.Path(sys.argv[1])
    port, web = free_port(), free_port()
    server = subprocess.Popen([programs / "jostle-server", "--scene", f"golden={SCENE}", "--listen", f"127.0.0.1:{port}", "--http",
                               f"127.0.0.1:{web}", "--admin", ""])
    try:
        with grpc.insecure_channel(f"127.0.0.1:{port}") as channel:
            grpc.channel_ready_future(channel).result(timeout=30)
            records, report = record(channel)
    finally:
        server.terminate()
        server.wait(10)
    conversation.write(golden_client.CONVERSATION, records)
    lines = json.dumps(report, indent=None, separators=(", ", ": "))
    golden_client.EXPECTED.write_text(lines.replace('{"frame"', '\n{"frame"').replace(', "known', ',\n"known') + "\n")
    print(f"{len(records)} messages, {sum(len(data) for *_, data in records)} bytes")


if __name__ == "__main__":
    main()
