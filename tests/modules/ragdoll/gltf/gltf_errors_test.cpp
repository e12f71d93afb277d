// SPDX-License-Identifier: MIT
//
// Errors in a file are reported with their location.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/modules/ragdoll/gltf/gltf_skeleton.h"

namespace jostle::modules {
namespace {

using nlohmann::json;

std::string error_of(const std::function<void(GltfSkeleton&)>& change,
                     const GltfFigureOptions& options = {}) {
    GltfSkeleton skeleton;
    change(skeleton);
    const auto figure = figure_from_gltf(skeleton.gltf(), options);
    return figure.ok() ? "" : figure.error().message;
}

TEST(GltfErrors, errors_name_invalid_indices_and_cycles) {
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["nodes"][1]["children"][1] = 99; }),
              "nodes[1].children[1] is 99; there are 9 nodes");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["nodes"][3]["children"] = {4}; }),
              "nodes[3].children[0] is already a child of nodes[1]");
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  s.json["nodes"][0]["children"] = {8};
                  s.json["nodes"][3]["children"] = {1};
              }),
              "nodes[1] is its own descendant");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"][2] = 1; }),
              "skins[0].joints[2] is a duplicate");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"].erase(0); }),
              "skins[0].joints has 3 roots; it must have exactly one");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"][0] = -1; }),
              "skins[0].joints[0] is out of range; it must be from 0 to 64 million");
    EXPECT_EQ(error_of([](GltfSkeleton&) {}, {.skin = 3}),
              "skins has no element 3; it has 1 elements");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][0]["bufferView"] = 7; }),
              "accessors[0].bufferView is 7; there are 4 buffer views");
}

TEST(GltfErrors, errors_name_invalid_sizes) {
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][0]["count"] = 757; }),
              "accessors[0] extends past the end of its buffer view");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][0]["count"] = 60'000'000; }),
              "accessors[0].count is more than 1398101");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["bufferViews"][3]["byteLength"] = 449; }),
              "bufferViews[3] extends past the end of its buffer");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["bufferViews"][0]["byteStride"] = 4; }),
              "bufferViews[0].byteStride is less than the size of an element");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][3]["count"] = 6; }),
              "skins[0].inverseBindMatrices has 6 matrices for 7 joints");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"] = json::array(); }),
              "skins[0].joints must have 1 to 1024 nodes");
}

TEST(GltfErrors, errors_name_invalid_numbers) {
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  const float bad = std::numeric_limits<float>::quiet_NaN();
                  s.buffer.replace(120, 4, reinterpret_cast<const char*>(&bad), 4);
              }),
              "accessors[0] has a number that is not finite");
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  s.json["nodes"][2]["rotation"] = {0, 0, 0, 0};
              }),
              "nodes[2].rotation is not a unit quaternion");
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  s.json["nodes"][2]["translation"] = {1, "x", 0};
              }),
              "nodes[2].translation[1] is not a number");
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  s.json["nodes"][2]["scale"] = {1e300, 1, 1};
              }),
              "nodes[2] has a position beyond 1e9");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][1]["componentType"] = 9; }),
              "accessors[1].componentType is not a glTF component type");
    EXPECT_EQ(error_of([](GltfSkeleton&) {}, {.scale = 0}), "scale must be from 1e-4 to 1e4 m");
    GltfFigureOptions crossed;
    crossed.bones = {{.name = "head", .lower = 1}};
    EXPECT_EQ(error_of([](GltfSkeleton&) {}, crossed),
              "bones[0] (head): lower and upper must be from -pi to pi, lower <= upper");
}

TEST(GltfErrors, files_that_are_none_are_named) {
    const auto refused = [](const std::string& text) {
        return figure_from_gltf(bytes_of(text)).error().message;
    };
    EXPECT_EQ(refused(""), "the file is neither a .glb nor a JSON object");
    EXPECT_EQ(refused("[1, 2"), "the file is neither a .glb nor a JSON object");
    EXPECT_EQ(refused(std::string(5000, '[')), "the JSON text is nested deeper than 64 levels");
    EXPECT_EQ(refused("{}"), "asset.version is not \"2.0\"; only glTF 2 is supported");
    EXPECT_EQ(refused("glTF1234"), "the file ends inside the .glb header");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json.erase("skins"); }),
              "skins has no element 0; it has 0 elements");
    EXPECT_EQ(figure_from_gltf(GltfSkeleton().with_external_buffer()).error().message,
              "buffers[0].uri names an external buffer, but no buffer reader is given");
}

// Any byte of a .glb may have any value: the file is rejected with a reason, or its figure is
// valid.
TEST(GltfErrors, forged_bytes_are_refused_or_harmless) {
    const std::vector<std::byte> valid = GltfSkeleton().glb();
    int refused = 0;
    for (std::size_t at = 0; at < valid.size(); at += 41)
        for (const unsigned flip : {0x01u, 0x10u, 0xffu}) {
            std::vector<std::byte> bytes = valid;
            bytes[at] ^= static_cast<std::byte>(flip);
            const auto figure = figure_from_gltf(bytes);
            if (figure.ok()) continue;
            refused++;
            EXPECT_FALSE(figure.error().message.empty());
        }
    RecordProperty("refused", refused);
    EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace jostle::modules
