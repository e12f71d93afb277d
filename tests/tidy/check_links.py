#!/usr/bin/env python3
"""Every relative link, and every path of ours in `backquotes`, that a document names exists.

Usage: check_links.py ROOT
"""

import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
# A path in backquotes that begins with one of our folders.
PATH = re.compile(r"`((?:base|physics|modules|proto|scenes|server|clients|tools|bench|examples|tests|scripts|docs|cmake|docker|deploy)/[A-Za-z0-9_./-]+)`")


def exists(root, path):
    if (root / path).exists():
        return True
    # `physics/src/state/links.{h,cpp}` and `links` for links.h are how people write.
    return bool(list(root.glob(path + ".*"))) or bool(list(root.glob(path.rstrip("/") + "*")))


def faults(root):
    found, count = [], 0
    skip = ("node_modules", "build", ".git")
    for document in sorted(p for p in root.rglob("*.md") if not any(part in skip for part in p.relative_to(root).parts)):
        count += 1
        text = document.read_text(encoding="utf-8")
        name = document.relative_to(root)
        for target in LINK.findall(text):
            if "://" in target or target.startswith("mailto:"):
                continue
            if not (document.parent / target).exists():
                found.append(f"{name}: the link {target} leads nowhere")
        for path in PATH.findall(text):
            # NAME and TARGET are placeholders.
            if not re.search("NAME|TARGET", path) and not exists(root, path):
                found.append(f"{name}: there is no {path}")
    return found, count


def main():
    found, count = faults(pathlib.Path(sys.argv[1]))
    for fault in found:
        print(fault)
    print(f"links: {count} documents, {len(found)} that lead nowhere")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
