#!/usr/bin/env python3
"""Reads every include of our sources and fails, naming both files, when an arrow points up.

Usage: check_layers.py ROOT
The floors are those of docs/architecture.md. A file may include its own floor and those listed for it.
"""

import pathlib
import re
import sys

# What everything may include: how errors are reported.
BASE = "base/include"
# Folder (longest prefix wins) -> floors it may include beside BASE. A floor is named by its folder; "*.pb.h" files are "generated".
PUBLIC = "physics/include"
FLOORS = {
    BASE: [],
    "physics/include": [],
    "physics/src/foundation": [PUBLIC],
    "physics/src/math": [PUBLIC, "physics/src/foundation"],
    "physics/src/geometry": [PUBLIC, "physics/src/foundation", "physics/src/math"],
    "physics/src/collision": [PUBLIC, "physics/src/foundation", "physics/src/math", "physics/src/geometry"],
    "physics/src/constraint_graph": [PUBLIC, "physics/src/foundation", "physics/src/math"],
    "physics/src/state": [PUBLIC, "physics/src/foundation", "physics/src/math", "physics/src/geometry", "physics/src/collision", "physics/src/constraint_graph"],
    "physics/src/constraints": [PUBLIC, "physics/src/foundation", "physics/src/math", "physics/src/geometry", "physics/src/collision", "physics/src/state", "physics/src/constraint_graph"],
    "physics/src/persist": [PUBLIC, "physics/src/foundation", "physics/src/math", "physics/src/geometry", "physics/src/collision", "physics/src/state", "physics/src/constraint_graph"],
    "physics/src/stages": [PUBLIC, "physics/src/foundation", "physics/src/math", "physics/src/geometry", "physics/src/collision", "physics/src/state", "physics/src/constraints", "physics/src/constraint_graph"],
    "physics/src/world": [PUBLIC, "physics/src/foundation", "physics/src/math", "physics/src/geometry", "physics/src/collision", "physics/src/state", "physics/src/constraints", "physics/src/stages", "physics/src/persist", "physics/src/constraint_graph"],
    "physics/examples": [PUBLIC],
    "modules/module_base": [PUBLIC],
    "modules/fields": [PUBLIC, "modules/module_base"],
    "modules/hand": [PUBLIC],
    "modules/character": [PUBLIC, "modules/module_base"],
    "modules/ragdoll": [PUBLIC, "modules/module_base"],
    "modules/ragdoll_gltf": [PUBLIC, "modules/ragdoll"],
    "modules/vehicle": [PUBLIC, "modules/module_base"],
    "modules/destruction": [PUBLIC, "modules/module_base"],
    "proto/wire": [],
    "proto/status": [],
    "proto/datagram": [],
    "scenes/include": [PUBLIC],
    "scenes/src": [PUBLIC, "decomposition", "physics/examples", "modules/module_base", "modules/fields", "modules/character", "modules/ragdoll", "modules/vehicle", "modules/destruction", "scenes/include", "generated"],
    "decomposition": [PUBLIC],
    "convergence": [],
    "linear_systems": [PUBLIC, "convergence"],
    "plots": [],
    "sim": [PUBLIC, "convergence", "linear_systems", "plots", "scenes/include"],
    "convert": [PUBLIC, "decomposition", "modules/destruction", "scenes/include"],
    "server/base": [],
    "server/config": ["server/base"],
    "server/telemetry": ["server/base"],
    "server/identity": ["server/base", "server/config"],
    "server/tls": ["server/base", "server/config"],
    "server/connection": ["server/base", "server/config", "server/telemetry", "server/tls", PUBLIC],
    "server/persistence": ["server/base"],
    "server/datagram": ["server/base", "server/config", "server/telemetry", "proto/datagram"],
    "server/host": ["modules/destruction", "modules/fields", "modules/hand", "modules/module_base", "server/base", "server/telemetry", "server/config", "server/identity", "server/tls", PUBLIC, "scenes/include"],
    "server/durability": ["server/base", "server/telemetry", "server/config", "server/persistence", "server/host", PUBLIC, "scenes/include"],
    "server/session": ["server/base", "server/telemetry", "server/config", "server/identity", "server/tls", "server/host", PUBLIC],
    "server/replication": ["server/base", "server/telemetry", "server/config", "server/identity", "server/tls", "server/host", "server/session", PUBLIC, "proto/wire"],
    "server/protocol": ["server/base", "server/telemetry", "server/config", "server/identity", "server/tls", "server/host", "server/session", "server/replication", "server/datagram", PUBLIC, "proto/wire", "proto/datagram", "scenes/include", "generated"],
    "server/rpc": ["server/base", "server/connection", "server/datagram", "server/telemetry", "server/config", "server/identity", "server/tls", "server/host", "server/session", "server/replication", "server/protocol", "proto/status", "generated"],
    "server/gateway": ["server/base", "server/telemetry", "server/config", "server/identity", "server/tls", "server/host", "server/session", "server/replication", "server/protocol", "generated"],
    "server/app": ["server/base", "server/connection", "server/datagram", "server/telemetry", "server/config", "server/identity", "server/tls", "server/host", "server/durability", "server/persistence", "server/session", "server/replication", "server/protocol", "server/rpc", "server/gateway", "scenes/include", "generated"],
    "server": ["server/base", "server/config", "server/app", "scenes/include"],
    "clients/cpp": ["proto/wire", "proto/datagram", "proto/status", "generated"],
    "clients/predict": ["clients/cpp", "modules/character", "modules/hand", "modules/module_base", "modules/vehicle", "scenes/include", PUBLIC, "proto/wire", "generated"],
    "clients/recording": ["clients/cpp", "proto/wire", "generated"],
    "clients/record": ["clients/cpp", "clients/recording", "clients/flags"],
    "clients/replay": ["clients/cpp", "clients/recording", "clients/ctl", "proto/wire", "generated"],
    "replay": ["clients/replay", "clients/recording", "clients/cpp", "server/durability", "server/persistence", "server/host", "server/base", "scenes/include", PUBLIC],
    "clients/bot": ["clients/cpp", "clients/flags", "generated"],
    "clients/flags": ["clients/cpp"],
    "clients/ctl": ["proto/status", "clients/cpp", "clients/flags", "generated"],
    "clients/relay": [],
    "clients/load": ["clients/cpp", "clients/bot", "clients/flags", "generated"],
}
# Only host/ includes the World; scene.h brings it to those who build worlds.
WORLD = "jostle/physics/world.h"
MAY_INCLUDE_WORLD = ("server/host", "server/durability")
# Only scenes/src/scene_* knows the generated Scene message.
SCENE_MESSAGE_FILES = ("scenes/src/scene_file.cpp", "scenes/src/scene_json.cpp", "scenes/src/field_reader.h",
                       "scenes/src/shape_message.cpp", "scenes/src/joint_message.cpp", "scenes/src/locks_message.cpp",
                       "scenes/src/module_message.cpp", "scenes/src/module_things.cpp")

