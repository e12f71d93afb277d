// SPDX-License-Identifier: MIT
//
// Who expected to meet a body is told once.
#include "physics/src/stages/continuous/toi_dependents.h"

#include <gtest/gtest.h>

#include <vector>

namespace jostle::test {
namespace {
using physics::ToiDependents;
using Who = std::vector<std::size_t>;

Who take(ToiDependents& dependents, std::uint32_t body) {
    Who who;
    dependents.take(body, [&](std::size_t one) { who.push_back(one); });
    return who;
}

TEST(ToiDependents, are_visited_latest_first_and_cleared) {
    ToiDependents dependents;
    dependents.add(5, 1);
    dependents.add(9, 2);
    dependents.add(5, 3);
    EXPECT_EQ(take(dependents, 5), (Who{3, 1}));
    EXPECT_EQ(take(dependents, 5), Who{});
    EXPECT_EQ(take(dependents, 9), Who{2});
    EXPECT_EQ(take(dependents, 1000), Who{}) << "nobody expected that one";
}

// Who looks anew may well expect to meet the same body again, while the others are being told.
TEST(ToiDependents, can_be_added_during_visit) {
    ToiDependents dependents;
    for (std::size_t who = 0; who < 3; who++) dependents.add(0, who);
    Who told;
    dependents.take(0, [&](std::size_t who) {
        told.push_back(who);
        if (who == 1) dependents.add(0, 100);
    });
    EXPECT_EQ(told, (Who{2, 1, 0}));
    EXPECT_EQ(take(dependents, 0), Who{100});
}

}  // namespace
}  // namespace jostle::test
