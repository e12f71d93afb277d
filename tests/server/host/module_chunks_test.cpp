// SPDX-License-Identifier: MIT
#include "host/module_chunks.h"

#include <gtest/gtest.h>

#include "support/counter.h"

namespace jostle::server {
namespace {

using namespace physics;
using test::Counter;

class ModuleChunksTest : public testing::Test {
protected:
    Counter& add(const std::string& tag) {
        auto module = std::make_unique<Counter>(tag);
        Counter& added = *module;
        EXPECT_TRUE(world.add_module(std::move(module)).ok());
        return added;
    }
    const std::vector<ModuleChunk>& step() {
        EXPECT_TRUE(world.step(1.0 / 60).ok());
        chunks.publish(world, [](BodyId body) { return body.index == 7 ? 1234567u : 0u; });
        return chunks.chunks();
    }

    World world = World::create().value();
    ModuleChunks chunks;
};

TEST_F(ModuleChunksTest, a_world_without_modules_tells_nothing) {
    EXPECT_TRUE(step().empty());
}

TEST_F(ModuleChunksTest,
       chunks_come_in_the_order_of_the_modules_with_bodies_by_the_name_of_clients) {
    add("second").watched = {7, 1};
    add("first");
    const auto now = step();
    ASSERT_EQ(now.size(), 2u);
    EXPECT_EQ(now[0].tag, "second");
    EXPECT_EQ(now[1].tag, "first");
    const std::vector expected{std::byte{0x87}, std::byte{0xd6}, std::byte{0x12}, std::byte{0},
                               std::byte{1},    std::byte{0},    std::byte{0},    std::byte{0}};
    EXPECT_EQ(*now[0].bytes, expected) << "1234567 and 1, the lowest byte first";
    EXPECT_EQ((*now[1].bytes)[0], std::byte{0}) << "it watches nobody";
}

TEST_F(ModuleChunksTest, what_a_module_says_again_is_the_same_bytes) {
    add("slow").every = 2;
    add("quick");
    const auto first = step(), second = step(), third = step();
    EXPECT_NE(first[0].bytes, second[0].bytes);
    EXPECT_EQ(second[0].bytes, third[0].bytes) << "the same, not equal ones";
    EXPECT_NE(second[1].bytes, third[1].bytes);
}

TEST_F(ModuleChunksTest, a_module_that_has_nothing_to_say_has_no_chunk) {
    add("counter").until = 2;
    EXPECT_EQ(step().size(), 1u);
    EXPECT_TRUE(step().empty());
}

TEST_F(ModuleChunksTest, a_chunk_beyond_16_kib_is_left_out_and_told_of_once) {
    Counter& large = add("large");
    add("small");
    large.padding = chunk_bytes_max - 8;
    EXPECT_EQ(step().size(), 2u) << "16 KiB fit";
    EXPECT_TRUE(chunks.newly_too_large().empty());
    large.padding++;
    for (int tick = 0; tick < 3; tick++) {
        ASSERT_EQ(step().size(), 1u);
        EXPECT_EQ(chunks.chunks()[0].tag, "small");
        ASSERT_EQ(chunks.newly_too_large().size(), tick == 0 ? 1u : 0u);
        if (tick == 0) {
            EXPECT_EQ(chunks.newly_too_large()[0].tag, "large");
            EXPECT_EQ(chunks.newly_too_large()[0].bytes, chunk_bytes_max + 1);
        }
    }
    large.padding = 0;
    EXPECT_EQ(step().size(), 2u) << "it is left out in those ticks only";
}

}  // namespace
}  // namespace jostle::server
