// SPDX-License-Identifier: MIT
#include "server/world/ownership.h"

#include <gtest/gtest.h>

namespace jostle::server {

TEST(Ownership, counts_owned_entities_per_client) {
    Ownership ownership;
    ownership.add(1, 10);
    ownership.add(1, 12);
    ownership.add(2, 11);
    EXPECT_EQ(ownership.count(1), 2);
    EXPECT_EQ(ownership.count(3), 0);
    EXPECT_TRUE(ownership.owns(1, 12));
    EXPECT_FALSE(ownership.owns(2, 12));
    EXPECT_FALSE(ownership.owns(3, 12));
    ownership.remove(12);
    ownership.remove(99);
    EXPECT_EQ(ownership.count(1), 1);
    EXPECT_FALSE(ownership.owns(1, 12));
}

TEST(Ownership, lists_owned_entities_in_order_and_clears_them_on_leave) {
    Ownership ownership;
    for (const EntityId entity : {9u, 3u, 5u}) ownership.add(1, entity);
    EXPECT_EQ(ownership.owned_by(1), (std::vector<EntityId>{3, 5, 9}));
    ownership.forget(1);
    EXPECT_TRUE(ownership.owned_by(1).empty());
    EXPECT_FALSE(ownership.owns(1, 3));
}

}  // namespace jostle::server
