// SPDX-License-Identifier: MIT
//
// golden_modules FOLDER: writes the channels of each module in its golden world to FOLDER/TAG.bin.
#include <cstdio>
#include <fstream>

#include "tests/modules/golden/golden_modules.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_modules FOLDER (usually proto/golden_modules)\n");
        return 2;
    }
    for (const auto& [tag, channels] : jostle::modules::golden_modules()) {
        const std::vector<std::byte> bytes = jostle::modules::file_bytes(channels);
        const std::string path = std::string(argv[1]) + "/" + tag + ".bin";
        std::ofstream out(path, std::ios::binary);
        out.write(reinterpret_cast<const char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size()));
        if (!out) {
            std::fprintf(stderr, "cannot write %s\n", path.c_str());
            return 1;
        }
        std::printf("%s: %zu bytes\n", path.c_str(), bytes.size());
    }
    return 0;
}
