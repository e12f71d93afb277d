// SPDX-License-Identifier: MIT
//
// A load on something lighter is solved directly before it touches it. Where that is not possible,
// as in a planar world, a load of a hundred times the mass gets more sub-steps in the next step,
// not at the next look at all islands; one that has firm ground, too, or less mass, does not need
// them.
#include "physics/src/stages/islands/island_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Steps from the first touch with the light box to the first step with more sub-steps; -1: none in
// a second.
int steps_until_heavy(World& world, BodyId load, BodyId light) {
    int since = -1;
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        if (world.profile().bodies_heavy > 0) return since;
        bool touch = since >= 0;
        for (const ContactInfo& c : world.contacts())
            touch = touch || ((c.body_a == load || c.body_b == load) &&
                              (c.body_a == light || c.body_b == light) && c.touching);
        if (touch) since++;
    }
    return -1;
}

TEST(HeavyLoad, is_detected_one_step_after_contact) {
    for (int delay = 0; delay < 8; delay++) {
        World world = make_world({.sleeping = false, .planar = true});
        add_floor(world);
        const BodyId light = add(world, {.position = {0, 0.5, 0}});
        run(world, 0.5 + delay / 60.0);
        const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 2e5});
        EXPECT_EQ(steps_until_heavy(world, load, light), 0) << "after " << delay;
    }
}

TEST(HeavyLoad, ignores_a_mass_ratio_of_fifty) {
    World world = make_world({.sleeping = false, .planar = true});
    add_floor(world);
    const BodyId light = add(world, {.position = {0, 0.5, 0}});
    const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 5e4});
    EXPECT_EQ(steps_until_heavy(world, load, light), -1);
}

TEST(HeavyLoad, ignores_heavy_bodies_supported_by_the_floor) {
    World world = make_world({.sleeping = false, .planar = true});
    add_floor(world);
    const BodyId light = add(world, {.position = {1.01, 0.5, 0}, .velocity = {-0.5, 0, 0}});
    const BodyId load = add(world, {.position = {0, 0.5, 0}, .density = 2e5});
    EXPECT_EQ(steps_until_heavy(world, load, light), -1);
}

TEST(HeavyLoad, is_solved_directly_before_contact) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.position = {0, 0.5, 0}});
    run(world, 0.5);
    const BodyId load = add(world, {.position = {0, 1.52, 0}, .density = 2e4});
    int before = 0;
    double lowest = 1.52;
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        if (k == 2) before = world.profile().bodies_direct;
        EXPECT_EQ(world.profile().direct_passes_unsolved, 0) << "step " << k;
        lowest = minimum(lowest, position_of(world, load).y);
    }
    EXPECT_EQ(before, 2) << "it falls for four steps";
    EXPECT_GT(lowest, 1.5 - 1e-4);
}

TEST(HeavyLoad, equal_and_lighter_loads_are_not_solved_directly) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    for (int k = 0; k < 6; k++)
        add(world, {.position = {0, 0.5 + k, 0}, .density = k == 0 ? 2e5 : 1000.0});
    run(world, 0.5);
    EXPECT_EQ(world.profile().bodies_direct, 0);
}

TEST(HeavyLoad, islands_that_become_too_large_leave_the_direct_tier) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    add(world, {.geometry = Box{{2.5, 0.5, 2.5}}, .position = {0, 0.5, 0}, .density = 10});
    add(world, {.position = {0, 1.5, 0}, .density = 1e5});
    run(world, 0.5);
    ASSERT_EQ(world.profile().bodies_direct, 2);
    for (int k = 0; k < 81; k++)
        if (k != 40)
            add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                        .position = {-2 + 0.5 * (k % 9), 1.201, -2 + 0.5 * (k / 9)}});
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.profile().bodies_direct, 0);
    EXPECT_GT(world.profile().bodies_heavy, 64);
}

// Friction below a heavy box can hold any pressure between light ones side by side.
TEST(HeavyLoad, walls_are_not_solved_directly) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        World world = make_world({.sleeping = false});
        add_floor(world);
        Random random(seed);
        std::vector<BodyId> boxes;
        const auto place_of = [](int k) { return Vec3{k % 8 + 0.5 * (k / 8 % 2), 0.5 + k / 8, 0}; };
        for (int k = 0; k < 14; k++)
            boxes.push_back(
                add(world, {.position = place_of(k), .density = std::pow(1000, random.in(0, 1))}));
        run(world, 3);
        EXPECT_EQ(world.profile().bodies_direct, 0) << seed;
        for (int k = 0; k < 14; k++)
            EXPECT_LT(length(position_of(world, boxes[static_cast<std::size_t>(k)]) - place_of(k)),
                      1e-3)
                << "seed " << seed << ", box " << k;
    }
}

// Thirty boxes of 1 to 1000 to 1 kg: the first steps have to find the impulses.
TEST(HeavyLoad, work_of_the_direct_solver_is_limited) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    for (int k = 0; k < 30; k++)
        add(world, {.position = {0, 0.5 + k, 0},
                    .density = std::pow(1000, 1 - std::abs(k - 14.5) / 14.5)});
    std::int64_t first = 0, last = 0;
    for (int k = 0; k < 60; k++) {
        must(world.step(1.0 / 60));
        last = world.profile().direct_work;
        first = std::max(first, last);
    }
    EXPECT_EQ(world.profile().bodies_direct, 30);
    EXPECT_LT(first, 120'000) << "about 6 ms";
    EXPECT_LT(last, 8'000) << "at rest";
}

TEST(HeavyLoad, bodies_with_joints_are_not_solved_directly) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const BodyId light = add(world, {.position = {0, 0.5, 0}});
    const BodyId load = add(world, {.position = {0, 1.5, 0}, .density = 2e5});
    run(world, 0.1);
    ASSERT_EQ(world.profile().bodies_direct, 2);
    must(world.create_joint({.body_a = light, .body_b = load, .kind = DistanceJoint{}}));
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.profile().bodies_direct, 0);
}

}  // namespace
}  // namespace jostle::test
