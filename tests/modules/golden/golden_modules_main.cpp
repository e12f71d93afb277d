// SPDX-License-Identifier: MIT
//
// golden_modules FILE: writes the channels of each module in its golden world to FILE.
#include <cstdio>
#include <fstream>

#include "tests/modules/golden/golden_modules.h"

int main(int argc, char** argv) {
    using namespace jostle::modules;
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_modules FILE (usually proto/golden_modules.txt)\n");
        return 2;
    }
    std::ofstream out(argv[1]);
    for (const GoldenModule& module : golden_modules())
        for (const auto& channel : module.channels) out << line_of(module.tag, channel) << "\n";
    out.close();
    if (out) return 0;
    std::fprintf(stderr, "cannot write %s\n", argv[1]);
    return 1;
}
