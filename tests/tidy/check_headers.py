#!/usr/bin/env python3
"""Each header of ours compiles alone, with the flags of the build.

Usage: check_headers.py ROOT BUILD_FOLDER
Takes include paths and definitions from compile_commands.json of the build. A header that its own .cpp, or any .cpp of the solver,
includes first is not compiled once more where a build of CI compiles that .cpp without precompiled headers (the solver: scripts/determinism-check;
the server below gRPC: the preset tsan), nor where gRPC or Boost take seconds (there the .cpp must include it first).
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

FOLDERS = ("base", "physics", "modules", "proto", "scenes", "server", "clients", "tools", "examples")
COMPILED = ("physics/src", "server/util", "server/config", "server/grpc_proxy", "server/world", "server/replication", "server/limits",
            "server/metrics", "server/tls")
HEAVY = ("server/grpc/", "server/http", "server/messages", "server/services", "server/session", "clients", "tools/ctl", "tools/load")


def flags_of(build):
    """One set of flags that sees every floor: all include paths and definitions of the build."""
    paths, others = [], []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        for i, word in enumerate(words):
            if word.startswith("-I") and word not in paths:
                paths.append(word)
            if word == "-isystem" and f"-isystem{words[i + 1]}" not in paths:
                paths.append(f"-isystem{words[i + 1]}")
            if word.startswith(("-W", "-f", "-std")) and word not in others and "sanitize" not in word:
                others.append(word)
            if word.startswith("-D") and "=" not in word and word not in others:
                others.append(word)
    return paths + [f for f in others if not f.startswith("-W")] + ["-Wall", "-Wextra", "-Werror", "-Wno-psabi", "-Wno-missing-field-initializers"]


def compile_alone(compiler, flags, header):
    source = f'#include "{header}"\n'
    run = subprocess.run([compiler, *flags, "-fsyntax-only", "-xc++", "-"], input=source, capture_output=True, text=True)
    return header, run.returncode, run.stderr


def first_include(path):
    match = re.search(r'^#include "([^"]+)"', path.read_text(encoding="utf-8"), re.M)
    return match.group(1) if match else ""


def main():
    if len(sys.argv) != 3:
        print(next(line for line in __doc__.splitlines() if line.startswith("Usage")), file=sys.stderr)
        return 2
    root, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    compiler = os.environ.get("CXX", "c++")
    flags = flags_of(build)
    headers, sources, bad = [], 0, 0
    firsts = {first_include(source) for source in (root / "physics/src").rglob("*.cpp")}
    for folder in ("base", "physics", "proto/snapshot/include/jostle/snapshot", "proto/grpc_status/include/jostle/grpc_status", "proto/http2/include/jostle/http2", "scenes", "sim", "server", "clients"):
        for path in sorted((root / folder).rglob("*.h")):
            name = str(path.relative_to(root))
            if "node_modules" in name:
                continue
            if name.startswith(HEAVY):
                source = path.with_suffix(".cpp")
                if not source.exists():
                    source = next(iter(root.glob(f"clients/cpp/*/src/{path.stem}.cpp")), source)
                if source.exists() and pathlib.PurePath(first_include(source)).name != path.name:
                    print(f"{source.relative_to(root)}: its first include must be {path.name}, so that the header is known to compile alone")
                    bad += 1
                continue
            source = path.with_suffix(".cpp")
            own_first = name.startswith(COMPILED) and source.exists() and first_include(source).endswith(path.name)
            if own_first or name.removeprefix("physics/include/") in firsts:
                sources += 1
                continue
            headers.append(path)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for header, status, output in pool.map(lambda h: compile_alone(compiler, flags, h), headers):
            if status != 0:
                bad += 1
                print(f"{pathlib.Path(header).relative_to(root)} does not compile alone:\n{output[:1500]}")
    print(f"headers: {len(headers)} compiled alone, {sources} first in their sources, {bad} faults")
    return 1 if bad or not headers or not sources else 0


if __name__ == "__main__":
    sys.exit(main())
