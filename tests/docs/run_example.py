#!/usr/bin/env python3
"""Runs a program of examples/ and compares its output.

Usage: run_example.py [--server JOSTLE_SERVER] [--expect TEXT]... -- COMMAND...
With --server a server runs on free ports of the loopback device; {grpc} and {http} in COMMAND become its ports. Each TEXT must be in
the output, in this order. Exit status: 0 the program ended with 0 and printed all of it, 1 not.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

START_SECONDS, RUN_SECONDS = 30, 60


def start_server(program, folder):
    ports = pathlib.Path(folder) / "ports.json"
    server = subprocess.Popen([program, "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0", "--admin", "", "--log-level", "warn",
                               "--port-file", str(ports)], cwd=folder)
    end = time.monotonic() + START_SECONDS
    while not ports.exists():
        if server.poll() is not None or time.monotonic() > end:
            server.kill()
            raise SystemExit("run_example.py: the server did not start")
        time.sleep(0.02)
    return server, json.loads(ports.read_text())


def missing(texts, output):
    """The first text that does not follow those before it, or None."""
    at = 0
    for text in texts:
        at = output.find(text, at)
        if at < 0:
            return text
        at += len(text)
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--server")
    parser.add_argument("--expect", action="append", default=[])
    parser.add_argument("command", nargs="+")
    arguments = parser.parse_args()
    # gRPC would look for the loopback device behind a proxy.
    for name in [name for name in os.environ if name.lower().endswith("_proxy")]:
        del os.environ[name]
    with tempfile.TemporaryDirectory() as folder:
        server, command = None, arguments.command
        if arguments.server:
            server, ports = start_server(os.path.abspath(arguments.server), folder)
            command = [word.replace("{grpc}", str(ports["grpc"])).replace("{http}", str(ports["http"])) for word in command]
        try:
            run = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 timeout=RUN_SECONDS)
        finally:
            if server:
                server.terminate()
                server.wait(START_SECONDS)
    print(run.stdout, end="")
    if run.returncode != 0:
        print(f"run_example.py: {command[0]} ended with status {run.returncode}")
        return 1
    text = missing(arguments.expect, run.stdout)
    if text is not None:
        print(f"run_example.py: \"{text}\" is missing in the output")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
