#!/usr/bin/env python3
"""Runs the shell examples of the documents and compares the output that they show.

Usage: run_shell_examples.py ROOT PROGRAMS [PAGE...]     PROGRAMS: folder of the built programs; PAGE: docs/a.md; default: every page
A fence ```sh test is run; all of a page's run one after the other in one shell, which stops at the first command that fails.
A fence ```text output after it shows lines of its output, in order; `...` stands for any text, and a line of `...` for any lines.

A fence ```sh is not run and must be in EXEMPT with the reason.

A page runs in an empty folder that has links to the folders of the project, with the built programs first on PATH and in
build/dev/bin, and in a network of its own (Linux network namespace), so the default ports are free. Background jobs end with the page.
Several pages run beside each other, because their examples mostly wait. Exit status: 0 all examples ran and printed what is shown, 1 not,
77 this machine does not allow network namespaces.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^( *)```(sh test|text output) *\n(.*?)^ *```", re.M | re.S)
BUILDS = "builds for minutes"
PACKAGES = "installs packages"
# (page, first command) of each fence that is not run: why.
EXEMPT = {
    ("README.md", "scripts/run"): BUILDS,
    ("docs/getting_started/run_a_server.md", "scripts/run"): BUILDS,
    ("docs/getting_started/run_a_server.md", "scripts/run --build-only"): BUILDS,
    ("docs/getting_started/run_a_server.md", "cmake --install build/release --prefix $HOME/jostle"): BUILDS,
    ("docs/getting_started/first_scene.md", "cmake --build --preset release --target jostle-sim"): BUILDS,
    ("docs/getting_started/cpp_client.md", "cmake --build --preset release --target jostle-server jostle-cpp-client"): BUILDS,
    ("docs/getting_started/embed_the_solver.md",
     "cmake -S . -B build/solver -DCMAKE_BUILD_TYPE=Release -DJOSTLE_RPC=OFF -DJOSTLE_SERVER=OFF -DJOSTLE_TESTS=OFF"): BUILDS,
    ("docs/getting_started/embed_the_solver.md", "cmake -B build -DCMAKE_BUILD_TYPE=Release"): BUILDS,
    ("docs/getting_started/python_client.md", "sudo apt-get install python3-grpcio protobuf-compiler protobuf-compiler-grpc"): PACKAGES,
    ("docs/guides/operator/proxies.md", "apt-get install nginx-light"): "installs packages and needs a certificate: scripts/proxy-check",
    ("docs/getting_started/typescript_client.md", "cd clients/web"): "npm needs a registry: clients/web/check runs the same commands",
    ("docs/getting_started/typescript_client.md", "node sdk/examples/push_ball.mjs ws://127.0.0.1:8080/play"): "needs Node 22: clients/web/check",
    ("docs/guides/client_developer/typescript.md", "(cd clients/web && npm ci && npm run build:sdk)"): "npm needs a registry: clients/web/check",
    ("docs/design/constraint_systems.md", 'jostle-sim my_scene.json --inspect door --at 120'): "names a scene of the reader's own: tests/tools/sim",
    ("docs/reference/configuration.md", "jostle-server --config my.toml --set client.bodies_owned_max=10"): "names a file of the reader's own",
    ("docs/guides/operator/deploy.md", "docker build -f docker/Dockerfile -t jostle-server ."): "needs Docker: scripts/image-check",
    ("docs/guides/operator/deploy.md", "systemd-sysusers"): "changes the system: scripts/deploy-check checks the unit",
    ("docs/guides/operator/deploy.md", "kubectl apply -k deploy/kubernetes/base"): "needs a cluster: scripts/deploy-check",
    ("docs/guides/operator/deploy.md", """jq -r '.packages[] | select(.name == "libssl3") | .versionInfo, .sourceInfo' sbom.spdx.json"""): "needs jq and an installation: scripts/install-check",
    ("docs/guides/operator/deploy.md", "id=$(docker create jostle-server)"): "needs Docker: scripts/image-check",
    ("docs/guides/operator/rooms.md", "jostlectl room show track"): "names clients of the reader's own: tests/tools/ctl",
    ("docs/guides/operator/secure.md",
     "jostlectl --server play.example.org:50051 --ca ca.pem --cert operator.pem --key operator.key clients"): "a server of the reader: scripts/tls-check",
    ("docs/guides/operator/secure.md",
     """jq -r 'select(.outcome == "refused") | "\\(.address) \\(.reason)"' audit.log | sort | uniq -c | sort -n"""): "needs jq and a log of weeks",
}
SHELL = re.compile(r"^ *```(?:sh|bash|console|shell)[ \t]*\n(.*?)^ *```", re.M | re.S)
PAGE_SECONDS = 240  # most pages take less than 10 s; a busy machine takes several times as long
PAGES_AT_ONCE = 4
SKIPPED = 77
MARK = "=== example of line "
LINKED = ("clients", "deploy", "docs", "examples", "proto", "scenes", "scripts", "server", "tests")


def examples(text):
    """[(line, commands, [lines of shown output])]"""
    found = []
    for match in FENCE.finditer(text):
        indent, kind, body = match.groups()
        body = re.sub(f"^{indent}", "", body, flags=re.M)
        if kind == "sh test":
            found.append((text.count("\n", 0, match.start()) + 1, body, []))
        elif found:
            found[-1][2].extend(body.splitlines())
    return found


def first_command(body):
    return body.splitlines()[0].split("  #")[0].strip()


def not_exempt(root, pages):
    """Faults: fences that are neither run nor in EXEMPT, and entries of EXEMPT that no page has."""
    found, faults = set(), []
    for page in pages:
        text = (root / page).read_text(encoding="utf-8")
        for match in SHELL.finditer(text):
            key = (page, first_command(match[1]))
            found.add(key)
            if key not in EXEMPT:
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{page}:{line}: is not run: make it ```sh test, or give the reason in EXEMPT")
    unused = [key for key in EXEMPT if key[0] in pages and key not in found]
    return faults + [f"run_shell_examples.py: EXEMPT has {command!r}, which {page} does not show" for page, command in unused]


def script_of(found):
    lines = ["set -euo pipefail", "trap 'trap - EXIT; kill $(jobs -p) 2>/dev/null || true; wait' EXIT", "ip link set lo up"]
    for line, commands, _ in found:
        lines += [f'echo "{MARK}{line}"', commands]
    return "\n".join(lines) + "\n"


def outputs(text):
    """Printed lines by the line of the fence."""
    by_line, current = {}, None
    for line in text.splitlines():
        if line.startswith(MARK):
            current = by_line.setdefault(int(line[len(MARK):]), [])
        elif current is not None:
            current.append(line.rstrip())
    return by_line


def missing_line(shown, printed):
    """The first shown line that is not printed after those before it, or None."""
    at = 0
    for line in shown:
        if line.strip() in ("", "..."):
            continue
        pattern = re.compile(".*".join(re.escape(piece) for piece in line.strip().split("...")))
        while at < len(printed) and not pattern.fullmatch(printed[at].strip()):
            at += 1
        if at == len(printed):
            return line
        at += 1
    return None


def prepare(root, programs, folder):
    """Links and programs of the page's folder; the environment."""
    for name in LINKED:
        if (root / name).exists():
            (folder / name).symlink_to(root / name)
    for preset in ("dev", "release"):
        (folder / "build" / preset).mkdir(parents=True)
        (folder / "build" / preset / "bin").symlink_to(programs)
    tools = folder / ".bin"
    tools.mkdir()
    # Debian's Python has the modules that scripts/setup installs; another one may come first on PATH.
    if pathlib.Path("/usr/bin/python3").exists():
        (tools / "python3").symlink_to("/usr/bin/python3")
    environment = {key: value for key, value in os.environ.items() if not key.lower().endswith("_proxy") and not key.startswith("JOSTLE_")}
    return environment | {"PATH": f"{tools}:{programs}:{os.environ['PATH']}", "JOSTLE_BUILD": str(programs.parent),
                          "HOME": str(folder), "CXX": os.environ.get("CXX", "g++")}


