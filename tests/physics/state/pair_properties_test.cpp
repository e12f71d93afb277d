// SPDX-License-Identifier: MIT
//
// One coefficient from two materials, by the stronger rule.

#include "physics/src/state/pair_properties.h"
#include <gtest/gtest.h>

namespace jostle::test {

namespace {
using namespace physics;

TEST(Combine, combines_0_4_and_0_9_by_each_rule) {
    const auto both = [](Combine rule) { return combine(0.4, rule, 0.9, rule); };
    EXPECT_NEAR(both(Combine::average), 0.65, 1e-15);
    EXPECT_NEAR(both(Combine::geometric_mean), 0.6, 1e-15);
    EXPECT_EQ(both(Combine::minimum), 0.4);
    EXPECT_NEAR(both(Combine::multiply), 0.36, 1e-15);
    EXPECT_EQ(both(Combine::maximum), 0.9);
}

TEST(Combine, higher_priority_rule_wins_in_either_order) {
    constexpr Combine rules[] = {Combine::average, Combine::geometric_mean, Combine::minimum,
                                 Combine::multiply, Combine::maximum};
    for (const Combine weak : rules)
        for (const Combine strong : rules) {
            if (strong < weak) continue;
            EXPECT_EQ(combine(0.4, weak, 0.9, strong), combine(0.4, strong, 0.9, strong));
            EXPECT_EQ(combine(0.4, strong, 0.9, weak), combine(0.4, strong, 0.9, strong));
        }
}

// Ice under a crate: the geometric mean; a ball that bounces on clay: the higher of the two.
TEST(Combine, default_is_geometric_mean_friction_and_maximum_restitution) {
    const Material ice{.friction = 0.01, .restitution = 0}, ball{.friction = 1, .restitution = 0.8};
    EXPECT_NEAR(pair_friction(ice, ball), 0.1, 1e-15);
    EXPECT_EQ(pair_restitution(ice, ball), 0.8);
}

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
