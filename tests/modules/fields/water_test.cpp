// SPDX-License-Identifier: MIT
//
// Still water of the module, compared with closed forms.
#include <gtest/gtest.h>

#include "tests/modules/fields/floating.h"
#include "tests/modules/fields/with_fields.h"
#include "tests/support/near.h"

namespace jostle::modules {
namespace {

void add_still_water(World& world, double drag, double damping) {
    add_field(world, {.law = Waves{.drag = drag, .damping = damping}});
}

TEST(Water, draft_matches_archimedes) {
    for (const double density : {100.0, 400.0, 800.0}) {
        const double error = draft_error(add_still_water, density);
        RecordProperty("draft_error_" + std::to_string(static_cast<int>(density)),
                       std::to_string(error));
        EXPECT_NEAR(error, 0, 5e-3) << density;
    }
}

// Depth of the lowest point of a ball, from the volume of a cap: pi d^2 (3 r - d) / 3.
TEST(Water, ball_draft_matches_its_spherical_cap) {
    for (const double density : {200.0, 500.0, 700.0}) {
        World world = test::make_world();
        const BodyId ball =
            test::add(world, {.geometry = Sphere{0.5}, .density = density, .sleep_allowed = false});
        add_still_water(world, 5, 4);
        test::run(world, 30);
        const double cap_volume = density / 1000 * 4.0 / 3 * 0.125;  // divided by pi
        double depth = 0.5;
        for (int k = 0; k < 60; k++)
            depth -= (depth * depth * (1.5 - depth) / 3 - cap_volume) / (depth * (1 - depth));
        const double found = 0.5 - y_of(world, ball);
        RecordProperty("ball_error_" + std::to_string(static_cast<int>(density)),
                       std::to_string(found / depth - 1));
        EXPECT_NEAR(found / depth, 1, 5e-3) << density;
    }
}

// At half the density it floats at its axis, regardless of its end faces.
TEST(Water, half_density_log_floats_at_its_axis) {
    for (const double density : {150.0, 300.0, 500.0, 800.0}) {
        World world = test::make_world();
        const BodyId log = test::add(world, {.geometry = Cylinder{0.3, 1.5},
                                             .rotation = from_axis_angle({0, 0, 1}, pi / 2),
                                             .density = density,
                                             .sleep_allowed = false});
        add_still_water(world, 5, 4);
        test::run(world, 30);
        // The area of a circle below a chord at height c r: acos(-c) + c sqrt(1 - c^2) = pi
        // density.
        double c = 0;
        for (int k = 0; k < 60; k++)
            c -= (arc_tangent(square_root(1 - c * c), -c) + c * square_root(1 - c * c) -
                  pi * density / 1000) /
                 (2 * square_root(1 - c * c));
        const double off = y_of(world, log) / 0.3 + c;
        RecordProperty("log_error_" + std::to_string(static_cast<int>(density)),
                       std::to_string(off));
        EXPECT_NEAR(off, 0, 0.01) << density;
    }
}

TEST(Water, heave_period_matches_the_draft) {
    const double expected = 2 * pi * square_root(0.2 / 9.81);
    const double period = heave_period(add_still_water, 400, 0.05);
    RecordProperty("heave_error", std::to_string(period / expected - 1));
    EXPECT_NEAR(period / expected, 1, 0.01);
}

TEST(Water, box_floats_upright_exactly_when_gm_is_positive) {
    expect_upright_exactly_when_gm_is_positive(add_still_water);
}

// A raft with a small lean: T = 2 pi k / sqrt(g GM), where k is its radius of gyration.
TEST(Water, roll_period_matches_the_metacentric_height) {
    const double width = 2, height = 0.5, s = 0.5;
    World world = test::make_world();
    const BodyId raft = test::add(world, {.geometry = Box{{width / 2, height / 2, 4}},
                                          .rotation = from_axis_angle({0, 0, 1}, 0.02),
                                          .density = 1000 * s,
                                          .sleep_allowed = false});
    add_still_water(world, 0, 0);
    std::vector<double> crossings;
    double before = 1;
    for (int step = 1; crossings.size() < 6 && step < 3000; step++) {
        test::must(world.step(1.0 / 60));
        const double now = test::state_of(world, raft).pose.rotation.z;
        if (before > 0 && now <= 0) crossings.push_back((step - now / (now - before)) / 60);
        before = now;
    }
    ASSERT_EQ(crossings.size(), 6u);
    const double gm = height * (0.5 * s - 0.5) + width * width / (12 * s * height);
    const double gyration = square_root((width * width + height * height) / 12);
    const double expected = 2 * pi * gyration / square_root(9.81 * gm);
    const double period = (crossings.back() - crossings.front()) / 5;
    RecordProperty("roll_error", std::to_string(period / expected - 1));
    EXPECT_NEAR(period / expected, 1, 0.01);
}

TEST(Water, submerged_body_is_lifted_by_displaced_weight) {
    for (const Geometry& geometry :
         {Geometry{Box{{0.3, 0.2, 0.5}}}, Geometry{Sphere{0.4}}, Geometry{Cylinder{0.3, 0.5}},
          Geometry{Cone{0.3, 0.5}}, Geometry{Capsule{0.2, 0.5}}}) {
        World world = test::make_world();
        const BodyId body = test::add(world, {.geometry = geometry,
                                              .position = {3, -50, 1},
                                              .rotation = from_axis_angle({1, 2, 3}, 1),
                                              .density = 2000});
        add_field(world, {.law = Waves{.drag = 0, .damping = 0}});
        test::run(world, 1);
        EXPECT_TRUE(test::near(test::velocity_of(world, body), {0, -9.81 / 2, 0}, 1e-6));
        EXPECT_LT(length(test::state_of(world, body).angular_velocity), 1e-6);
    }
}

// Terminal speed of a heavy ball: sqrt(2 (m - rho V) g / rho c A).
TEST(Water, sinking_body_reaches_terminal_speed) {
    World world = test::make_world();
    const BodyId ball = test::add(
        world, {.geometry = Box{{0.5, 0.5, 0.5}}, .position = {0, -5, 0}, .density = 3000});
    add_field(world, {.law = Waves{.drag = 1, .damping = 0}});
    test::run(world, 10);
    const double end = square_root(2 * 2000 * 9.81 / 1000);
    EXPECT_NEAR(-test::velocity_of(world, ball).y / end, 1, 5e-3);
}

TEST(Water, current_carries_floating_bodies_and_damps_spin) {
    World world = test::make_world();
    const BodyId raft =
        test::add(world, {.geometry = Box{{1, 0.2, 1}}, .spin = {0, 3, 0}, .density = 500});
    add_field(world, {.law = Waves{.flow = {1.5, 0, 0}}});
    test::run(world, 60);
    EXPECT_NEAR(test::velocity_of(world, raft).x, 1.5, 0.02);
    EXPECT_LT(length(test::state_of(world, raft).angular_velocity), 0.05);
}

}  // namespace
}  // namespace jostle::modules
