// SPDX-License-Identifier: MIT
#include "tools/load/load_plan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::load {
namespace {

TEST(LoadPlan, a_hundred_clients_look_at_a_hundred_places_of_a_disc) {
    const LoadPlan plan{.clients = 100, .sight = 50};
    int inner = 0;
    for (int k = 0; k < plan.clients; k++) {
        const client::AreaOfInterest sight = *plan.sight_of(k);
        const double far = std::hypot(sight.x, sight.z);
        EXPECT_LT(far, 50);
        EXPECT_EQ(sight.radius, 50);
        inner += far < 25 ? 1 : 0;
    }
    EXPECT_EQ(inner, 25) << "a quarter of the disc";
    EXPECT_FALSE(LoadPlan{}.sight_of(0)) << "all of the world";
}

}  // namespace
}  // namespace jostle::load
