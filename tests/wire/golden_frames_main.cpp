// SPDX-License-Identifier: MIT
//
// golden_frames FOLDER: writes every golden sequence to FOLDER/NAME.bin.
#include <cstdio>
#include <fstream>

#include "wire/golden.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_frames FOLDER (usually proto/golden)\n");
        return 2;
    }
    for (const auto& sequence : jostle::wire::golden_sequences()) {
        const std::string path = std::string(argv[1]) + "/" + sequence.name + ".bin";
        const auto bytes = jostle::wire::golden_file(sequence);
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
