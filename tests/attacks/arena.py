"""One attack from start to verdict: a fresh server, two honest players, the attack in its own process group, and the checks.

An attack is a function that takes an Arena and is registered by @attack. It attacks and reports with `arena.check` (a
requirement) and `arena.note` (a figure for the reader). The requirements that all attacks share are checked here.
"""

import collections
import dataclasses
import multiprocessing
import os
import pathlib
import resource
import signal
import sys
import time
import traceback

from .net import Closed
from .player import TRANSPORTS, HonestPlayer
from .server import DRAIN_SECONDS, Server, cpu_seconds, grpc_answers, http_answers, new_player_joins

MESSAGES_MIN = 50  # messages per second to each honest player, in the worst full second; the server sends one per tick
RSS_MAX_MB = 300
SHUTDOWN_MAX = DRAIN_SECONDS + 3
WARM_UP = 1.5  # s during which the honest players play before the attack starts
MEASURED_SECONDS_MIN = 3  # s, even if the attack was shorter
TIMEOUT = 15  # s beyond its own duration before an attack is killed
# niceness of attackers: they stand for other machines and must not starve the server through the
# scheduler
NICE = 10

CONTEXT = multiprocessing.get_context("fork")
ATTACKS = {}


@dataclasses.dataclass
class Attack:
    name: str
    run: object
    seconds: float  # intended duration, s
    options: dict  # for Server
    starves: bool  # the honest players may miss messages but must stay connected

    @property
    def description(self):
        return " ".join(self.run.__doc__.split())


def attack(name, seconds=8, starves=False, **options):
    def register(function):
        ATTACKS[name] = Attack(name, function, seconds, options, starves)
        return function
    return register


class Arena:
    """The argument of an attack. It exists in the process of the attack."""

    def __init__(self, spec, server, pipe):
        self.ports, self.server_pid, self.log_path = server.ports, server.pid, server.log_path
        self.seconds, self.pipe = spec.seconds, pipe

    def begin(self):
        """Start the measurement here instead of at the start of the attack, which was preparation."""
        self.pipe.send(("begin", time.monotonic()))

    def check(self, holds, what):
        self.pipe.send(("check", bool(holds), what))

    def note(self, what):
        self.pipe.send(("note", what))

    def fork(self, count, function, *arguments, patience=TIMEOUT):
        """Run function(i, *arguments) in `count` processes at once. Return their results; None for a failed or late process."""
        pipes = []
        for i in range(count):
            ours, theirs = CONTEXT.Pipe(duplex=False)
            process = CONTEXT.Process(target=_call, args=(theirs, function, i, arguments), daemon=True)
            process.start()
            theirs.close()
            pipes.append((process, ours))
        until, results = time.monotonic() + self.seconds + patience, []
        for process, pipe in pipes:
            try:
                results.append(pipe.recv() if pipe.poll(max(0, until - time.monotonic())) else None)
            except EOFError:
                results.append(None)
            process.join(0.5)
            if process.is_alive():
                process.kill()
                process.join()
        return results

    def server_rss_mb(self):
        for line in pathlib.Path(f"/proc/{self.server_pid}/status").read_text().splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) / 1024
        return 0.0

    def server_log(self):
        return self.log_path.read_bytes()


def _call(pipe, function, i, arguments):
    try:
        pipe.send(function(i, *arguments))
    except (OSError, Closed):
        pass  # The server cut the connection, which is not a failure of the attack.
    except Exception:
        traceback.print_exc()


def _attack_process(spec, server, pipe):
    os.setsid()
    os.nice(NICE)
    hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
    try:
        spec.run(Arena(spec, server, pipe))
    except Exception as error:
        pipe.send(("failed", f"{type(error).__name__}: {error}", traceback.format_exc()))
    pipe.send(("done",))


@dataclasses.dataclass
class Verdict:
    name: str
    seconds: float = 0
    rates: dict = dataclasses.field(default_factory=dict)  # transport -> [worst, mean]
    rss_mb: float = 0
    threads: int = 0
    shutdown_seconds: float | None = None
    others_cpu: float = 0  # cores used by neither server nor attack
    faults: list = dataclasses.field(default_factory=list)
    notes: list = dataclasses.field(default_factory=list)

    @property
    def ok(self):
        return not self.faults

    def require(self, holds, fault):
        if not holds:
            self.faults.append(fault)


def run(spec, binary):
    verdict, server, honest = Verdict(spec.name), None, []
    try:
        server = Server(binary, **spec.options)
        honest = [HonestPlayer(server.ports, transport, "sandbox") for transport in TRANSPORTS]
        time.sleep(WARM_UP)
        _attack(spec, server, honest, verdict)
        _check_health(server, verdict)
        _check_shutdown(server, verdict)
        verdict.rss_mb, verdict.threads = server.max_rss_mb, server.max_threads
        verdict.require(verdict.rss_mb < RSS_MAX_MB,
                        f"{verdict.rss_mb:.0f} MB of resident memory" + ("; killed by the test" if server.killed else ""))
    except RuntimeError as error:
        verdict.faults.append(str(error))
    finally:
        for player in honest:
            player.stop()
        if server:
            server.close()
    return verdict


