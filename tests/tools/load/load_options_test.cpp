// SPDX-License-Identifier: MIT
#include "tools/load/load_options.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::load {
namespace {

TEST(LoadOptions, distributes_the_areas_of_interest_of_clients_over_a_disc) {
    const LoadOptions plan{.clients = 100, .interest_radius = 50};
    int inner = 0;
    for (int k = 0; k < plan.clients; k++) {
        const client::AreaOfInterest interest_radius = *plan.interest_of(k);
        const double far = std::hypot(interest_radius.x, interest_radius.z);
        EXPECT_LT(far, 50);
        EXPECT_EQ(interest_radius.radius, 50);
        inner += far < 25 ? 1 : 0;
    }
    EXPECT_EQ(inner, 25) << "a quarter of the disc";
    EXPECT_FALSE(LoadOptions{}.interest_of(0)) << "the whole world";
}

}  // namespace
}  // namespace jostle::load
