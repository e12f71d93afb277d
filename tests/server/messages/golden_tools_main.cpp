// SPDX-License-Identifier: MIT
//
// Rewrites proto/golden/sandbox_tools.jmsg.
#include <cstdio>
#include <fstream>

#include "tests/server/messages/golden_tools.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_tools FILE\n");
        return 2;
    }
    std::ofstream out(argv[1], std::ios::binary);
    out << jostle::server::golden_tools();
    out.close();
    if (out) return 0;
    std::fprintf(stderr, "golden_tools: cannot write %s\n", argv[1]);
    return 1;
}
