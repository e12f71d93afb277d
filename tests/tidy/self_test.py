#!/usr/bin/env python3
"""The checks can fail: each is run on a small tree with one fault of its kind, and must name it."""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
CASES = [
    ("check_layers.py", "physics/src/foundation/low.h", '// SPDX-License-Identifier: MIT\n#include "physics/src/state/high.h"\n',
     "physics/src/foundation/low.h includes physics/src/state/high.h"),
    ("check_layers.py", "base/include/jostle/base/a.h", '// SPDX-License-Identifier: MIT\n#include "jostle/physics/world.h"\n',
     "base must not include physics/include"),
    ("check_layers.py", "server/grpc/a.h", '// SPDX-License-Identifier: MIT\n#include "server/http/b.h"\n',
     "server/grpc/a.h includes server/http/b.h"),
    ("check_layers.py", "server/limits/a.h", '// SPDX-License-Identifier: MIT\n#include "jostle/physics/world.h"\n',
     "only server/world and server/recovery may include the World"),
    ("check_layers.py", "proto/snapshot/include/jostle/snapshot/a.h", '// SPDX-License-Identifier: MIT\n#include "jostle/v1/play.pb.h"\n',
     "must not include generated messages"),
    ("check_loops.py", "server/world/a.cpp", '// SPDX-License-Identifier: MIT\n#include "server/world/b.h"\n',
     "2 files need each other: server/world/a, server/world/b"),
    ("check_names.py", "physics/src/BadName.h", "// SPDX-License-Identifier: MIT\n", "file names are snake_case"),
    ("check_names.py", "physics/src/plain.h", "#pragma once\n", "does not begin with"),
    ("check_names.py", "docs/a.md", "see /home" + "/somebody\n", "a path of somebody's machine"),
    ("check_links.py", "docs/a.md", "[gone](gone.md)\n", "the link gone.md leads nowhere"),
    ("check_links.py", "docs/a.md", "in `server/gone.cpp`\n", "there is no server/gone.cpp"),
    ("check_english.py", "docs/a.md", "The client foresees\nthe push.\n", 'docs/a.md:1: "foresees"; use: predict'),
    ("check_english.py", "docs/a.md", "One sentence. What\nmoves is drawn.\n", 'docs/a.md:1: "What moves ..." begins with a free relative clause'),
    ("check_english.py", "docs/a.md", "word " * 30 + "\n", "docs/a.md:1: 150 columns; wrap at 120"),
    ("check_english.py", "server/app/a.cpp", 'auto text = "the server asks for a token";\n', 'server/app/a.cpp:1: "asks"; use: request'),
    ("check_english.py", "proto/jostle/v1/a.proto", "// The roster of a world.\n", 'proto/jostle/v1/a.proto:1: "roster"; use: entity update'),
    ("check_version.py", "clients/web/sdk/package.json", '{ "version": "9.9.9" }\n', "clients/web/sdk/package.json: version 9.9.9"),
    ("check_tests.py", "physics/src/state/lonely.cpp", "// SPDX-License-Identifier: MIT\n",
     "physics/src/state/lonely.cpp: no test. Write tests/physics/state/lonely_test.cpp"),
    ("check_tests.py", "tests/physics/foundation/prefetch_test.cpp", "// SPDX-License-Identifier: MIT\n",
     "physics/src/foundation/prefetch.h has a test of its own now"),
    ("check_tests.py", "tests/physics/foundation/prefetch_test.cpp", "// SPDX-License-Identifier: MIT\n",
     "tests/physics/foundation/prefetch_test.cpp: is in no CMakeLists.txt"),
    ("check_tests.py", "tests/physics/state/odd_test.cpp", "// SPDX-License-Identifier: MIT\n",
     "tests/physics/state/odd_test.cpp: mirrors no source"),
    ("check_tests.py", "physics/src/state/wake.cpp", "// SPDX-License-Identifier: MIT\n",
     "physics/src/serialization/derive.cpp is gone"),
    ("check_tests.py", "physics/src/serialization/derive.cpp", "// SPDX-License-Identifier: MIT\n",
     "physics/src/serialization/derive.cpp is said to be exercised by tests/physics/serialization/save_load_test.cpp, which does not exist"),
]
# What the faulty files refer to.
OTHERS = {"physics/src/state/high.h": "", "server/http/b.h": "", "physics/include/jostle/physics/world.h": "",
          "server/world/a.h": "", "server/world/b.h": '#include "server/world/a.h"\n',
          "physics/src/foundation/prefetch.h": "inline void prefetch() {}\n"}

# Commit subjects that check_commit_subject.py rejects.
SUBJECTS = ["Fix the server", "server: reject names.", "server: " + 65 * "x", ""]


def main():
    failed = 0
    for subject in SUBJECTS:
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as message:
            message.write(subject + "\n")
            message.flush()
            if subprocess.run([sys.executable, HERE / "check_commit_subject.py", message.name], capture_output=True).returncode != 1:
                failed += 1
                print(f"check_commit_subject.py did not notice {subject!r}")
    for check, name, text, expected in CASES:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for other, include in OTHERS.items():
                (root / other).parent.mkdir(parents=True, exist_ok=True)
                (root / other).write_text("// SPDX-License-Identifier: MIT\n" + include)
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
            run = subprocess.run([sys.executable, HERE / check, folder], capture_output=True, text=True)
            if run.returncode == 0 or expected not in run.stdout:
                failed += 1
                print(f"{check} did not notice {name}: {expected!r}\n{run.stdout}{run.stderr}")
    count = len(CASES) + len(SUBJECTS)
    print(f"tidy self-test: {count - failed} of {count} faults noticed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