SEARCH = [BASE, "physics/include", "decomposition/include", "decomposition/src", *sorted(f"{floor}/{part}" for floor in FLOORS if floor.startswith("modules/") for part in ("include", "src")), "physics/src", "physics/examples/hovercraft", "convergence/include", "linear_systems/include", "plots/include", "proto", "scenes/include", "scenes/src", "sim", "convert", "replay", "server", "clients",
          "clients/cpp/include", "clients/cpp/src", "clients/predict/include", "clients/predict/src", "clients/recording/include", "clients/recording/src", "bench"]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.M)


def floor_of(path):
    best = ""
    for folder in FLOORS:
        if (path == folder or path.startswith(folder + "/")) and len(folder) > len(best):
            best = folder
    return best


def resolve(root, including, name):
    """The file of ours that an include names, relative to the root; None for a library's."""
    beside = (root / including).parent / name
    if beside.exists():
        return str(beside.resolve().relative_to(root.resolve()))
    for folder in SEARCH:
        if (root / folder / name).exists():
            return f"{folder}/{name}"
    return None


def faults(root):
    found = []
    files = sorted(p for folder in ("base", "linear_systems", "plots", "physics", "modules", "decomposition", "proto/wire", "proto/datagram", "proto/status", "scenes", "sim", "convert", "server", "clients")
                   for ending in ("h", "cpp") for p in (root / folder).rglob(f"*.{ending}") if "node_modules" not in p.parts)
    for path in files:
        here = str(path.relative_to(root))
        floor = floor_of(here)
        if not floor:
            found.append(f"{here}: stands on no floor that check_layers.py knows")
            continue
        for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
            if name.endswith(".pb.h"):
                if "generated" not in FLOORS[floor]:
                    found.append(f"{here} includes {name}: {floor} may not know generated messages")
                elif floor == "scenes/src" and here not in SCENE_MESSAGE_FILES:
                    found.append(f"{here} includes {name}: only {SCENE_MESSAGE_FILES[0]} knows the message")
                continue
            target = resolve(root, here, name)
            if target is None:
                continue
            other = floor_of(target)
            if other.startswith(("tests", "bench")) or target.startswith(("tests/", "bench/")):
                found.append(f"{here} includes {target}: nothing may include tests")
            elif other not in (floor, BASE) and other not in FLOORS[floor]:
                found.append(f"{here} includes {target}: {floor} may not see {other or 'that'}")
            elif name == WORLD and floor.startswith("server/") and floor not in MAY_INCLUDE_WORLD:
                found.append(f"{here} includes {target}: only {MAY_INCLUDE_WORLD[0]} may include the World")
    return found, len(files)


def main():
    root = pathlib.Path(sys.argv[1])
    found, count = faults(root)
    for fault in found:
        print(fault)
    print(f"layers: {count} files, {len(found)} arrows that point up")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
