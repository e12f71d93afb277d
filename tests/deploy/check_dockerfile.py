#!/usr/bin/env python3
"""Fails, naming the line, when the Dockerfile makes an image with more in it than one program, or one that runs as root.

Usage: check_dockerfile.py DOCKERFILE    also puts faults into a copy, one at a time, and fails when one is not found
"""

import pathlib
import re
import sys

BASES = ("debian:bookworm-slim", "scratch")
TARGETS = ("server", "bot", "load")
NOBODY = "65532:65532"
HEALTHCHECK = 'CMD ["/bin/jostle-server", "--health"]'


def instructions(text):
    """(number of the first line, instruction, the rest) of each; continued lines are joined, comments are left out."""
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
    """Name -> (line, base, its instructions), in order."""
    found = {}
    for line, word, rest in instructions(text):
        if word == "FROM":
            match = re.fullmatch(r"(\S+) AS (\S+)", rest)
            if not match:
                raise ValueError(f"line {line}: FROM {rest}: a stage without a name")
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
    found, seen = [], []
    for name, (line, base, steps) in all_stages.items():
        if base not in BASES and base not in seen:
            found.append(f"line {line}: {base} is neither one of {', '.join(BASES)} nor an earlier stage")
        seen.append(name)
        for number, word, rest in steps:
            if word == "ADD":
                found.append(f"line {number}: ADD fetches and unpacks what it is given; COPY does not")
            if word == "RUN" and re.search(r"\b(curl|wget|sudo)\b|apt-get upgrade|install (?!.*--no-install-recommends)\S+", rest):
                found.append(f"line {number}: downloads, or installs more than is needed")
            if base == "scratch" and word in ("RUN", "SHELL"):
                found.append(f"line {number}: there is no shell in {name}")
            if base == "scratch" and word == "COPY" and not rest.startswith("--from="):
                found.append(f"line {number}: {name} takes what was built, not what lies here")
    for target in TARGETS:
        if target not in all_stages:
            found.append(f"there is no target {target}")
            continue
        line, base, steps = all_stages[target]
        said = {word: rest for _, word, rest in steps}
        if base != "scratch":
            found.append(f"line {line}: {target} begins with {base}, not with nothing")
        if said.get("USER") != NOBODY:
            found.append(f"line {line}: {target} does not run as {NOBODY}")
        if not re.fullmatch(r'\["/bin/jostle-\w+"\]', said.get("ENTRYPOINT", "")):
            found.append(f"line {line}: {target} does not start its program without a shell")
    if not any(w == "HEALTHCHECK" and r.endswith(HEALTHCHECK) for _, w, r in all_stages.get("server", (0, "", []))[2]):
        found.append(f"server has no HEALTHCHECK {HEALTHCHECK}")
    return found


# What is changed into what, and what must be said then.
SPOILED = [
    ("debian:bookworm-slim", "debian:latest", "neither one of"),
    (" AS tools", "", "without a name"),
    ("COPY . .", "ADD . .", "ADD fetches"),
    ("apt-get update -qq", "apt-get update -qq && apt-get install vim", "installs more"),
    ("FROM scratch AS bot", "FROM debian:bookworm-slim AS bot", "bot begins with debian"),
    ("FROM scratch AS load", "FROM scratch AS crowd", "no target load"),
    ("COPY --from=build /image/bot /", "COPY clients /", "not what lies here"),
    ("COPY --from=build /image/bot /", "RUN true", "no shell in bot"),
    (f"USER {NOBODY}", "USER root", "does not run as"),
    ('ENTRYPOINT ["/bin/jostle-load"]', "ENTRYPOINT /bin/jostle-load", "without a shell"),
    ('"--health"', '"--help"', "no HEALTHCHECK"),
]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    found = faults(text)
    for old, new, wanted in SPOILED:
        if old not in text:
            found.append(f"check_dockerfile.py: nothing to spoil: {old} is not there any more")
        elif not any(wanted in fault for fault in faults(text.replace(old, new, 1))):
            found.append(f"check_dockerfile.py: {new} is not found out")
    for fault in found:
        print(fault)
    print(f"dockerfile: {len(stages(text)) if not found else '?'} stages, {len(SPOILED)} spoiled copies, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
