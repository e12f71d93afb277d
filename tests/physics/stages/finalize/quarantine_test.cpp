// SPDX-License-Identifier: MIT
//
// A body whose state ran away rests where it last was, and is reported; the others go on.
#include <gtest/gtest.h>

#include <cmath>

#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Quarantine, diverging_body_stops_at_its_last_pose_and_is_reported_once) {
    World world = make_world();
    const BodyId lost = add(world, {.position = {0, 5, 0}, .velocity = {1, 0, 0}});
    const BodyId other = add(world, {.position = {9, 5, 0}});
    must(world.step(1.0 / 60));
    const Vec3 last = position_of(world, lost);
    WorldState& state = state_of(world);
    warm_of(state, lost.index).v.x = std::nan("");
    must(world.step(1.0 / 60));
    ASSERT_EQ(world.events().quarantined.size(), 1u);
    EXPECT_EQ(world.events().quarantined[0], lost);
    EXPECT_EQ(position_of(world, lost), last);
    EXPECT_EQ(velocity_of(world, lost), Vec3{});
    must(world.step(1.0 / 60));
    EXPECT_TRUE(world.events().quarantined.empty());
    EXPECT_LT(velocity_of(world, lost).y, 0) << "it falls on from there";
    EXPECT_NEAR(velocity_of(world, other).y, -9.81 * 3 / 60, 1e-9);
    EXPECT_EQ(find_fault(state), std::nullopt);
}

// The middle one of three boxes upon each other: its impulses are as unsound as it is. They are
// forgotten, and a second later the stack stands.
TEST(Quarantine, stack_recovers_after_quarantine) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int k = 0; k < 3; k++) boxes.push_back(add(world, {.position = {0, 0.5 + k, 0}}));
    run(world, 1);
    WorldState& state = state_of(world);
    warm_of(state, boxes[1].index).w.y = std::nan("");
    must(world.step(1.0 / 60));
    EXPECT_FALSE(world.events().quarantined.empty());
    for (const BodyId body : world.events().quarantined)
        for_each_contact(state.contacts, state.bodies.cold[body.index], [&](std::uint32_t index) {
            const Contact& c = state.contacts.contacts[index];
            if (c.colour < 0) return;
            const ContactLaneRef place = lane_ref_of(state.graph, c);
            for (const auto& lambda : place.block->lambda) EXPECT_EQ(lambda[place.lane], 0);
            EXPECT_TRUE(place.meta->has(LaneFlag::needs_rebuild, place.lane));
        });
    run(world, 1);
    for (int k = 0; k < 3; k++)
        EXPECT_TRUE(
            near(position_of(world, boxes[static_cast<std::size_t>(k)]), {0, 0.5 + k, 0}, 0.02));
    EXPECT_EQ(find_fault(state), std::nullopt);
}

// What a joint carried is as unsound as its bodies: it would put them into quarantine again, in
// every step, and no saved world may hold it.
TEST(Quarantine, joint_clears_its_impulses_and_holds_again) {
    for (const JointSolver solver : {JointSolver::direct, JointSolver::iterative}) {
        World world = make_world({.joint_solver = solver});
        const BodyId ball = add(world, {.geometry = Sphere{0.2}, .position = {1, 0, 0}});
        const JointId joint = must(
            world.create_joint({.body_b = ball, .frame_b = {{-1, 0, 0}, {}}, .kind = BallJoint{}}));
        run(world, 0.5);
        WorldState& state = state_of(world);
        state.joints.joints[joint.index].point.x = std::nan("");
        warm_of(state, ball.index).w.z = std::nan("");
        must(world.step(1.0 / 60));
        EXPECT_EQ(world.events().quarantined.size(), 1u);
        EXPECT_EQ(state.joints.joints[joint.index].point, Vec3{});
        must(world.step(1.0 / 60));
        EXPECT_TRUE(world.events().quarantined.empty());
        EXPECT_TRUE(load(save(world)).ok());
        run(world, 1);
        EXPECT_LT(world.summary().max_joint_error, 1e-3);
        EXPECT_EQ(find_fault(state), std::nullopt);
    }
}

// What a body that ran away was about to meet, touched or rolled on is sound again: a world that is
// saved in the same step can be loaded, and in each that follows.
TEST(Quarantine, world_saved_afterwards_loads) {
    const double nan = std::nan(""), endless = INFINITY;
    for (const Vec3 v :
         {Vec3{nan, 0, 0}, Vec3{0, -endless, 0}, Vec3{0, 0, 1e200}, Vec3{1e30, 0, 0}})
        for (const bool turns : {false, true}) {
            World world = make_world();
            must(world.create_body({.type = BodyType::static_body},
                                   {.geometry = Plane{}, .material = {.rolling_friction = 0.1}}));
            const BodyId box = add(world, {.position = {0, 0.5, 0}});
            add(world, {.position = {0, 1.5, 0}});
            add(world, {.position = {1.05, 0.5, 0}});
            add(world, {.position = {4, 0.5, 0}, .velocity = {-20, 0, 0}});
            const BodyId ball = add(
                world, {.geometry = Sphere{0.5}, .position = {0, 0.5, 3}, .velocity = {1, 0, 0}});
            run(world, 0.1);
            WorldState& state = state_of(world);
            for (const BodyId id : {box, ball}) {
                BodyWarm& warm = warm_of(state, id.index);
                (turns ? warm.w : warm.v) = v;
            }
            for (int k = 0; k < 20; k++) {
                must(world.step(1.0 / 60));
                EXPECT_EQ(find_fault(state), std::nullopt) << "step " << k << ", v " << v.x;
                const auto loaded = load(save(world));
                EXPECT_TRUE(loaded.ok())
                    << "step " << k << ", v " << v.x << " " << v.y << " " << v.z << ", turns "
                    << turns << ": " << (loaded.ok() ? "" : loaded.error().message);
                EXPECT_TRUE(k > 0 || !world.events().quarantined.empty());
            }
        }
}

}  // namespace
}  // namespace jostle::test
