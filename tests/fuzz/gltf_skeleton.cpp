// SPDX-License-Identifier: MIT
//
// Files that are said to hold a skeleton. When the first byte is odd, the rest is the JSON text of
// a file whose buffer is made here, so that the fuzzer need not write base64.
#include <nlohmann/json.hpp>

#include "jostle/modules/ragdoll_gltf.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

std::vector<std::byte> buffer() {
    std::vector<std::byte> bytes(4096);
    for (std::size_t k = 0; k < bytes.size(); k++) bytes[k] = static_cast<std::byte>(k * 7 % 64);
    return bytes;
}

}  // namespace

void run(Bytes input) {
    if (input.empty()) return;
    modules::GltfBufferReader outside;
    if (input[0] % 2 == 1)
        outside = [](const std::string&) -> Result<std::vector<std::byte>> { return buffer(); };
    const auto file = std::as_bytes(std::span(input.data(), input.size())).subspan(1);
    const auto figure = modules::figure_from_gltf(file, {}, outside);
    if (!figure.ok()) return expect(!figure.error().message.empty(), "a refusal has a reason");
    const auto& bones = figure->def.bones;
    expect(!bones.empty() && bones.size() <= 256 && bones.size() == figure->nodes.size(),
           "a figure has bones, each of a node");
    for (std::size_t k = 0; k < bones.size(); k++) {
        expect((bones[k].parent == -1) == (k == 0) && bones[k].parent < static_cast<int>(k),
               "parents come first");
        expect(physics::is_finite(bones[k].rest) && physics::is_finite(bones[k].frame),
               "bones stand somewhere");
    }
}

}  // namespace jostle::fuzz
