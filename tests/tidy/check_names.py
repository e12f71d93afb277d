#!/usr/bin/env python3
"""File names, first lines and words that must not be in the project.

Usage: check_names.py ROOT
Sources are snake_case and open with their licence; no file holds a path of somebody's machine.
"""

import pathlib
import re
import subprocess
import sys

SPDX = "// SPDX-License-Identifier: MIT"
SNAKE = re.compile(r"^[a-z0-9_]+(\.test)?\.(h|cpp|ts|py|proto)$")
FORBIDDEN = [re.compile(p) for p in (r"/home/[a-z]", r"/root/", r"/work/", r"/Users/")]
TEXT = (".h", ".cpp", ".ts", ".py", ".md", ".cmake", ".proto", ".toml", ".json", ".mjs", ".bots", ".txt", "")


def tracked(root):
    try:
        listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"], capture_output=True,
                                text=True, check=True).stdout.split("\n")
        return [p for p in listed if p and (root / p).is_file()]
    except (OSError, subprocess.CalledProcessError):
        return [str(p.relative_to(root)) for p in root.rglob("*") if p.is_file()]


def faults(root):
    found = []
    files = tracked(root)
    for name in files:
        path = root / name
        generated = "/gen/" in name or "/dist/" in name
        if path.suffix in (".h", ".cpp") and not path.read_text(encoding="utf-8").startswith(SPDX):
            found.append(f"{name}: does not begin with {SPDX}")
        if path.suffix in (".h", ".cpp", ".ts", ".py", ".proto") and not generated:
            if not SNAKE.match(path.name) and path.name != "vite.config.ts":
                found.append(f"{name}: file names are snake_case")
        if path.suffix in TEXT and not generated and path.name not in ("package-lock.json", "check_names.py"):
            text = path.read_text(encoding="utf-8", errors="replace")
            for pattern in FORBIDDEN:
                hit = pattern.search(text)
                if hit:
                    line = text.count("\n", 0, hit.start()) + 1
                    found.append(f"{name}:{line}: a path of somebody's machine: {hit.group(0)}...")
    return found, len(files)


def main():
    found, count = faults(pathlib.Path(sys.argv[1]))
    for fault in found:
        print(fault)
    print(f"names: {count} files, {len(found)} faults")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
