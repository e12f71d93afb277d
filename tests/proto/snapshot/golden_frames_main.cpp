// SPDX-License-Identifier: MIT
//
// golden_frames FOLDER: writes every golden sequence to FOLDER/NAME.bin and FOLDER/range_NAME.bin,
// the channels to FOLDER/channels.jchn, the point objects to FOLDER/points.jpnt and the entity
// lists to FOLDER/entities.jent.
#include <cstdio>
#include <fstream>

#include "tests/proto/snapshot/channel_motion.h"
#include "tests/proto/snapshot/golden.h"
#include "tests/proto/snapshot/golden_entities.h"
#include "tests/proto/snapshot/golden_points.h"

namespace {

bool write(const std::string& path, const std::vector<std::byte>& bytes) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    if (out)
        std::printf("%s: %zu bytes\n", path.c_str(), bytes.size());
    else
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
    return static_cast<bool>(out);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_frames FOLDER (usually proto/golden)\n");
        return 2;
    }
    const std::string folder = std::string(argv[1]) + "/";
    bool written = write(folder + "channels.jchn", jostle::snapshot::golden_channels());
    written = write(folder + "points.jpnt", jostle::snapshot::golden_point_file()) && written;
    written = write(folder + "entities.jent", jostle::snapshot::golden_entity_file()) && written;
    using jostle::snapshot::Codec;
    for (const auto& sequence : jostle::snapshot::golden_sequences())
        for (const Codec codec : {Codec::bits, Codec::range})
            written = write(folder + golden_name(sequence, codec), golden_file(sequence, codec)) &&
                      written;
    return written ? 0 : 1;
}
