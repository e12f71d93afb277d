#!/usr/bin/env python3
"""Reads every include of the sources and fails, naming both files, if an include points to a higher layer.

Usage: check_layers.py ROOT
LAYERS is the table of docs/design/architecture.md: a file may include its own layer, base and the layers listed for its own.
Public headers are included as jostle/LIBRARY/NAME.h, private headers by their path from the project folder.
"""

import pathlib
import re
import sys

FOLDERS = ("base", "physics", "modules", "scenes", "proto", "server", "clients", "tools", "bench", "examples")
BASE = "base"
PUBLIC = "physics/include"
# The layers of the solver, lowest first: each may include those before it.
PHYSICS = ["physics/src/foundation", "physics/src/math", "physics/src/geometry", "physics/src/collision",
           "physics/src/constraint_graph", "physics/src/state"]
MODULES = ["modules/core", "modules/fields", "modules/character", "modules/particles", "modules/ragdoll", "modules/vehicle",
           "modules/destruction", "modules/crowd", "modules/rope", "modules/cloth"]
SERVER_LOW = ["server/util", "server/config", "server/forwarding", "server/metrics", "server/auth", "server/tls"]
GENERATED = "generated"  # *.pb.h
# Folder (the longest prefix wins) -> layers that it may include besides BASE.
LAYERS = {
    BASE: [],
    PUBLIC: [],
    "physics/src/foundation": [PUBLIC],
    "physics/src/math": [PUBLIC, *PHYSICS[:1]],
    "physics/src/geometry": [PUBLIC, *PHYSICS[:2]],
    "physics/src/collision": [PUBLIC, *PHYSICS[:3]],
    "physics/src/constraint_graph": [PUBLIC, *PHYSICS[:2]],
    "physics/src/state": [PUBLIC, *PHYSICS[:5]],
    "physics/src/constraints": [PUBLIC, *PHYSICS],
    "physics/src/serialization": [PUBLIC, *PHYSICS],
    "physics/src/stages": [PUBLIC, *PHYSICS, "physics/src/constraints"],
    "physics/src/world": [PUBLIC, *PHYSICS, "physics/src/constraints", "physics/src/serialization", "physics/src/stages"],
    "examples": [PUBLIC, "clients/cpp/core", "scenes/include", "server/app", "server/config", "server/util"],
    "examples/hovercraft": [PUBLIC],
    "modules/core": [PUBLIC],
    "modules/convex_decomposition": [PUBLIC],
    "modules/player_interaction": [PUBLIC],
    "modules/fields": [PUBLIC, "modules/core"],
    "modules/character": [PUBLIC, "modules/core"],
    "modules/particles": [PUBLIC, "modules/core"],
    "modules/ragdoll": [PUBLIC, "modules/core"],
    "modules/ragdoll/gltf": [PUBLIC, "modules/ragdoll"],
    "modules/vehicle": [PUBLIC, "modules/core"],
    "modules/destruction": [PUBLIC, "modules/core"],
    "modules/rope": [PUBLIC, "modules/core"],
    "modules/cloth": [PUBLIC, "modules/core"],
    "modules/crowd": [PUBLIC, "modules/core", "modules/character"],
    "proto/snapshot": [],
    "proto/grpc_status": [GENERATED],
    "proto/datagram": [],
    "proto/http2": [],
    "scenes/include": [PUBLIC],
    "scenes/src": [PUBLIC, "scenes/include", "examples/hovercraft", "modules/convex_decomposition", *MODULES, GENERATED],
    "server/util": [],
    "server/config": ["server/util"],
    "server/forwarding": ["server/util"],
    "server/metrics": ["server/util"],
    "server/auth": ["server/util", "server/config"],
    "server/tls": ["server/util", "server/config"],
    "server/grpc_proxy": ["server/util", "server/config", "server/forwarding", "server/metrics", "server/tls", "proto/http2", PUBLIC],
    "server/storage": ["server/util"],
    "server/udp": ["server/util", "server/config", "server/metrics", "proto/datagram"],
    "server/world": [*SERVER_LOW, PUBLIC, "scenes/include", "modules/core", "modules/crowd", "modules/destruction", "modules/fields",
                     "modules/player_interaction"],
    "server/recovery": ["server/util", "server/metrics", "server/config", "server/storage", "server/world", PUBLIC,
                        "scenes/include"],
    "server/limits": [*SERVER_LOW, "server/world", PUBLIC],
    "server/replication": [*SERVER_LOW, "server/world", "server/limits", PUBLIC, "proto/snapshot"],
    "server/messages": ["server/util", "server/config", "server/world", "server/limits", "server/replication", PUBLIC,
                        "proto/snapshot", "proto/datagram", "scenes/include", GENERATED],
    "server/session": [*SERVER_LOW, "server/udp", "server/world", "server/limits", "server/replication", "server/messages",
                       PUBLIC, "proto/snapshot", "proto/datagram", GENERATED],
    "server/services": [*SERVER_LOW, "server/world", "server/limits", "server/replication", "server/messages",
                        "server/session", PUBLIC, "scenes/include", GENERATED],
    "server/grpc": [*SERVER_LOW, "server/grpc_proxy", "server/udp", "server/world", "server/limits", "server/replication",
                    "server/messages", "server/session", "server/services", "proto/grpc_status", GENERATED],
    "server/http": [*SERVER_LOW, "server/world", "server/limits", "server/replication", "server/messages", "server/session",
                    "server/services", "scenes/include", GENERATED],
    "server/grpc_web": [*SERVER_LOW, "server/grpc", "server/http", "server/services", GENERATED],
    "server/app": [*SERVER_LOW, "server/grpc_web", "server/grpc_proxy", "server/udp", "server/world", "server/recovery", "server/storage",
                   "server/limits", "server/replication", "server/messages", "server/session", "server/services",
                   "server/grpc", "server/http", "scenes/include", GENERATED],
    "server": ["server/util", "server/config", "server/app", "scenes/include"],
    "clients/cpp/core": ["proto/snapshot", "proto/datagram", "proto/grpc_status", GENERATED],
    "clients/cpp/cli": ["clients/cpp/core"],
    "clients/cpp/prediction": ["clients/cpp/core", "modules/core", "modules/character", "modules/player_interaction",
                               "modules/vehicle", "scenes/include", PUBLIC, "proto/snapshot", GENERATED],
    "clients/cpp/recording": ["clients/cpp/core", "proto/snapshot", GENERATED],
    "clients/bot": ["clients/cpp/core", "clients/cpp/cli", GENERATED],
    "tools/common": [],
    "tools/analysis": [PUBLIC],
    "tools/network_emulator": ["tools/common"],
    "tools/sim": [PUBLIC, "tools/analysis", "scenes/include"],
    "tools/mesh": [PUBLIC, "modules/convex_decomposition", "modules/destruction", "scenes/include"],
    "tools/record": ["clients/cpp/core", "clients/cpp/cli", "clients/cpp/recording"],
    "tools/replay": [PUBLIC, "tools/common", "clients/cpp/core", "clients/cpp/recording", "proto/snapshot", "scenes/include",
                     "server/util", "server/storage", "server/world", "server/recovery", GENERATED],
    "tools/ctl": ["tools/common", "clients/cpp/core", "clients/cpp/cli", "proto/grpc_status", "scenes/include",
                  "server/storage", GENERATED],
    "tools/load": ["tools/common", "clients/cpp/core", "clients/cpp/cli", "clients/bot", "proto/http2", "proto/snapshot", GENERATED],
    "bench": [PUBLIC, *PHYSICS, "physics/src/constraints", "physics/src/serialization", "physics/src/stages",
              "physics/src/world", *MODULES, "proto/snapshot", "scenes/include", "server/recovery", "server/storage",
              "server/util", "server/world", "tools/analysis", "tools/common", "tools/load", GENERATED],
}
# Only these parts of the server include the World; scene.h provides it to code that builds worlds.
WORLD = "jostle/physics/world.h"
MAY_INCLUDE_WORLD = ("server/world", "server/recovery")
# Only these files of scenes/ know the generated Scene message.
SCENE_MESSAGE_FILES = ("scenes/src/scene_file.cpp", "scenes/src/scene_json.cpp", "scenes/src/field_reader.h",
                       "scenes/src/shape_message.cpp", "scenes/src/joint_message.cpp", "scenes/src/locks_message.cpp",
                       "scenes/src/module_message.cpp", "scenes/src/module_objects.cpp")
