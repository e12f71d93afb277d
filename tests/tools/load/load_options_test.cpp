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

TEST(LoadOptions, spreads_the_read_rates_of_clients_evenly) {
    const LoadOptions plan{.clients = 100, .read_rate = 5, .read_rate_max = 60};
    int slow = 0;
    for (int k = 0; k < plan.clients; k++) {
        EXPECT_GE(plan.read_rate_of(k), 5);
        EXPECT_LE(plan.read_rate_of(k), 60);
        slow += plan.read_rate_of(k) < 32.5 ? 1 : 0;
    }
    EXPECT_NEAR(slow, 50, 1);
    EXPECT_EQ((LoadOptions{.read_rate = 20}.read_rate_of(3)), 20);
    EXPECT_EQ(LoadOptions{}.read_rate_of(3), 0) << "unlimited";
}

}  // namespace
}  // namespace jostle::load