def _attack(spec, server, honest, verdict):
    busy = _CpuMonitor(server, honest)
    server.begin_attack()
    ours, theirs = CONTEXT.Pipe()
    began = time.monotonic()
    process = CONTEXT.Process(target=_attack_process, args=(spec, server, theirs))
    process.start()
    theirs.close()
    try:
        began = _listen(spec, ours, began, verdict)
    finally:
        _end_group(process)
    time.sleep(max(0.0, began + MEASURED_SECONDS_MIN - time.monotonic()))
    ended = time.monotonic()
    verdict.seconds = ended - began
    verdict.others_cpu = busy.others()
    for player in honest:
        _check_honest_player(spec, player, began, ended, verdict)


def _listen(spec, pipe, began, verdict):
    """Collect the reports of the attack until it is done. Return the start time of the measurement."""
    until = began + spec.seconds + TIMEOUT
    while True:
        if not pipe.poll(max(0, until - time.monotonic())):
            verdict.notes.append("the attack was stopped at its time limit")
            return began
        try:
            kind, *what = pipe.recv()
        except EOFError:
            return began
        if kind == "begin":
            began = what[0]
            until = began + spec.seconds + TIMEOUT
        elif kind == "check":
            (verdict.notes if what[0] else verdict.faults).append(what[1])
        elif kind == "note":
            verdict.notes.append(what[0])
        elif kind == "failed":
            verdict.faults.append(f"the attack itself failed: {what[0]}")
            sys.stderr.write(what[1])
        elif kind == "done":
            return began


def _end_group(process):
    """Kill the attack and all processes that it forked."""
    process.join(1)
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.join()


def _check_honest_player(spec, player, began, ended, verdict):
    report = player.report()
    if report is None:
        return verdict.faults.append(f"the honest player ({player.transport}) does not respond")
    seconds = max(1, int(ended - began))
    counts = collections.Counter(int(at - began) for at in report["times"] if began <= at < began + seconds)
    per_second = [counts[k] for k in range(seconds)]
    worst, mean = min(per_second), sum(per_second) / seconds
    verdict.rates[player.transport] = [worst, round(mean, 1)]
    verdict.require(report["ended"] is None, f"the honest player ({player.transport}) was disconnected: {report['ended']}")
    if not spec.starves:
        verdict.require(worst >= MESSAGES_MIN,
                        f"only {worst} messages in second {per_second.index(worst) + 1} of {seconds} ({player.transport})")
    # The server may not have applied the last input yet.
    verdict.require(report["applied"] >= report["sent"] - 2,
                    f"{report['sent'] - report['applied']} of {report['sent']} honest inputs were not applied ({player.transport})")


def _check_health(server, verdict):
    if not server.alive():
        if not server.killed:
            verdict.faults.append(f"the server exited with status {server.process.returncode}")
        return
    for holds, what in (http_answers(server.ports), http_answers(server.ports, "/readyz"), grpc_answers(server.ports),
                        new_player_joins(server.ports)):
        verdict.require(holds, what)


def _check_shutdown(server, verdict):
    if not server.alive():
        return
    took, status = server.shutdown(SHUTDOWN_MAX + 5)
    if server.killed:
        return
    verdict.shutdown_seconds = took
    verdict.require(took is not None, f"the server did not exit within {SHUTDOWN_MAX + 5} s of SIGTERM")
    if took is not None:
        verdict.require(took <= SHUTDOWN_MAX, f"the server took {took:.1f} s to exit after SIGTERM; at most {SHUTDOWN_MAX} s are allowed")
        verdict.require(status == 0, f"exit status {status} after SIGTERM; expected 0")


class _CpuMonitor:
    """Cores used by unrelated processes meanwhile, to decide whether the server caused a slow second."""

    def __init__(self, server, honest):
        self.pids = [server.pid] + [player.process.pid for player in honest]
        self.began, self.start_cpu = time.monotonic(), self._total() - self._ours()

    def _total(self):
        user, nice, system, _, _, irq, soft, *_ = map(int, pathlib.Path("/proc/stat").read_text().split("\n")[0].split()[1:])
        return (user + nice + system + irq + soft) / os.sysconf("SC_CLK_TCK")

    def _ours(self):
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        own = resource.getrusage(resource.RUSAGE_SELF)
        return (sum(map(cpu_seconds, self.pids)) + children.ru_utime + children.ru_stime + own.ru_utime + own.ru_stime)

    def others(self):
        return max(0.0, (self._total() - self._ours() - self.start_cpu) / (time.monotonic() - self.began))
