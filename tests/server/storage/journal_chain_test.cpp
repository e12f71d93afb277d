// SPDX-License-Identifier: MIT
#include "server/storage/journal_chain.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(JournalChain, chain_depends_on_all_previous_entries) {
    const Chain one = next_chain({}, "spawn"), two = next_chain(one, "push");
    EXPECT_NE(one, next_chain({}, "spawm"));
    EXPECT_NE(two, next_chain(next_chain({}, "push"), "spawn"))
        << "another order must change the chain";
    EXPECT_NE(two, next_chain({}, "push")) << "a missing entry must change the chain";
    EXPECT_EQ(two, next_chain(next_chain({}, "spawn"), "push"));
}

TEST(JournalChain, digest_separates_pieces) {
    const std::string_view ab[] = {"a", "b"}, joined[] = {"ab"}, late[] = {"", "ab"};
    EXPECT_NE(digest_of(ab), digest_of(joined));
    EXPECT_NE(digest_of(joined), digest_of(late));
}

}  // namespace
}  // namespace jostle::server
