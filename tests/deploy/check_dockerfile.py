#!/usr/bin/env python3
"""Check the Dockerfile and name the line of each fault: images with more than one program, or a program that runs as root.

Usage: check_dockerfile.py DOCKERFILE    also checks that each of several faulty copies is rejected
"""

import pathlib
import re
import sys

BASES = ("debian:bookworm-slim", "scratch")
TARGETS = ("server", "bot", "load")
NOBODY = "65532:65532"
HEALTHCHECK = 'CMD ["/bin/jostle-server", "--health"]'


def instructions(text):
    """(first line number, instruction, arguments) of each instruction. Joins continued lines and omits comments."""
    found, started, rest = [], None, ""
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("#") or (not line.strip() and started is None):
            continue
        started = started or number
        rest += line.rstrip("\\").strip() + " "
        if not line.endswith("\\"):
            word, _, arguments = rest.strip().partition(" ")
            found.append((started, word.upper(), arguments.strip()))
            started, rest = None, ""
    return found


def stages(text):
    """Name -> (line, base, instructions), in order."""
    found = {}
    for line, word, rest in instructions(text):
        if word == "FROM":
            match = re.fullmatch(r"(\S+) AS (\S+)", rest)
            if not match:
                raise ValueError(f"line {line}: FROM {rest}: the stage has no name")
            found[match[2]] = (line, match[1], [])
            current = found[match[2]][2]
        else:
            current.append((line, word, rest))
    return found


def faults(text):
    try:
        all_stages = stages(text)
    except ValueError as error:
        return [str(error)]
    found, earlier = [], []
    for name, (line, base, steps) in all_stages.items():
        if base not in BASES and base not in earlier:
            found.append(f"line {line}: {base} is neither one of {', '.join(BASES)} nor an earlier stage")
        earlier.append(name)
        for number, word, rest in steps:
            if word == "ADD":
                found.append(f"line {number}: ADD downloads and unpacks files; use COPY")
            if word == "RUN" and re.search(r"\b(curl|wget|sudo)\b|apt-get upgrade|install (?!.*--no-install-recommends)\S+", rest):
                found.append(f"line {number}: downloads files or installs recommended packages")
            if base == "scratch" and word in ("RUN", "SHELL"):
                found.append(f"line {number}: {name} has no shell")
            if base == "scratch" and word == "COPY" and not rest.startswith("--from="):
                found.append(f"line {number}: {name} must copy from a build stage, not from the context")
    for target in TARGETS:
        if target not in all_stages:
            found.append(f"the target {target} is missing")
            continue
        line, base, steps = all_stages[target]
        last = {word: rest for _, word, rest in steps}
        if base != "scratch":
            found.append(f"line {line}: {target} is based on {base}, not on scratch")
        if last.get("USER") != NOBODY:
            found.append(f"line {line}: {target} does not run as {NOBODY}")
        if not re.fullmatch(r'\["/bin/jostle-\w+"\]', last.get("ENTRYPOINT", "")):
            found.append(f"line {line}: the entry point of {target} does not start its program directly")
    if not any(w == "HEALTHCHECK" and r.endswith(HEALTHCHECK) for _, w, r in all_stages.get("server", (0, "", []))[2]):
        found.append(f"the server has no HEALTHCHECK {HEALTHCHECK}")
    return found


# (text, its faulty replacement, part of the expected fault)
FAULTY_COPIES = [
    ("debian:bookworm-slim", "debian:latest", "neither one of"),
    (" AS tools", "", "has no name"),
    ("COPY . .", "ADD . .", "ADD downloads"),
    ("apt-get update -qq", "apt-get update -qq && apt-get install vim", "installs recommended"),
    ("FROM scratch AS bot", "FROM debian:bookworm-slim AS bot", "bot is based on debian"),
    ("FROM scratch AS load", "FROM scratch AS other", "target load is missing"),
    ("COPY --from=build /image/bot /", "COPY clients /", "not from the context"),
    ("COPY --from=build /image/bot /", "RUN true", "bot has no shell"),
    (f"USER {NOBODY}", "USER root", "does not run as"),
    ('ENTRYPOINT ["/bin/jostle-load"]', "ENTRYPOINT /bin/jostle-load", "does not start its program directly"),
    ('"--health"', '"--help"', "no HEALTHCHECK"),
]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    found = faults(text)
    for old, new, expected in FAULTY_COPIES:
        if old not in text:
            found.append(f"check_dockerfile.py: the Dockerfile does not contain {old}, so the fault cannot be tested")
        elif not any(expected in fault for fault in faults(text.replace(old, new, 1))):
            found.append(f"check_dockerfile.py: {new} is not detected")
    for fault in found:
        print(fault)
    print(f"dockerfile: {len(stages(text)) if not found else '?'} stages, {len(FAULTY_COPIES)} faulty copies, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
