// SPDX-License-Identifier: MIT
//
// Definitions of worlds as bytes, of this version and of the first one.
#include "server/recovery/world_definition.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"

namespace jostle::server {
namespace {

std::string encoded(int pairs_per_shape_max) {
    WorldDefinition definition{
        .owner = "ann",
        .scene = std::make_shared<const scenes::SceneDescription>(*scenes::find_scene("stack")),
        .work_per_second = 12.5};
    definition.limits.scene.pairs_per_shape_max = pairs_per_shape_max;
    return encode_world_definition(definition);
}

TEST(WorldDefinition, reads_what_it_wrote) {
    const Result<WorldDefinition> read = decode_world_definition(encoded(7));
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->owner, "ann");
    EXPECT_EQ(read->work_per_second, 12.5);
    EXPECT_EQ(read->limits.scene.pairs_per_shape_max, 7);
}

// Version 1 ends before the limit of pairs.
TEST(WorldDefinition, worlds_of_version_1_have_no_limit_of_pairs) {
    std::string bytes = encoded(7);
    bytes.resize(bytes.size() - 6 * sizeof(double));
    bytes[0] = 1;
    const Result<WorldDefinition> read = decode_world_definition(bytes);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->work_per_second, 12.5);
    EXPECT_EQ(read->limits.scene.pairs_per_shape_max, 0);
}

// Version 2 ends before the limits on attributes.
TEST(WorldDefinition, worlds_of_version_2_have_the_default_limits_on_attributes) {
    std::string bytes = encoded(7);
    bytes.resize(bytes.size() - 5 * sizeof(double));
    bytes[0] = 2;
    const Result<WorldDefinition> read = decode_world_definition(bytes);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->limits.scene.pairs_per_shape_max, 7);
    EXPECT_EQ(read->limits.attributes.per_target_max, AttributeLimits().per_target_max);
}

TEST(WorldDefinition, rejects_other_versions_and_lengths) {
    for (const char version : {'\0', '\5'}) {
        std::string bytes = encoded(7);
        bytes[0] = version;
        EXPECT_EQ(decode_world_definition(bytes).error().message,
                  "unsupported world definition: version " +
                      std::to_string(static_cast<int>(version)) +
                      "; this server reads versions 1 to 4");
    }
    std::string longer = encoded(7);
    longer[0] = 1;
    EXPECT_FALSE(decode_world_definition(longer).ok()) << "data after the end";
    const std::string bytes = encoded(7);
    EXPECT_FALSE(decode_world_definition(bytes.substr(0, bytes.size() - 1)).ok());
    EXPECT_FALSE(decode_world_definition(encoded(-1)).ok());
}

}  // namespace
}  // namespace jostle::server
