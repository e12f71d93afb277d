// SPDX-License-Identifier: MIT
//
// A promise of ours that does not hold ends the program with its place and its words.
#include "jostle/base/check.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {

TEST(CheckDeathTest, message_contains_file_line_and_expression) {
    EXPECT_DEATH(assertion_failed("index < count", "store.cpp", 12),
                 "store\\.cpp:12: assertion failed: index < count");
}

// Where assertions are off their expression is compiled and not run.
TEST(CheckDeathTest, aborts_in_builds_with_assertions) {
    int calls = 0;
    const auto one = [&] { return ++calls; };
    ASSERT(one() == 1);
#ifdef JOSTLE_ASSERT
    EXPECT_EQ(calls, 1);
    EXPECT_DEATH(ASSERT(calls == 7), "assertion failed: calls == 7");
#else
    EXPECT_EQ(calls, 0);
#endif
}

}  // namespace
}  // namespace jostle::test
