// SPDX-License-Identifier: MIT
//
// Planar worlds: three degrees of freedom a body, two points a manifold.
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

World flat_world(Vec3 gravity = {0, -9.81, 0}) {
    return make_world({.gravity = gravity, .planar = true});
}

// A disc of mass m has m r^2 / 2, not the ball's 2/5; a box its area.
TEST(Planar, masses_match_slices) {
    World world = flat_world();
    const BodyState disc = state_of(world, add(world, {.geometry = Sphere{0.5}, .density = 10}));
    EXPECT_NEAR(disc.mass, 10 * pi * 0.25, 1e-9);
    EXPECT_NEAR(disc.inertia.z.z, 0.5 * disc.mass * 0.25, 1e-9);
    const BodyState box =
        state_of(world, add(world, {.geometry = Box{{0.5, 1, 9}}, .density = 10}));
    EXPECT_NEAR(box.mass, 10 * 2, 1e-9);
    EXPECT_NEAR(box.inertia.z.z, box.mass / 3 * 1.25, 1e-9);
}

TEST(Planar, disc_rolls_down_a_slope_at_the_analytic_acceleration) {
    const double slope = 0.2;
    World world = flat_world(Vec3{slope, -1, 0} * (9.81 / std::sqrt(1 + slope * slope)));
    add_floor(world, 1);
    const BodyId disc =
        add(world, {.geometry = Sphere{0.3}, .position = {0, 0.3, 0}, .friction = 1});
    run(world, 2);
    const double a = 2.0 / 3 * 9.81 * slope / std::sqrt(1 + slope * slope);
    EXPECT_NEAR(position_of(world, disc).x, 2 * a, 0.01 * 2 * a);
    EXPECT_EQ(position_of(world, disc).z, 0);
}

