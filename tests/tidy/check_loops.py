#!/usr/bin/env python3
"""No two of our files need each other: fails, naming the files, for every loop of includes.

Usage: check_loops.py ROOT
A header and its source are one file here (x.h and x.cpp), and each include is an arrow. Files that form a loop can only be
understood, tested and moved together: they want to be one file, or three.
"""

import pathlib
import re
import sys

from check_layers import INCLUDE, public_headers, resolve, sources

# Where a header and its source are counted as one though they stand in two folders.
PUBLIC = re.compile(r"^(clients/cpp/core|proto/\w+)/include/jostle/\w+/(?=\w+$)")
# Loops that are being removed; each is the set of its files. Nothing may be added.
KNOWN = []


def pair_of(path):
    """The name that a header shares with its source: LIBRARY/include/jostle/X/NAME.h and LIBRARY/src/NAME.cpp are one."""
    return PUBLIC.sub(r"\1/src/", str(pathlib.PurePath(path).with_suffix("")))


def arrows(root):
    """Each pair of files -> the pairs that it includes."""
    graph, public = {}, public_headers(root)
    for path in sources(root):
        here = str(path.relative_to(root))
        targets = (resolve(root, public, name) for name in INCLUDE.findall(path.read_text(encoding="utf-8")))
        graph.setdefault(pair_of(here), set()).update(pair_of(t) for t in targets if t)
    return {pair: sorted(others - {pair}) for pair, others in sorted(graph.items())}


def loops(graph):
    """The sets of pairs that reach each other (Tarjan's strongly connected components, without recursion)."""
    found, order, low, stack, on_stack = [], {}, {}, [], set()
    for start in graph:
        work = [(start, iter(graph[start]))] if start not in order else []
        while work:
            pair, rest = work[-1]
            if pair not in order:
                order[pair] = low[pair] = len(order)
                stack.append(pair)
                on_stack.add(pair)
            for other in rest:
                if other not in order and other in graph:
                    work.append((other, iter(graph[other])))
                    break
                if other in on_stack:
                    low[pair] = min(low[pair], order[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[pair])
                if low[pair] == order[pair]:
                    members = stack[stack.index(pair):]
                    del stack[stack.index(pair):]
                    on_stack.difference_update(members)
                    if len(members) > 1:
                        found.append(sorted(members))
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    graph = arrows(root)
    bad = 0
    found = loops(graph)
    for members in KNOWN:
        if sorted(members) not in found and members <= graph.keys():
            print(f"no loop any more, take it off KNOWN: {', '.join(sorted(members))}")
    for members in found:
        if set(members) in KNOWN:
            continue
        bad += 1
        print(f"{len(members)} files need each other: {', '.join(members)}")
        for pair in members:
            print(f"  {pair} includes {', '.join(other for other in graph[pair] if other in members)}")
    print(f"loops: {len(graph)} files, {bad} loops")
    return 1 if bad or not graph else 0


if __name__ == "__main__":
    sys.exit(main())
