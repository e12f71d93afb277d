// SPDX-License-Identifier: MIT
//
// Nothing flies through a wall, and nothing is held up by a wall that it passes.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

const double speeds[] = {5, 10, 30, 60, 100, 200};  // m/s

BodyId add_wall(World& world, double half_thickness) {
    return add(world, {.geometry = Box{{half_thickness, 2, 2}}, .type = BodyType::static_body});
}

// Where in a step the wall is met makes the difference: 16 phases of each.
int pass_through(const Geometry& geometry, double speed, double half_thickness) {
    int passed = 0;
    for (int phase = 0; phase < 16; phase++) {
        World world = make_world({.gravity = {}});
        add_wall(world, half_thickness);
        const BodyId bullet = add(world, {.geometry = geometry,
                                          .position = {-3 - phase * speed / 60 / 16, 0.1, 0.2},
                                          .velocity = {speed, 0, 0}});
        run(world, 4 / speed + 0.3);
        passed += position_of(world, bullet).x > 0;
    }
    return passed;
}

TEST(FastBodies, stop_at_a_wall_of_two_centimetres) {
    for (const double speed : speeds) {
        EXPECT_EQ(pass_through(Sphere{0.05}, speed, 0.01), 0) << speed << " m/s";
        EXPECT_EQ(pass_through(Capsule{0.03, 0.05}, speed, 0.01), 0) << speed << " m/s";
        EXPECT_EQ(pass_through(Box{{0.05, 0.05, 0.05}}, speed, 0.01), 0) << speed << " m/s";
    }
}

TEST(FastBodies, stop_at_a_thick_wall) {
    for (const double speed : speeds)
        EXPECT_EQ(pass_through(Sphere{0.05}, speed, 0.5), 0) << speed << " m/s";
}

// Thrown by hand right before the wall: its neighbours must be found before it moves.
TEST(FastBodies, launched_from_rest_stop_at_the_wall) {
    for (const bool by_impulse : {false, true}) {
        World world = make_world({.gravity = {}});
        add_wall(world, 0.01);
        const BodyId ball = add(world, {.geometry = Sphere{0.1}, .position = {-1, 0, 0}});
        run(world, 0.2);
        const double mass = state_of(world, ball).mass;
        if (by_impulse)
            must(world.apply_impulse(ball, {100 * mass, 0, 0}, {-1, 0, 0}));
        else
            must(world.set_velocity(ball, {100, 0, 0}, {}));
        run(world, 0.5);
        EXPECT_LT(position_of(world, ball).x, 0);
    }
}

TEST(FastBodies, do_not_tunnel_through_each_other_head_on) {
    for (int phase = 0; phase < 16; phase++) {
        World world = make_world({.gravity = {}});
        const double shift = phase * 60.0 / 60 / 16;
        const BodyId a =
            add(world,
                {.geometry = Sphere{0.05}, .position = {-3 - shift, 0, 0}, .velocity = {60, 0, 0}});
        const BodyId b =
            add(world, {.geometry = Sphere{0.05}, .position = {3, 0, 0}, .velocity = {-60, 0, 0}});
        run(world, 0.3);
        EXPECT_LT(position_of(world, a).x, position_of(world, b).x) << "phase " << phase;
    }
}

TEST(FastBodies, pass_an_edge_without_contact) {
    for (const double speed : speeds)
        for (int phase = 0; phase < 16; phase++) {
            World world = make_world({.gravity = {}});
            add_wall(world, 0.5);
            const BodyId ball = add(world, {.geometry = Sphere{0.05},
                                            .position = {-3 - phase * speed / 60 / 16, 2.1, 0},
                                            .velocity = {speed, 0, 0}});
            run(world, 10 / speed);
            EXPECT_TRUE(near(velocity_of(world, ball), {speed, 0, 0}, 1e-9)) << speed << " m/s";
        }
}

}  // namespace
}  // namespace jostle::test
