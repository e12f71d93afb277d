// SPDX-License-Identifier: MIT
//
// What an impact stops between steps does not leave those behind that joints tie to it.
#include "physics/src/stages/continuous/project_joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Four links thrown end on at a thin plate, at 60 m/s a metre a step: the first stops at the plate
// within a step, and at no step's end are two ends apart by a hundredth of that. No link passes.
TEST(ProjectJoints, thrown_chain_has_closed_joints_after_each_step) {
    World world = make_world({.gravity = {}});
    add(world, {.geometry = Box{{0.01, 5, 5}}, .type = BodyType::static_body});
    std::vector<BodyId> links;
    std::vector<JointId> joints;
    const Quat level = from_rotation_vector({0, 0, -pi / 2});  // a capsule lies along y
    for (int k = 0; k < 4; k++) {
        links.push_back(add(world, {.geometry = Capsule{0.1, 0.1},
                                    .position = {-1.3 - 0.4 * k, 0.1 * k, 0},
                                    .rotation = level,
                                    .velocity = {60, 0, 0}}));
        if (k == 0) continue;
        const Vec3 between{-1.1 - 0.4 * k, 0.1 * k - 0.05, 0};
        const auto frame = [&](BodyId body) {
            return Transform{apply_inverse(state_of(world, body).pose, between), {}};
        };
        joints.push_back(must(world.create_joint({.body_a = links[links.size() - 2],
                                                  .body_b = links.back(),
                                                  .frame_a = frame(links[links.size() - 2]),
                                                  .frame_b = frame(links.back())})));
    }
    double worst = 0, furthest = -9;
    for (int step = 0; step < 30; step++) {
        must(world.step(1.0 / 60));
        for (const JointId joint : joints)
            worst = std::max(worst, must(world.joint(joint)).separation);
        for (const BodyId link : links) furthest = std::max(furthest, position_of(world, link).x);
    }
    EXPECT_LT(worst, 0.01);
    EXPECT_LT(furthest, 0);
}

// The same for hinges with limits of 0.3 rad, thrown askew: neither ends nor limits give way.
TEST(ProjectJoints, thrown_chain_stays_within_its_limits) {
    World world = make_world({.gravity = {}});
    add(world, {.geometry = Box{{0.01, 5, 5}}, .type = BodyType::static_body});
    std::vector<JointId> joints;
    BodyId last{};
    for (int k = 0; k < 4; k++) {
        const BodyId link = add(world, {.geometry = Box{{0.2, 0.05, 0.05}},
                                        .position = {-1.3 - 0.4 * k, 0, 0},
                                        .velocity = {50, 3.0 * k, 0}});
        if (k > 0)
            joints.push_back(
                must(world.create_joint({.body_a = last,
                                         .body_b = link,
                                         .frame_a = {{-0.2, 0, 0}, {}},
                                         .frame_b = {{0.2, 0, 0}, {}},
                                         .kind = HingeJoint{.limit = {true, -0.3, 0.3}}})));
        last = link;
    }
    double gap = 0, beyond = 0;
    for (int step = 0; step < 30; step++) {
        must(world.step(1.0 / 60));
        for (const JointId joint : joints) {
            gap = std::max(gap, must(world.joint(joint)).separation);
            beyond = std::max(beyond, std::abs(must(world.joint(joint)).angle) - 0.3);
        }
    }
    EXPECT_LT(gap, 2e-3);
    EXPECT_LT(beyond, 0.02);
}

}  // namespace
}  // namespace jostle::test
