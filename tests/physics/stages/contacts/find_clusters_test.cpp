// SPDX-License-Identifier: MIT
//
// When what bounces is a crowd: balls in a row on the floor, of which the lowest is about to hit it
// and each other one the one below.
#include "physics/src/stages/contacts/find_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "physics/src/stages/stages.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Row {
    int balls = 5;
    double restitution = 0.5, friction = 0, speed = 4;  // m/s: closing
    double gap = 0.01;                                  // m
    bool floor = true, leans = false, nears = true;
    Vec3 gravity{0, -9.81, 0};
    double hz = 60;
};

// Whether the impact of the lowest two, which are shapes 1 and 2, is one in a crowd.
bool is_crowd(const Row& row) {
    World world = make_world({.gravity = row.gravity});
    add_static(world, {.geometry = Box{{5, 1, 5}},
                       .position = {0, row.floor ? -1.0 : -99, 0},
                       .friction = row.friction});
    for (int k = 0; k < row.balls; k++)
        add(world, {.geometry = Sphere{0.1},
                    .position = {0, (0.1 + row.gap) + (0.2 + row.gap) * k, 0},
                    .friction = row.friction,
                    .restitution = row.restitution});
    WorldState& state = state_of(world);
    StepScratch scratch;
    StepContext step{state, scratch, *state.thread_pool, 1 / row.hz, {}};
    update_pairs(step);
    scratch.contacts.had_contacts.assign(state.bodies.awake.size(), row.leans ? 1 : 0);
    for (std::uint32_t k = 0; k < state.contacts.contacts.size(); k++) {
        const Contact& c = state.contacts.contacts[k];
        // Pairs of neighbours.
        const bool ground = c.body_a == 0 || c.body_b == 0;
        const auto [low, high] = std::minmax(c.body_a, c.body_b);
        if (high != low + 1) continue;
        scratch.contacts.tasks.push_back(
            {.contact = k, .bounces = row.nears && (!ground || row.floor), .closing = row.speed});
    }
    find_clusters(step);
    return bounces_in_cluster(state, scratch.contacts, 1, 2);
}

// Of 4 m/s five balls that keep half and a floor leave 4 / 2^10 m/s: no order. Of 0.9 they leave
// 1.4 m/s, shared by five, which bounces: 0.62.
TEST(FindClusters, row_is_a_cluster_if_the_impulse_dies_out) {
    EXPECT_TRUE(is_crowd({}));
    EXPECT_FALSE(is_crowd({.restitution = 0.9}));
    EXPECT_TRUE(is_crowd({.balls = 20, .restitution = 0.9}));
}

TEST(FindClusters, pairs_and_elastic_bodies_are_not_clusters) {
    EXPECT_FALSE(is_crowd({.balls = 2, .restitution = 0.1}));
    EXPECT_TRUE(is_crowd({.balls = 3, .restitution = 0.1}));
    EXPECT_FALSE(is_crowd({.balls = 40, .restitution = 1}));
}

// A seventh of the energy of each impact goes: of 16 m^2/s^2 eight balls leave 16 (6/7)^16 / 8 =
// 0.17 to each, twenty 0.002, where 0.33^2 = 0.11 is noise.
TEST(FindClusters, many_elastic_balls_with_friction_are_a_cluster) {
    EXPECT_FALSE(is_crowd({.balls = 8, .restitution = 1, .friction = 0.5}));
    EXPECT_TRUE(is_crowd({.balls = 20, .restitution = 1, .friction = 0.5}));
}

// In free flight a crowd parts by itself, and so it does where nothing presses it together.
TEST(FindClusters, requires_support) {
    EXPECT_FALSE(is_crowd({.floor = false}));
    EXPECT_TRUE(is_crowd({.floor = false, .leans = true}));
    EXPECT_FALSE(is_crowd({.floor = false, .leans = true, .gravity = {}}));
    EXPECT_TRUE(is_crowd({.gravity = {}}));
}

// 2 g dt is 0.08 m/s at 240 Hz, where 0.3 m/s is what bounces, and 2.6 m/s at 7.5 Hz: of 4 m/s
// three balls of 0.8 leave 1.05, shared by three 0.61.
TEST(FindClusters, threshold_depends_on_gravity_and_step_size) {
    EXPECT_FALSE(is_crowd({.balls = 3, .restitution = 0.8, .hz = 240}));
    EXPECT_TRUE(is_crowd({.balls = 3, .restitution = 0.8, .hz = 7.5}));
}

// Nothing is about to bounce, so nobody is in one.
TEST(FindClusters, no_clusters_without_restitution) {
    EXPECT_FALSE(is_crowd({.nears = false}));
}

}  // namespace
}  // namespace jostle::test