def run_page(root, programs, page):
    """Faults of one page as texts, and how many examples it has."""
    found = examples((root / page).read_text(encoding="utf-8"))
    if not found:
        return [], 0
    with tempfile.TemporaryDirectory(prefix="jostle-docs-") as name:
        folder = pathlib.Path(name)
        environment = prepare(root, programs, folder)
        log = folder / ".log"
        with log.open("w") as out:
            run = subprocess.Popen(["unshare", "--net", "bash", "-c", script_of(found)], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=out, stderr=subprocess.STDOUT, start_new_session=True)
            try:
                status = run.wait(PAGE_SECONDS)
            except subprocess.TimeoutExpired:
                status = None
            try:
                os.killpg(run.pid, signal.SIGKILL)  # background jobs that outlive their shell
            except ProcessLookupError:
                pass
            run.wait()
        text = log.read_text(errors="replace")
        server_logs = "".join(f"\n  {file.name}:\n    " + "\n    ".join(file.read_text(errors="replace").splitlines()[-10:])
                              for file in sorted(folder.glob("*.log")) if file != log)
    printed = outputs(text)
    if status != 0:
        failed = max(printed, default=found[0][0])
        reason = f"exit status {status}" if status is not None else f"still running after {PAGE_SECONDS} s"
        tail = "\n    ".join(printed.get(failed, text.splitlines())[-30:])
        return [f"{page}:{failed}: the example failed with {reason}; it printed:\n    {tail}{server_logs}"], len(found)
    faults = []
    for line, _, shown in found:
        missing = missing_line(shown, printed.get(line, []))
        if missing is not None:
            tail = "\n    ".join(printed.get(line, [])[-40:])
            faults.append(f"{page}:{line}: the example does not print \"{missing.strip()}\"; it printed:\n    {tail}")
    return faults, len(found)


def main():
    if len(sys.argv) < 3:
        print(next(line for line in __doc__.splitlines() if line.startswith("Usage")), file=sys.stderr)
        return 2
    root, programs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    if shutil.which("unshare") is None or subprocess.run(["unshare", "--net", "true"], capture_output=True).returncode != 0:
        print("skipped: this machine does not allow network namespaces (unshare --net)")
        return SKIPPED
    pages = sys.argv[3:] or [page.relative_to(root).as_posix() for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]]
    stated = not_exempt(root, pages)
    for fault in stated:
        print(fault)
    count, failed = 0, len(stated)
    with concurrent.futures.ThreadPoolExecutor(PAGES_AT_ONCE) as pool:
        for faults, examples_count in pool.map(lambda page: run_page(root, programs, page), pages):
            count += examples_count
            failed += len(faults)
            for fault in faults:
                print(fault)
    print(f"shell examples: {count} run, {failed} faults")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
