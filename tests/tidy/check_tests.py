#!/usr/bin/env python3
"""Tests mirror the solver's sources: fails, naming the file, for every source that no test is known to exercise.

Usage: check_tests.py ROOT
physics/src/state/wake.cpp has tests/physics/state/wake_test.cpp. A header without a .cpp counts if it holds a function body.
What has no test of its own name has a line in COVERED_BY: the tests that exercise it, and why they do. A line is a promise that
somebody looked: what a tool counted as executed is not yet proved.
"""

import pathlib
import re
import sys

SOURCES, TESTS = "physics/src", "tests/physics"

COVERED_BY = {
}

COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"', re.S)
# ") {", ") const {", ") noexcept : member(0) {": where a function's body begins.
BODY = re.compile(r"\)\s*(?:const\s*)?(?:noexcept\s*)?(?:->\s*[^;{}()]+)?(?::[^;{}]*)?\{")


def holds_logic(header):
    return BODY.search(COMMENT_OR_STRING.sub("", header.read_text(encoding="utf-8"))) is not None


def sources(root):
    """Every .cpp, and every header with a function body that has no .cpp."""
    found = sorted((root / SOURCES).rglob("*.cpp"))
    for header in sorted((root / SOURCES).rglob("*.h")):
        if not header.with_suffix(".cpp").exists() and holds_logic(header):
            found.append(header)
    return [str(path.relative_to(root)) for path in found]


def mirror_of(source):
    """physics/src/state/wake.cpp -> tests/physics/state/wake_test.cpp"""
    return TESTS + source.removeprefix(SOURCES).rsplit(".", 1)[0] + "_test.cpp"


def faults(root):
    found, all_sources = [], sources(root)
    mirrored = {source for source in all_sources if (root / mirror_of(source)).exists()}
    for source in all_sources:
        if source not in mirrored and source not in COVERED_BY:
            found.append(f"{source}: no test. Write {mirror_of(source)}, or say in check_tests.py which test exercises it and why")
    named = set()
    for source, (tests, _) in COVERED_BY.items():
        named.update(tests)
        if source in mirrored:
            found.append(f"check_tests.py: {source} has a test of its own now; take its line off COVERED_BY")
        elif source not in all_sources:
            found.append(f"check_tests.py: {source} is gone, or holds no function any more; take its line off COVERED_BY")
        for test in tests:
            if not (root / test).exists():
                found.append(f"check_tests.py: {source} is said to be exercised by {test}, which does not exist")
    lists = "".join(path.read_text(encoding="utf-8") for path in sorted((root / TESTS).rglob("CMakeLists.txt")))
    mirrors = {mirror_of(source) for source in all_sources}
    for path in sorted((root / TESTS).rglob("*_test.cpp")):
        test = str(path.relative_to(root))
        if re.search(rf"\b{re.escape(path.name)}\b", lists) is None:
            found.append(f"{test}: is in no CMakeLists.txt, so nobody runs it")
        if test not in mirrors and test not in named:
            found.append(f"{test}: mirrors no source. Give it the name of what it exercises, or name it in COVERED_BY")
    return found, len(all_sources), len(mirrored)


def main():
    found, count, mirrored = faults(pathlib.Path(sys.argv[1]))
    for fault in found:
        print(fault)
    print(f"tests: {count} sources, {mirrored} with a test of their name, {len(COVERED_BY)} exercised by others, {len(found)} faults")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
