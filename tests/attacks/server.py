"""The server under attack, with free ports and two worlds. A thread monitors its memory; SIGTERM stops it."""

import collections
import http.client
import json
import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import threading
import time

from . import messages
from .http2 import call
from .net import PROBE, SERVER
from .player import TRANSPORTS, Player
from .protobuf import field

Ports = collections.namedtuple("Ports", "grpc http")

DRAIN_SECONDS = 2
CLIENT_TIMEOUT_SECONDS = 10
SOFT_FILES = 1024  # the usual soft limit of a login or a systemd unit
RSS_KILL_MB = 3000  # limit for the whole server process, MB

# The default target of attacks: 100 boxes on a floor.
DEFAULT_TARGET = {"name": "target", "bodies": [
    {"name": "floor", "type": "BODY_TYPE_STATIC", "shapes": [{"plane": {}}]},
    {"name": "box", "position": {"x": -10, "y": 0.5, "z": -10}, "shapes": [{"box": {"half_extents": {"x": 0.5, "y": 0.5, "z": 0.5}}}],
     "repeat": [{"count": 10, "offset": {"x": 2}}, {"count": 10, "offset": {"z": 2}}]}]}


class Server:
    """`output` of standard output and error: "file"; "unread", a pipe that nobody reads; "closed", a pipe whose reader closes
    when the attack starts. All settings that are not written here have their defaults."""

    def __init__(self, binary, target=None, output="file", settings="", log_level="info"):
        self.folder = tempfile.TemporaryDirectory(prefix="jostle-attack-")
        folder = pathlib.Path(self.folder.name)
        (folder / "target.json").write_text(json.dumps(target or DEFAULT_TARGET))
        (folder / "server.toml").write_text(
            f'listen = "{SERVER}:0"\nhttp = "{SERVER}:0"\nscenes = ["sandbox", "{folder}/target.json"]\n'
            f'drain_timeout_seconds = {DRAIN_SECONDS}\nlog_level = "{log_level}"\n{settings}\n')
        self.log_path, self.max_rss_mb, self.max_threads, self.killed = folder / "log", 0.0, 0, False
        log = open(self.log_path, "wb")
        self.reader, out = None, log
        if output != "file":
            # A separate process holds the read end: all forked processes would inherit an end held
            # by this process.
            end, out = os.pipe()
            self.reader = subprocess.Popen(["sleep", "600"], stdin=end)
            os.close(end)
        hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
        self.process = subprocess.Popen(
            [binary, "--config", folder / "server.toml", "--port-file", folder / "ports.json"], stdout=out, stderr=out,
            stdin=subprocess.DEVNULL, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (SOFT_FILES, hard)))
        log.close()
        if self.reader:
            os.close(out)
        self.closes_output = output == "closed"
        self.ports = self._wait_for_ports(folder / "ports.json")
        self.monitor = threading.Thread(target=self._monitor_memory, daemon=True)
        self.monitor.start()

    def _wait_for_ports(self, path):
        for _ in range(600):
            if path.exists():
                found = json.loads(path.read_text())
                return Ports(found["grpc"], found["http"])
            if self.process.poll() is not None:
                break
            time.sleep(0.05)
        self.kill()
        raise RuntimeError(f"the server did not start:\n{self.log_text()[-2000:]}")

    def _monitor_memory(self):
        while self.process.poll() is None:
            try:
                status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
            except OSError:
                return
            values = dict(line.split(":", 1) for line in status.splitlines())
            if "VmHWM" in values:
                self.max_rss_mb = max(self.max_rss_mb, int(values["VmHWM"].split()[0]) / 1024)
                self.max_threads = max(self.max_threads, int(values["Threads"]))
                if int(values["VmRSS"].split()[0]) / 1024 > RSS_KILL_MB:
                    self.killed = True
                    self.process.kill()
            time.sleep(0.05)

    def begin_attack(self):
        if self.closes_output:
            self._end_reader()

    def _end_reader(self):
        if self.reader:
            self.reader.kill()
            self.reader.wait()

    @property
    def pid(self):
        return self.process.pid

    def alive(self):
        return self.process.poll() is None

    def cpu_seconds(self):
        return cpu_seconds(self.pid)

    def log_text(self):
        return self.log_path.read_bytes().decode("utf-8", "replace")

    def shutdown(self, patience):
        """Send SIGTERM. Return (seconds until the exit, exit status), or (None, None) if the server had to be killed."""
        began = time.monotonic()
        self.process.send_signal(signal.SIGTERM)
        try:
            status = self.process.wait(patience)
        except subprocess.TimeoutExpired:
            self.kill()
            return None, None
        return time.monotonic() - began, status

    def kill(self):
        if self.alive():
            self.process.kill()
            self.process.wait()

    def close(self):
        self.kill()
        self._end_reader()
        self.folder.cleanup()


def cpu_seconds(pid):
    try:
        parts = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return (int(parts[11]) + int(parts[12])) / os.sysconf("SC_CLK_TCK")
    except OSError:
        return 0.0


# --- checks that the server still works ---

def http_answers(ports, path="/healthz", seconds=1.0, source=PROBE):
    """(whether the server returned 200 in time, description)."""
    began = time.monotonic()
    try:
        connection = http.client.HTTPConnection(SERVER, ports.http, timeout=seconds, source_address=(source, 0))
        connection.request("GET", path)
        status = connection.getresponse().status
        connection.close()
    except (OSError, http.client.HTTPException) as error:
        return False, f"{path}: {type(error).__name__} {error} after {time.monotonic() - began:.2f} s"
    took = time.monotonic() - began
    return status == 200 and took <= seconds, f"{path}: {status} in {took:.2f} s"


def grpc_answers(ports, seconds=2.0, source=PROBE):
    began = time.monotonic()
    status, message, response = call(ports.grpc, messages.HEALTH, timeout=seconds, source=source)
    serving = status == 0 and field(response, 1, 0) == 1
    return serving, f"gRPC health: {'serving' if serving else f'{status} {message}'} in {time.monotonic() - began:.2f} s"


def new_player_joins(ports, world="sandbox", seconds=3.0):
    """Whether a new player of each transport receives a snapshot in time."""
    for transport in TRANSPORTS:
        began = time.monotonic()
        try:
            player = Player(ports, transport, PROBE, world, name="newcomer")
            joined = player.until(messages.SNAPSHOT, seconds)
            why = player.notice or "no snapshot"
            player.close()
        except Exception as error:  # after any error the player did not join
            joined, why = False, f"{type(error).__name__} {error}"
        if not joined:
            return False, f"a new player ({transport}) cannot join: {why} after {time.monotonic() - began:.1f} s"
    return True, "new players join"
