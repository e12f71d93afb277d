// SPDX-License-Identifier: MIT
//
// golden_hashes [FILE]: writes the golden hashes of this build, to the file the tests read unless
// told otherwise.
#include <cstdio>

#include "determinism/golden_hashes.h"

int main(int argc, char** argv) {
    const char* path = argc > 1 ? argv[1] : GOLDEN_HASHES;
    const std::string text = jostle::test::golden_lines();
    std::FILE* file = std::fopen(path, "w");
    if (file == nullptr || std::fwrite(text.data(), 1, text.size(), file) != text.size()) {
        std::fprintf(stderr, "cannot write %s; is its folder there and writable?\n", path);
        return 1;
    }
    std::fclose(file);
    std::printf("%swritten to %s\n", text.c_str(), path);
    return 0;
}
