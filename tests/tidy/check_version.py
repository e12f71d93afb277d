#!/usr/bin/env python3
"""The version is that of project() in CMakeLists.txt; files of other tools that must repeat it agree with it.

Usage: check_version.py ROOT
"""

import pathlib
import re
import sys

# File, pattern of the version in it.
COPIES = (
    ("clients/web/sdk/package.json", r'"version": "([^"]+)"'),
    ("clients/web/viewer/package.json", r'"@jostle/client": "([^"]+)"'),
    ("deploy/kubernetes/base/kustomization.yaml", r"newTag: (\S+)"),
    ("CHANGELOG.md", r"^## \[(\d[^\]]*)\]"),
    ("SECURITY.md", r"Version (\d+\.\d+\.\d+)"),
)


def main():
    if len(sys.argv) != 2:
        print(next(line for line in __doc__.splitlines() if line.startswith("Usage")), file=sys.stderr)
        return 2
    root = pathlib.Path(sys.argv[1])
    found = re.search(r"^project\(jostle VERSION (\S+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"), re.M) \
        if (root / "CMakeLists.txt").exists() else None
    version, bad = found.group(1) if found else "", 0
    for name, pattern in COPIES:
        if not (root / name).exists():
            continue
        copy = re.search(pattern, (root / name).read_text(encoding="utf-8"), re.M)
        if not copy or copy.group(1) != version:
            bad += 1
            print(f"{name}: version {copy.group(1) if copy else 'missing'}; CMakeLists.txt says {version or 'none'}")
    print(f"version: {version}, {bad} files disagree")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
