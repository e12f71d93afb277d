#!/usr/bin/env python3
"""Compiles what the documents show: every C++ snippet of README.md and docs/, and every example, with all warnings as errors.

Usage: check_snippets.py ROOT COMPILER
A snippet is the inside of a function, after the one include that every user of the solver has.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

FLAGS = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror"]
SNIPPET = re.compile(r"^```cpp\n(.*?)^```", re.M | re.S)
FRAME = """#include <cstdio>
#include <jostle/physics/physics.h>
using namespace jostle::physics;
void snippet() {{
#line {line} "{name}"
{code}
}}
"""


def sources(root):
    """(what it is, C++ text) for each snippet and example."""
    for path in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
        text = path.read_text(encoding="utf-8")
        for match in SNIPPET.finditer(text):
            line = text.count("\n", 0, match.start()) + 2
            name = path.relative_to(root)
            yield f"{name}:{line}", FRAME.format(line=line, name=name, code=match.group(1))
    for path in sorted((root / "examples").rglob("*.cpp")):
        yield str(path.relative_to(root)), path.read_text(encoding="utf-8")


def main():
    if len(sys.argv) != 3:
        print(next(line for line in __doc__.splitlines() if line.startswith("Usage")), file=sys.stderr)
        return 2
    root, compiler = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    includes = [f"-I{root / folder}" for folder in ("physics/include", "base/include", "")]
    count, faults = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for name, text in sources(root):
            count += 1
            file = pathlib.Path(folder) / "snippet.cpp"
            file.write_text(text, encoding="utf-8")
            run = subprocess.run([compiler, *FLAGS, *includes, str(file)], capture_output=True, text=True)
            if run.returncode != 0:
                faults += 1
                print(f"{name} does not compile:\n{run.stderr}")
    print(f"snippets: {count}, {faults} that do not compile")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
