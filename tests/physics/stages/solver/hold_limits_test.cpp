// SPDX-License-Identifier: MIT
//
// Limits and joints of groups that an impact hits.
#include "physics/src/stages/solver/hold_limits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/joint_fixture.h"

namespace jostle::test {
namespace {
using namespace physics;

// A row of three boxes that hinges allow to fold by 0.2 rad is thrown at an edge, which hits the
// middle one. At no step's end are limits exceeded by a degree or ends apart by 2 mm.
TEST(HoldLimits, folding_row_stops_at_its_limits_at_any_speed) {
    for (const double speed : {3.0, 10.0, 15.0}) {
        SCOPED_TRACE(speed);
        World world = make_world();
        add_static(world, {.geometry = Box{{0.3, 0.3, 3}},
                           .rotation = from_axis_angle({0, 0, 1}, pi / 4)});
        BodyId row[3];
        for (int k = 0; k < 3; k++)
            row[k] = block(world, {.geometry = Box{{0.2, 0.05, 0.1}},
                                   .position = {0.4 * (k - 1) + 0.03, 0.8, 0},
                                   .velocity = {0, -speed, 0}});
        JointId joints[2];
        for (int k = 0; k < 2; k++)
            joints[k] = join(world, row[k], row[k + 1], HingeJoint{.limit = {true, -0.2, 0.2}},
                             {{0.2, 0, 0}, {}}, {{-0.2, 0, 0}, {}});
        double beyond = 0, gap = 0, bent = 0;
        for (int step = 0; step < 60; step++) {
            must(world.step(1.0 / 60));
            for (const JointId joint : joints) {
                const JointState state = must(world.joint(joint));
                bent = std::max(bent, absolute(state.angle));
                beyond = std::max(beyond, absolute(state.angle) - 0.2);
                gap = std::max(gap, state.separation);
            }
        }
        EXPECT_GT(bent, 0.19);
        EXPECT_LT(beyond, pi / 180);
        EXPECT_LT(gap, 2e-3);
    }
}

TEST(HoldLimits, world_continues_identically_for_any_thread_count) {
    const auto make = [](int threads) {
        World world = make_world({.threads = threads});
        add_floor(world);
        for (int pair = 0; pair < 12; pair++) {
            const Vec3 at{3.0 * pair, 1.5, 0};
            const BodyId a = block(world, {.geometry = Box{{0.2, 0.05, 0.1}},
                                           .position = at,
                                           .velocity = {0, -10, 0},
                                           .spin = {0, 0, 1.0 * pair}});
            const BodyId b = block(world, {.geometry = Box{{0.2, 0.05, 0.1}},
                                           .position = at + Vec3{0.4, 0, 0},
                                           .velocity = {0, -10, 0}});
            join(world, a, b, HingeJoint{.limit = {true, -0.2, 0.2}}, {{0.2, 0, 0}, {}},
                 {{-0.2, 0, 0}, {}});
        }
        run(world, 0.5);
        return world;
    };
    World world = make(1), other = make(4);
    EXPECT_EQ(state_hash(world), state_hash(other));
    World loaded = must(load(save(world)));
    run(world, 0.5);
    run(loaded, 0.5);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
}

}  // namespace
}  // namespace jostle::test
