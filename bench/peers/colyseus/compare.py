#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compare Jostle with Colyseus and Rapier: the same scene (balls.json), the same number of clients, one after the other.
    npm ci && ./compare.py FOLDER [--clients 20 100 400] [--seconds 10] [--rounds 1] [--json FILE]
FOLDER has jostle-server and jostle-load of a release build. Needs Linux (/proc) and Node 20.

For each number of clients, and in each round for each server in turn (Colyseus, Jostle over WebSocket, Jostle over gRPC):
- nearly all clients are passive: they read messages and acknowledge as the protocol requires, but decode nothing;
  5 clients (Jostle: at least 5, 5 % of them) decode and measure the age of a state, from the start of its step to its arrival;
- cpu is the CPU time of the server process per second. cpu_us_per_message is the cost of one client more in one update: CPU time
  per update, less that with 1 client, divided by the additional clients. memory_mb is the resident set at the end.
The columns of --json are those of the table. Ratios of one round count: both run on the same machine at the same time of day.
"""

import argparse
import contextlib
import json
import os
import pathlib
import socket
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
TICKS = os.sysconf("SC_CLK_TCK")
PROBES, SETTLE = 5, 3


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for_port(port):
    for _ in range(600):
        with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port), 1):
            return
        time.sleep(0.05)
    raise SystemExit(f"compare.py: nothing listens on port {port} after 30 s")


def cpu_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def resident_mb(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    raise SystemExit("compare.py: no VmRSS")


@contextlib.contextmanager
def running(command, **options):
    process = subprocess.Popen(list(map(str, command)), **options)
    try:
        yield process
    finally:
        process.terminate()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(15)
        process.kill()
        process.wait()


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else float("nan")


def measured(pid, seconds, wait_until_joined):
    """CPU seconds of the process in the measurement, which starts SETTLE seconds after all have joined."""
    wait_until_joined()
    time.sleep(SETTLE)
    start = cpu_seconds(pid), time.monotonic()
    time.sleep(seconds)
    return (cpu_seconds(pid) - start[0]) / (time.monotonic() - start[1])


def measure_colyseus(clients, seconds, _programs):
    port = free_port()
    with running(["node", HERE / "server.mjs", port], stdout=subprocess.DEVNULL) as server:
        wait_for_port(port)
        probes = min(PROBES, clients)
        groups = [(probes, "decoding")] + ([(clients - probes, "passive")] if clients > probes else [])
        with contextlib.ExitStack() as stack:
            processes = [stack.enter_context(running(["node", HERE / "clients.mjs", port, count, SETTLE, seconds, kind],
                                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True))
                         for count, kind in groups]

            def joined():
                for process in processes:
                    line = process.stderr.readline()
                    if "joined" not in line:
                        raise SystemExit("compare.py: " + line + process.stderr.read())

            cpu = measured(server.pid, seconds, joined)
            memory = resident_mb(server.pid)
            reports = [json.loads(process.communicate(timeout=120)[0]) for process in processes]
        passive = reports[-1]
        if any(report["closed"] for report in reports):
            raise SystemExit("compare.py: Colyseus closed connections")
        ages = reports[0]["ages"]
        rate = passive["states"] / passive["seconds"] / groups[-1][0]
        kbit = passive["bytes"] * 8 / 1000 / passive["seconds"] / groups[-1][0] if clients > probes else float("nan")
        return {"rate": rate, "kbit_per_second": kbit, "age_p50_ms": percentile(ages, 0.5), "age_p99_ms": percentile(ages, 0.99),
                "cpu": cpu, "memory_mb": memory}


def measure_jostle(clients, seconds, programs, websocket):
    grpc, web = free_port(), free_port()
    server = [programs / "jostle-server", "--scene", HERE / "balls.json", "--listen", f"127.0.0.1:{grpc}", "--http",
              f"127.0.0.1:{web}", "--admin", "", "--set", "world.clients_per_address_max=1000", "--set",
              "connection.per_address_max=1000"]
    with tempfile.TemporaryDirectory() as folder, running(server, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        wait_for_port(web)
        report = pathlib.Path(folder) / "report.json"
        load = [programs / "jostle-load", "--passive", "--clients", clients, "--threads", 1, "--settle", SETTLE, "--seconds", seconds,
                "--decode-ratio", max(0.05, min(1, PROBES / clients)), "--server-pid", process.pid, "--json", report, "--server",
                f"127.0.0.1:{web if websocket else grpc}", *(["--websocket"] if websocket else [])]
        with running(load, stdout=subprocess.DEVNULL) as loader:
            # It connects within 1 s and settles; the report has the CPU time of the server.
            time.sleep(1 + SETTLE + seconds)
            memory = resident_mb(process.pid)
            if loader.wait(60) != 0:
                raise SystemExit("compare.py: jostle-load found errors")
        result = json.loads(report.read_text())
        return {"rate": result["snapshots_per_second_per_client"], "kbit_per_second": result["kbit_per_second_per_client"],
                "age_p50_ms": result["age_ms"]["p50"], "age_p99_ms": result["age_ms"]["p99"],
                "cpu": result["server_cpu_percent"] / 100, "memory_mb": memory}


SERVERS = {
    "colyseus": measure_colyseus,
    "jostle websocket": lambda *run: measure_jostle(*run, websocket=True),
    "jostle grpc": lambda *run: measure_jostle(*run, websocket=False),
}
COLUMNS = ("rate", "kbit_per_second", "bytes_per_message", "age_p50_ms", "age_p99_ms", "cpu", "cpu_us_per_message", "memory_mb")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--clients", type=int, nargs="+", default=[20, 100, 400])
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    rows = []
    for _ in range(arguments.rounds):
        alone = {name: measure(1, arguments.seconds, arguments.programs) for name, measure in SERVERS.items()}
        for clients in arguments.clients:
            for name, measure in SERVERS.items():
                row = {"server": name, "clients": clients, **measure(clients, arguments.seconds, arguments.programs)}
                per_update = row["cpu"] / row["rate"] - alone[name]["cpu"] / alone[name]["rate"]
                row["cpu_us_per_message"] = 1e6 * per_update / (clients - 1)
                row["bytes_per_message"] = row["kbit_per_second"] * 125 / row["rate"]
                rows.append(row)
                print(f"{name:17} {clients:4} " + " ".join(f"{key} {row[key]:.2f}" for key in COLUMNS), flush=True)
    print(f"\n{'server':17} {'clients':>7} " + " ".join(f"{column:>18}" for column in COLUMNS))
    for clients in arguments.clients:
        for name in SERVERS:
            same = [row for row in rows if row["server"] == name and row["clients"] == clients]
            print(f"{name:17} {clients:7} " + " ".join(f"{statistics.median(row[key] for row in same):18.2f}" for key in COLUMNS))
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
