// SPDX-License-Identifier: MIT
#include "physics/src/foundation/thread_choice.h"

#include <gtest/gtest.h>

#include "physics/src/foundation/tuning.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(ThreadChoice, first_step_runs_on_one_thread) {
    ThreadChoice choice;
    EXPECT_FALSE(choice.shares_step(0));
}

TEST(ThreadChoice, shares_a_step_after_one_with_enough_work) {
    ThreadChoice choice;
    EXPECT_FALSE(choice.shares_step(tuning::shared_work - 1));
    EXPECT_TRUE(choice.shares_step(tuning::shared_work));
    EXPECT_FALSE(choice.shares_step(0));
}

// Switching moves all records to other caches.
TEST(ThreadChoice, does_not_alternate_while_work_varies_by_a_tenth) {
    ThreadChoice choice;
    int switches = 0;
    bool last = false;
    for (int k = 0; k < 100; k++) {
        const std::int64_t work = tuning::shared_work * (k % 2 == 0 ? 105 : 95) / 100;
        const bool now = choice.shares_step(work);
        switches += now != last ? 1 : 0;
        last = now;
    }
    EXPECT_EQ(switches, 1);
}

TEST(ThreadChoice, equal_work_gives_equal_choices) {
    ThreadChoice one, other;
    for (std::int64_t work = 0; work < 3 * tuning::shared_work; work += tuning::shared_work / 7)
        EXPECT_EQ(one.shares_step(work), other.shares_step(work));
}

}  // namespace
}  // namespace jostle::test
