// SPDX-License-Identifier: MIT
#include "server/storage/journal_chain.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(JournalChain, an_entry_names_all_that_came_before_it) {
    const Chain one = next_chain({}, "spawn"), two = next_chain(one, "push");
    EXPECT_NE(one, next_chain({}, "spawm"));
    EXPECT_NE(two, next_chain(next_chain({}, "push"), "spawn")) << "in another order";
    EXPECT_NE(two, next_chain({}, "push")) << "with one left out";
    EXPECT_EQ(two, next_chain(next_chain({}, "spawn"), "push"));
}

TEST(JournalChain, pieces_do_not_run_into_each_other) {
    const std::string_view ab[] = {"a", "b"}, joined[] = {"ab"}, late[] = {"", "ab"};
    EXPECT_NE(digest_of(ab), digest_of(joined));
    EXPECT_NE(digest_of(joined), digest_of(late));
}

}  // namespace
}  // namespace jostle::server
