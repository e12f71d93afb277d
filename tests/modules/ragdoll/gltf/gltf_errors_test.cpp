// SPDX-License-Identifier: MIT
//
// What is wrong in a file is named with its place.
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
              "nodes[3].children[0] is a child of nodes[1] already");
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  s.json["nodes"][0]["children"] = {8};
                  s.json["nodes"][3]["children"] = {1};
              }),
              "nodes[1] is below itself");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"][2] = 1; }),
              "skins[0].joints[2] is there twice");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"].erase(0); }),
              "skins[0].joints have 3 roots; a figure has one");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"][0] = -1; }),
              "skins[0].joints[0] is negative or above 64 million");
    EXPECT_EQ(error_of([](GltfSkeleton&) {}, {.skin = 3}), "skins has no [3]; there are 1");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][0]["bufferView"] = 7; }),
              "accessors[0].bufferView is 7; there are 4 buffer views");
}

TEST(GltfErrors, errors_name_invalid_sizes) {
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][0]["count"] = 757; }),
              "accessors[0] ends behind the end of its buffer view");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][0]["count"] = 60'000'000; }),
              "accessors[0].count is more than 1398101");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["bufferViews"][3]["byteLength"] = 449; }),
              "bufferViews[3] ends behind the end of its buffer");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["bufferViews"][0]["byteStride"] = 4; }),
              "bufferViews[0].byteStride is less than an element has");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][3]["count"] = 6; }),
              "skins[0].inverseBindMatrices has 6 matrices for 7 joints");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["skins"][0]["joints"] = json::array(); }),
              "skins[0].joints must be 1 to 1024 nodes");
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
              "nodes[2].rotation is no unit quaternion");
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  s.json["nodes"][2]["translation"] = {1, "x", 0};
              }),
              "nodes[2].translation[1] is no number");
    EXPECT_EQ(error_of([](GltfSkeleton& s) {
                  s.json["nodes"][2]["scale"] = {1e300, 1, 1};
              }),
              "nodes[2] stands further away than 1e9");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json["accessors"][1]["componentType"] = 9; }),
              "accessors[1].componentType is none of glTF's");
    EXPECT_EQ(error_of([](GltfSkeleton&) {}, {.scale = 0}), "scale must be from 1e-4 to 1e4 m");
    GltfFigureOptions crossed;
    crossed.bones = {{.name = "head", .lower = 1}};
    EXPECT_EQ(error_of([](GltfSkeleton&) {}, crossed),
              "bones[0] (head): lower and upper must be from -pi to pi, the lower first");
}

TEST(GltfErrors, files_that_are_none_are_named) {
    const auto refused = [](const std::string& text) {
        return figure_from_gltf(bytes_of(text)).error().message;
    };
    EXPECT_EQ(refused(""), "the file is neither a .glb nor a JSON object");
    EXPECT_EQ(refused("[1, 2"), "the file is neither a .glb nor a JSON object");
    EXPECT_EQ(refused(std::string(5000, '[')), "the JSON text is nested more than 64 deep");
    EXPECT_EQ(refused("{}"), "asset.version is not \"2.0\": no glTF 2 file");
    EXPECT_EQ(refused("glTF1234"), "the file ends within the head of a .glb");
    EXPECT_EQ(error_of([](GltfSkeleton& s) { s.json.erase("skins"); }),
              "skins has no [0]; there are 0");
    EXPECT_EQ(figure_from_gltf(GltfSkeleton().with_buffer_beside()).error().message,
              "buffers[0].uri names a buffer outside, and nobody reads those here");
}

// Any byte of a .glb may be anything: it is refused with a reason, or gives a figure that stands.
TEST(GltfErrors, forged_bytes_are_refused_or_harmless) {
    const std::vector<std::byte> whole = GltfSkeleton().glb();
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); at += 41)
        for (const unsigned flip : {0x01u, 0x10u, 0xffu}) {
            std::vector<std::byte> bytes = whole;
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