# Private headers that one other layer may include.
SHARED = {"clients/cpp/core/src/security.h": "tools/ctl"}  # a gRPC channel with the client's TLS settings and token
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.M)


def layer_of(path):
    best = ""
    for folder in LAYERS:
        if (path == folder or path.startswith(folder + "/")) and len(folder) > len(best):
            best = folder
    return best


def public_headers(root):
    """"jostle/LIBRARY/NAME.h" -> its path from the root."""
    found = {}
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.h")):
            name = str(path.relative_to(root))
            if "/include/jostle/" in name:
                found[name[name.index("/include/jostle/") + len("/include/"):]] = name
    return found


def resolve(root, public, name):
    """The project's file that an include names, relative to the root; None for a library's."""
    if name in public:
        return public[name]
    return name if (root / name).is_file() else None


def sources(root):
    """Every C++ file of the code folders."""
    return sorted(p for folder in FOLDERS for ending in ("h", "cpp") for p in (root / folder).rglob(f"*.{ending}")
                  if "node_modules" not in p.parts)


def faults(root):
    found, files, public = [], sources(root), public_headers(root)
    for path in files:
        here = str(path.relative_to(root))
        layer = layer_of(here)
        if not layer:
            found.append(f"{here}: belongs to no layer of check_layers.py")
            continue
        for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
            if name.endswith(".pb.h"):
                if GENERATED not in LAYERS[layer]:
                    found.append(f"{here} includes {name}: {layer} must not include generated messages")
                elif layer == "scenes/src" and here not in SCENE_MESSAGE_FILES:
                    found.append(f"{here} includes {name}: only {', '.join(SCENE_MESSAGE_FILES)} may")
                continue
            target = resolve(root, public, name)
            if target is None:
                if "/" not in name and name.endswith(".h") and (path.parent / name).is_file() and layer != "examples/hovercraft":
                    found.append(f"{here} includes {name}: include it as {(path.parent / name).relative_to(root)}")
                continue
            other = layer_of(target)
            if target.startswith("tests/") or (other == "bench" and layer != "bench"):
                found.append(f"{here} includes {target}: nothing may include tests or benchmarks")
            elif other not in (layer, BASE) and other not in LAYERS[layer]:
                found.append(f"{here} includes {target}: {layer} must not include {other or 'it'}")
            elif "/src/" in target and layer not in (other, SHARED.get(target)) and not (layer.startswith("physics/") or layer == "bench"):
                found.append(f"{here} includes {target}: it is private to {other}")
            elif name == WORLD and layer.startswith("server/") and layer not in MAY_INCLUDE_WORLD:
                found.append(f"{here} includes {target}: only {' and '.join(MAY_INCLUDE_WORLD)} may include the World")
    return found, len(files)


def main():
    root = pathlib.Path(sys.argv[1])
    found, count = faults(root)
    for fault in found:
        print(fault)
    print(f"layers: {count} files, {len(found)} faults")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