// 120 boxes and discs fall in a heap. No golden scene is planar.
TEST(Planar, every_instruction_set_gives_the_same_bits) {
    const InstructionSet usual = instruction_set();
    std::vector<std::uint64_t> hashes;
    for (const InstructionSet set : available_instruction_sets()) {
        must(use_instruction_set(set));
        World world = flat_world();
        add_floor(world, 0.6);
        Random random(4);
        for (int k = 0; k < 120; k++) {
            const Vec3 place{1.1 * (k % 12) + random.in(0, 0.4), 0.6 + 1.2 * (k / 12), 0};
            if (k % 3 == 0)
                add(world, {.geometry = Sphere{0.5}, .position = place});
            else
                add(world, {.position = place, .friction = 0.6});
        }
        run(world, 3);
        hashes.push_back(state_hash(world));
    }
    must(use_instruction_set(usual));
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

// 20 rows of boxes.
TEST(Planar, pyramid_of_210_boxes_stands_and_sleeps) {
    World world = flat_world();
    add_floor(world, 0.6);
    std::vector<std::pair<BodyId, Vec3>> boxes;
    for (int i = 0; i < 20; i++)
        for (int j = 0; j < 20 - i; j++) {
            const Vec3 place{(j - (20 - i - 1) / 2.0) * 1.05, 0.5 + i, 0};
            boxes.emplace_back(add(world, {.position = place, .friction = 0.6}), place);
        }
    run(world, 8);
    for (const auto& [box, place] : boxes)
        ASSERT_TRUE(near(position_of(world, box), place, 0.03)) << place.y;
    EXPECT_EQ(world.summary().awake_bodies, 0);
    EXPECT_LT(world.summary().max_penetration, 0.002);
}

TEST(Planar, bodies_never_leave_the_plane) {
    World world = flat_world();
    add_floor(world);
    Random random(3);
    for (int i = 0; i < 120; i++) {
        const double a = random.in(0.1, 0.3), b = random.in(0.1, 0.3);
        const Geometry kinds[] = {
            Sphere{a}, Capsule{a * 0.6, b}, Box{{a, b, 0.2}},
            Hull{must(build_hull(std::vector<Vec3>{
                {a, 0, 0.1}, {-a, 0.05, 0.1}, {0, b, 0.1}, {0.05, -b, 0.1}, {0, 0, -0.2}}))}};
        add(world, {.geometry = kinds[i % 4],
                    .position = {random.in(-2, 2), 1 + 0.2 * i, 0},
                    .rotation = from_rotation_vector({0, 0, random.in(-3, 3)}),
                    .spin = {0, 0, random.in(-5, 5)},
                    .restitution = i % 5 == 0 ? 0.5 : 0});
    }
    for (int i = 0; i < 60 * 8; i++) {
        must(world.step(1.0 / 60));
        if (i % 20 != 0) continue;
        for (const BodyId body : world.bodies()) {
            const BodyState s = state_of(world, body);
            ASSERT_EQ(s.pose.position.z, 0);
            ASSERT_EQ(s.linear_velocity.z, 0);
            ASSERT_EQ(s.angular_velocity.x, 0);
            ASSERT_EQ(s.angular_velocity.y, 0);
        }
        for (const ContactInfo& c : world.contacts()) {
            ASSERT_LE(c.count, 2);
            ASSERT_EQ(c.normal.z, 0);
        }
    }
    EXPECT_LT(world.summary().max_penetration, 0.01);
}

// A plank falls over on a plate, about the corner that it stands on: looked at only where that
// slips, its far end came down 20 cm deep in the plate.
TEST(Planar, falling_plank_lands_on_the_plate_below) {
    for (const bool plate_first : {true, false}) {
        World world = flat_world();
        add_floor(world);
        const double thin = 0.05, tall = 0.4, lean = 0.3;
        const BuiltBody plate{.geometry = Box{{1, 0.2, 1}}, .position = {0, 0.2, 0}, .friction = 1};
        const BuiltBody plank{
            .geometry = Box{{thin, tall, 1}},
            .position = {-0.3, 0.4 + tall * std::cos(lean) + thin * std::sin(lean), 0},
            .rotation = from_rotation_vector({0, 0, -lean}),
            .friction = 1};
        if (plate_first) add(world, plate);
        const BodyId falling = add(world, plank);
        if (!plate_first) add(world, plate);
        double deepest = 0;
        for (int i = 0; i < 90; i++) {
            must(world.step(1.0 / 60));
            deepest = std::max(deepest, world.summary().max_penetration);
        }
        EXPECT_LT(deepest, 0.01) << (plate_first ? "plate first" : "plank first");
        EXPECT_NEAR(position_of(world, falling).y, 0.4 + thin, 0.01);
    }
}

TEST(Planar, box_slides_the_coulomb_distance) {
    World world = flat_world();
    add_floor(world, 0.5);
    const BodyId box = add(
        world, {.geometry = Box{{0.5, 0.1, 0.5}}, .position = {0, 0.1, 0}, .velocity = {4, 0, 0}});
    run(world, 3);
    EXPECT_NEAR(position_of(world, box).x, 16 / (2 * 0.5 * 9.81), 0.02);
}

// A beam on two supports, a load at a quarter: 3/4 of the load on the near one.
TEST(Planar, beam_reactions_match_statics) {
    World world = flat_world();
    const Vec3 left{-2, 0, 0}, right{2, 0, 0};
    for (const Vec3 at : {left, right})
        must(world.create_body({.type = BodyType::static_body, .pose = {at, {}}},
                               {.geometry = Sphere{0.1}, .report_stays = true}));
    const BodyId beam =
        add(world, {.geometry = Box{{2.5, 0.1, 1}}, .position = {0, 0.2, 0}, .density = 1});
    const BodyId load = add(world, {.geometry = Box{{0.2, 0.2, 1}},
                                    .position = {-1, 0.5, 0},
                                    .density = 1000,
                                    .sleep_allowed = false});
    const double own = state_of(world, beam).mass * 9.81,
                 weight = state_of(world, load).mass * 9.81;
    run(world, 1);
    double at_left = 0, at_right = 0;
    must(world.step(1.0 / 60));
    for (const ContactStay& c : world.events().contacts)
        (c.point.x < 0 ? at_left : at_right) += c.normal_impulse * 60;
    EXPECT_NEAR(at_left, 0.75 * weight + 0.5 * own, 0.02 * weight);
    EXPECT_NEAR(at_right, 0.25 * weight + 0.5 * own, 0.02 * weight);
}

TEST(Planar, hinge_pendulum_swings) {
    World world = flat_world();
    const BodyId post = add(world, {.geometry = Sphere{0.05}, .type = BodyType::static_body});
    const BodyId rod = add(world, {.geometry = Box{{0.5, 0.05, 1}}, .position = {0.5, 0, 0}});
    const JointId hinge = must(world.create_joint(
        {.body_a = post, .body_b = rod, .frame_b = {{-0.5, 0, 0}, {}}, .kind = HingeJoint{}}));
    double worst = 0, lowest = 0;
    for (int i = 0; i < 120; i++) {
        must(world.step(1.0 / 60));
        worst = std::max(worst, must(world.joint(hinge)).separation);
        lowest = std::min(lowest, position_of(world, rod).y);
    }
    EXPECT_LT(worst, 1e-3);
    EXPECT_NEAR(lowest, -0.5, 1e-3);
}

TEST(Planar, rejects_out_of_plane_input) {
    World world = flat_world();
    EXPECT_FALSE(world.create_body({.pose = {{0, 0, 1}, {}}}).ok());
    EXPECT_FALSE(world.create_body({.pose = {{}, from_rotation_vector({1, 0, 0})}}).ok());
    EXPECT_FALSE(world.create_body({.linear_velocity = {0, 0, 1}}).ok());
    EXPECT_FALSE(world.create_body({}, {.geometry = Cylinder{}}).ok());
    EXPECT_FALSE(World::create({.gravity = {0, 0, 1}, .planar = true}).ok());
    EXPECT_TRUE(world.create_body({}, {.geometry = Sphere{}}).ok());
}

}  // namespace
}  // namespace jostle::test
