#!/usr/bin/env python3
"""The first line of a commit message is "area: imperative subject" with at most 72 characters (CONTRIBUTING.md).

Usage: check_commit_subject.py MESSAGE_FILE
"""

import pathlib
import re
import sys

COLUMNS = 72
SUBJECT = re.compile(r"[\w.*/, +-]+: [A-Za-z].*[^.\s]")
GENERATED = ("Merge ", "Revert ", "fixup! ", "squash! ")


def fault(subject):
    if subject.startswith(GENERATED):
        return None
    if len(subject) > COLUMNS:
        return f"has {len(subject)} characters; at most {COLUMNS} are allowed"
    if not SUBJECT.fullmatch(subject):
        return 'must have the form "area: imperative subject" without a full stop, such as "server: reject empty world names"'
    return None


def main():
    if len(sys.argv) != 2:
        print(next(line for line in __doc__.splitlines() if line.startswith("Usage")), file=sys.stderr)
        return 2
    lines = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()
    subject = lines[0] if lines else ""
    found = fault(subject)
    if found:
        print(f'commit subject "{subject}" {found}', file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
