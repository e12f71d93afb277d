// SPDX-License-Identifier: MIT
//
// A pair is as large as its smaller dynamic body: the ground does not count.
#include "physics/src/state/pair_size.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using namespace physics;

TEST(PairSize, is_the_size_of_the_smaller_dynamic_body) {
    const BodyCold large{.radius = 3}, small{.radius = 0.01},
        ground{.type = BodyType::static_body, .radius = 0.001},
        platform{.type = BodyType::kinematic, .radius = 0.002};
    EXPECT_EQ(size_of_pair(large, small), 0.01);
    EXPECT_EQ(size_of_pair(small, large), 0.01);
    EXPECT_EQ(size_of_pair(large, ground), 3);
    EXPECT_EQ(size_of_pair(small, platform), 0.01);
}

TEST(PairSize, scale_of_a_contact_follows_its_size) {
    BodyStore bodies;
    bodies.cold.push_back({.radius = 0.5});
    bodies.cold.push_back({.radius = 0.005});
    Contact c;
    c.body_a = 0;
    c.body_b = 1;
    EXPECT_NEAR(scale_of_pair(bodies, c), 0.1, 1e-12);
}

}  // namespace
}  // namespace jostle::test
