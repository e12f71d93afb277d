// SPDX-License-Identifier: MIT
#include "server/auth/lru_map.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(LruMap, evicts_the_least_recently_used_entry) {
    LruMap<int> map(3);
    int made = 0;
    const auto lookup = [&](const char* key) {
        return map.find_or_make(key, [&] { return ++made; });
    };
    EXPECT_EQ(lookup("a"), 1);
    EXPECT_EQ(lookup("b"), 2);
    EXPECT_EQ(lookup("c"), 3);
    EXPECT_EQ(lookup("a"), 1);
    EXPECT_EQ(lookup("d"), 4) << "b is evicted";
    EXPECT_EQ(lookup("a"), 1);
    EXPECT_EQ(lookup("c"), 3);
    EXPECT_EQ(lookup("b"), 5);
    EXPECT_EQ(map.size(), 3u);
}

}  // namespace
}  // namespace jostle::server
