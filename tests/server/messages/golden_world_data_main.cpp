// SPDX-License-Identifier: MIT
//
// Rewrites proto/golden/world_data.jdat.
#include <cstdio>
#include <fstream>

#include "tests/server/messages/golden_world_data.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_world_data FILE\n");
        return 2;
    }
    std::ofstream out(argv[1], std::ios::binary);
    out << jostle::server::golden_world_data();
    out.close();
    if (out) return 0;
    std::fprintf(stderr, "golden_world_data: cannot write %s\n", argv[1]);
    return 1;
}
