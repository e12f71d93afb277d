#!/usr/bin/env python3
"""Compiles the C++ that the documents show: every ```cpp fence of README.md and docs/, with all warnings as errors.

Usage: check_snippets.py ROOT COMPILER [BUILD]
A fence names its frame after the language:
    ```cpp               inside a function, after <jostle/physics/physics.h>
    ```cpp world         the same, with a World `world`, bodies `body`, `door`, `ball` and a joint `hinge`: parts of a longer program
    ```cpp declarations  at namespace scope, after the same header
    ```cpp modules       inside a function, after the headers of the modules as well
    ```cpp client        inside a function, after the headers of the client library
    ```cpp connected     the same, with a client `me` on a Loop `loop`
    ```cpp program       a whole file
A fence that scripts/docs-reference copied from a file (<!-- begin source examples/a.cpp -->) is not compiled here; CMake builds the file.
BUILD is the build folder, which has the generated messages that the client frame and some programs include. Without it, or before it
is built, these fences are skipped with a message. Longer programs belong into examples/, which CMake builds.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

FLAGS = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Wno-unused-variable", "-Wno-unused-but-set-variable",
         "-Wno-missing-field-initializers"]
COPIED = re.compile(r"<!-- begin source .*?<!-- end source -->", re.S)
FENCE = re.compile(r"^( *)```cpp(?: +([a-z]+))? *\n(.*?)^ *```", re.M | re.S)
STANDARD = "#include <chrono>\n#include <cmath>\n#include <cstdio>\n#include <memory>\n#include <thread>\n"
PHYSICS = STANDARD + "#include <jostle/physics/physics.h>\n"
MODULES = PHYSICS + "".join(f"#include <jostle/modules/{name}.h>\n" for name in (
    "boats", "character", "cloth", "convex_decomposition", "cosmetic_particles", "crowd", "destruction", "explosion", "fields", "fracture_file", "fractured_shape",
    "island_coupling", "particles", "ragdoll", "ragdoll_gltf", "rope", "seed_patterns", "settings", "vehicle"))
CLIENT = STANDARD + "".join(f"#include <jostle/client/{name}.h>\n" for name in (
    "client", "playback", "predictor", "query_client", "recording_writer", "security", "world_client"))
USING = "using namespace jostle::physics;\n"
# The head of the file, then the text around each fence.
FRAMES = {
    "": (PHYSICS + USING, "void run() {\n", "}\n"),
    "world": (PHYSICS + USING, "void run() {\nWorld world;\nBodyId body, door, ball;\nJointId hinge;\n{\n", "}\n}\n"),
    "declarations": (PHYSICS + USING, "", ""),
    "modules": (MODULES + USING + "using namespace jostle::modules;\n", "void run() {\n", "}\n"),
    "client": (CLIENT + "using namespace jostle;\n", "void run() {\n", "}\n"),
    "connected": (CLIENT + "using namespace jostle;\n",
                  "void run() {\nclient::Loop loop;\nconst auto me = client::Client::connect(loop, {});\n{\n", "}\n}\n"),
}


def documents(root):
    return [root / "README.md", *sorted((root / "docs").rglob("*.md"))]


def fences(root):
    """(document, line, frame, C++ text) of each fence."""
    for path in documents(root):
        text = path.read_text(encoding="utf-8")
        copied = [match.span() for match in COPIED.finditer(text)]
        for match in FENCE.finditer(text):
            indent, frame, code = match.groups()
            if any(begin <= match.start() < end for begin, end in copied):
                continue
            yield (path.relative_to(root).as_posix(), text.count("\n", 0, match.start()) + 2, frame or "",
                   re.sub(f"^{indent}", "", code, flags=re.M))


def translation_units(found):
    """One for each frame, where every fence is a namespace of its own, and one for each program."""
    by_frame = {}
    for document, line, frame, code in found:
        text = f'#line {line} "{document}"\n{code}'
        if frame == "program":
            yield frame, text, 1
        else:
            head, before, after = FRAMES[frame]
            texts = by_frame.setdefault(head, [])
            texts.append(f"namespace snippet_{len(texts)} {{\n{before}{text}{after}}}\n")
    for head, texts in by_frame.items():
        yield "function", head + "".join(texts), len(texts)


def main():
    if len(sys.argv) not in (3, 4):
        print(next(line for line in __doc__.splitlines() if line.startswith("Usage")), file=sys.stderr)
        return 2
    root, compiler = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    build = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) == 4 else None
    includes = sorted(folder for folder in root.glob("*/**/include")
                      if folder.is_dir() and folder.relative_to(root).parts[0] in ("base", "clients", "modules", "physics", "proto"))
    options = [f"-I{folder}" for folder in [*includes, root]]
    generated = build is not None and any((build / "proto").rglob("play.pb.h"))
    if generated:
        options.append(f"-I{build / 'proto'}")
    found = list(fences(root))
    faults = 0
    for document, line, frame, _ in found:
        if frame not in FRAMES and frame != "program":
            faults += 1
            print(f"{document}:{line}: unknown frame \"{frame}\"; use one of {', '.join(sorted(FRAMES))[2:]}, program")
    found = [fence for fence in found if fence[2] in FRAMES or fence[2] == "program"]
    count, skipped = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for frame, text, fence_count in translation_units(found):
            if not generated and "jostle/client/" in text:
                skipped += fence_count
                continue
            count += fence_count
            file = pathlib.Path(folder) / "snippet.cpp"
            file.write_text(text, encoding="utf-8")
            run = subprocess.run([compiler, *FLAGS, *options, str(file)], capture_output=True, text=True)
            if run.returncode != 0:
                faults += 1
                print(f"a {frame} does not compile:\n{run.stderr}")
    if skipped:
        print(f"snippets: {skipped} skipped, for they need the generated messages of a build")
    print(f"snippets: {count} compiled, {faults} faults")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
