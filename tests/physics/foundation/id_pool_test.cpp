// SPDX-License-Identifier: MIT
//
// Indices come lowest free first, and an id of an earlier life names nothing.
#include "physics/src/foundation/id_pool.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using physics::IdPool;

TEST(IdPool, allocates_the_lowest_free_index) {
    IdPool ids;
    for (std::uint32_t k = 0; k < 5; k++) EXPECT_EQ(ids.take(), k);
    ids.release(3);
    ids.release(1);
    ids.release(4);
    EXPECT_EQ(ids.take(), 1u);
    EXPECT_EQ(ids.take(), 3u);
    EXPECT_EQ(ids.take(), 4u);
    EXPECT_EQ(ids.take(), 5u);
    EXPECT_EQ(ids.size(), 6u);
}

TEST(IdPool, reused_index_has_a_new_generation) {
    IdPool ids;
    const std::uint32_t index = ids.take(), first = ids.generation(index);
    EXPECT_EQ(first, 1u);
    EXPECT_TRUE(ids.matches(index, first));
    ids.release(index);
    EXPECT_FALSE(ids.alive(index));
    EXPECT_FALSE(ids.matches(index, first));
    EXPECT_FALSE(ids.matches(index, first + 1)) << "nobody lives there yet";
    EXPECT_EQ(ids.take(), index);
    EXPECT_FALSE(ids.matches(index, first));
    EXPECT_TRUE(ids.matches(index, first + 1));
}

TEST(IdPool, rejects_indices_that_were_never_allocated) {
    IdPool ids;
    EXPECT_FALSE(ids.alive(0));
    EXPECT_FALSE(ids.matches(7, 1));
}

// What a load does: generations and flags are saved, the list of free indices is not.
TEST(IdPool, allocates_the_same_indices_after_rebuilding_the_free_list) {
    IdPool ids;
    for (int k = 0; k < 8; k++) ids.take();
    for (const std::uint32_t index : {6u, 2u, 5u}) ids.release(index);
    IdPool loaded;
    loaded.generations() = ids.generations();
    loaded.alive_flags() = ids.alive_flags();
    loaded.rebuild_free_list();
    for (const std::uint32_t index : {2u, 5u, 6u, 8u}) {
        EXPECT_EQ(ids.take(), index);
        EXPECT_EQ(loaded.take(), index);
        EXPECT_EQ(loaded.generation(index), ids.generation(index));
    }
}

}  // namespace
}  // namespace jostle::test
