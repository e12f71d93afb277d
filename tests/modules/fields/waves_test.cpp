// SPDX-License-Identifier: MIT
//
// Water with waves, compared with linear theory and with finer panels.
#include "jostle/modules/waves.h"

#include <gtest/gtest.h>

#include "jostle/physics/hull.h"
#include "modules/fields/src/water_forces.h"
#include "tests/modules/fields/with_fields.h"
#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

using fields_detail::BodyFieldCache;
using fields_detail::Load;
using fields_detail::WaterScratch;

constexpr double g = 9.81;

// Force, N, and torque about the centre, N m, on one shape; panels are at most `longest`.
struct PressureSample {
    Vec3 force, torque;
    std::size_t panels = 0;
};
PressureSample sample_pressure(const Waves& waves, const Geometry& geometry, const Transform& pose,
                               double time, double longest) {
    World world = test::make_world();
    const BodyId body = test::add(
        world, {.geometry = geometry, .position = pose.position, .rotation = pose.rotation});
    BodyFieldCache body_cache;
    body_cache.set_longest_panel(longest);
    const BodyId bodies[] = {body};
    body_cache.reserve(world.body_index_end());
    body_cache.refresh(world, bodies);
    const BodyState state = test::state_of(world, body);
    constexpr double h = 1e-6;
    Load load{{body, state.pose, state.center, {}, {}, state.mass},
              body_cache.of(body),
              {0, -g, 0},
              time,
              h};
    WaterScratch scratch;
    Waves smooth = waves;
    smooth.drag = smooth.damping = 0;
    fields_detail::apply_water_forces(smooth, {smooth, g, time}, load, scratch);
    return {load.impulse * (1 / h), load.angular_impulse * (1 / h),
            body_cache.of(body).panels.front().triangles.size()};
}

Waves one_wave(double amplitude, double length) {
    return {.components = {{.amplitude = amplitude, .length = length}}};
}

TEST(Waves, crests_move_at_deep_water_speed) {
    const Waves waves = one_wave(0.5, 10);
    const double number = 2 * pi / 10, omega = square_root(g * number);
    EXPECT_NEAR(water_at(waves, g, {0, 0, 3}, 0).height, 0.5, 1e-12);
    EXPECT_NEAR(water_at(waves, g, {10, 7, 3}, 0).height, 0.5, 1e-12);
    EXPECT_NEAR(water_at(waves, g, {omega / number * 2, 0, 0}, 2).height, 0.5, 1e-12);
    // The surface moves with the water at the surface.
    const Vec3 p{1.7, -5, 0};
    const double eta = water_at(waves, g, p, 1).height;
    const double rise =
        (water_at(waves, g, p, 1 + 1e-6).height - water_at(waves, g, p, 1 - 1e-6).height) / 2e-6;
    EXPECT_NEAR(water_at(waves, g, {p.x, eta - 1e-9, 0}, 1).velocity.y, rise, 1e-6);
    EXPECT_NEAR(water_at(waves, g, {p.x, eta - 1e-9, 0}, 1).head, 0, 1e-8);
    EXPECT_EQ(water_at(waves, g, {p.x, eta + 1e-9, 0}, 1).velocity, Vec3{});
    // The flow decays to 1 / e at a depth of 1 / wave number.
    const Vec3 deep = water_at(waves, g, {0, 0.5 - 1 / number, 0}, 0).velocity;
    EXPECT_NEAR(deep.x, 0.5 * omega / std::exp(1.0), 1e-10);
}

TEST(Waves, batched_pressure_matches_single_samples) {
    const Waves waves{.level = 0.2,
                      .components = {{.amplitude = 0.4, .length = 9, .heading = 0.4},
                                     {.amplitude = 0.1, .length = 2, .heading = -1, .phase = 2}}};
    const fields_detail::WaveTrain train(waves, g, 3.3);
    test::Random random(12);
    for (const double reach : {0.2, 0.5, 2.0, 6.0}) {
        std::vector<Vec3> arms;
        for (int k = 0; k < 50; k++) arms.push_back(random.direction() * random.in(0, reach));
        const Vec3 center{random.in(-50, 50), random.in(-1, 0.5), random.in(-50, 50)};
        fields_detail::WaveTrain::Pressure pressure;
        train.sample_pressure(center, arms, reach, pressure);
        for (std::size_t k = 0; k < arms.size(); k++) {
            const auto one = train.at(center + arms[k]);
            EXPECT_NEAR(pressure.depth[k], one.depth, 1e-7);
            if (one.depth > 0) {
                EXPECT_NEAR(pressure.head[k], one.head, 1e-7);
            }
        }
    }
}

// The wave force on a small body is -grad of the dynamic pressure times its volume (Froude-Krylov
// force).
TEST(Waves, small_body_force_equals_the_pressure_gradient) {
    const Waves waves = one_wave(0.3, 20);
    const double number = 2 * pi / 20;
    const Vec3 at{3, -4, 1};
    const double height = water_at(waves, g, at, 0).height;
    const double fade = 0.3 * std::exp(-number * (height - at.y)), angle = number * at.x;
    const double size = 0.2, volume = size * size * size;
    const PressureSample still =
        sample_pressure({}, Box{{size / 2, size / 2, size / 2}}, {at, {}}, 0, 1);
    const PressureSample moved =
        sample_pressure(waves, Box{{size / 2, size / 2, size / 2}}, {at, {}}, 0, 1);
    // Wheeler's depth adds the slope of the surface above to the pressure gradient of Airy's
    // theory; both are documented.
    const double slope = -0.3 * number * std::sin(angle);
    const double along = 1000 * g * fade * number * (std::sin(angle) + std::cos(angle) * slope);
    const double up = 1000 * g * -fade * number * std::cos(angle);
    EXPECT_NEAR(still.force.y, 1000 * g * volume, 1e-6);
    EXPECT_NEAR((moved.force.x - still.force.x) / (along * volume), 1, 5e-3);
    EXPECT_NEAR((moved.force.y - still.force.y) / (up * volume), 1, 5e-3);
}

// Compares the default panels, an eighth of the wave, with panels of a fortieth.
TEST(Waves, default_panels_are_within_3_percent_of_fine_panels) {
    const double wave_length = 8;
    const Waves waves = one_wave(0.4, wave_length);
    double worst = 0, worst_torque = 0;
    test::Random random(5);
    for (int k = 0; k < 40; k++) {
        const Box box{{random.in(0.3, 4), random.in(0.3, 0.8), random.in(0.3, 1)}};
        const Transform pose{{random.in(-9, 9), random.in(-0.5, 0.3), 0},
                             from_axis_angle(random.direction(), 0.15)};
        const double time = random.in(0, 5);
        const PressureSample still = sample_pressure({}, box, pose, 0, 1e30);
        const PressureSample usual = sample_pressure(waves, box, pose, time, wave_length / 8);
        const PressureSample fine = sample_pressure(waves, box, pose, time, wave_length / 40);
        // Relative to the largest effect of a wave of this height on the body.
        const double most = 1000 * g * 0.4 * 4 * box.half_extents.x * box.half_extents.z;
        worst = maximum(worst, length(usual.force - fine.force) / most);
        worst_torque = maximum(
            worst_torque, length(usual.torque - fine.torque) / (most * length(box.half_extents)));
        EXPECT_LE(usual.panels, panels_max);
        EXPECT_GT(length(still.force), 0);
    }
    RecordProperty("worst_force_error", std::to_string(worst));
    RecordProperty("worst_torque_error", std::to_string(worst_torque));
    EXPECT_LT(worst, 0.03);
    EXPECT_LT(worst_torque, 0.03);
}

// The closed form of a small ball, compared with the same ball as a hull of many flat faces.
TEST(Waves, closed_form_of_small_balls_matches_panels) {
    const double radius = 0.4;
    std::vector<Vec3> corners;
    test::Random random(4);
    for (int k = 0; k < 250; k++) {  // a spiral from pole to pole
        const double y = 1 - (2 * k + 1) / 250.0, turn = 2.399963229728653 * k;
        const double r = square_root(1 - y * y);
        corners.push_back(Vec3{r * sin_cos(turn).cos, y, r * sin_cos(turn).sin} * radius);
    }
    const auto hull = test::must(build_hull(corners));
    const double missing = hull->volume / (4.0 / 3 * pi * radius * radius * radius);
    const Waves waves = one_wave(0.4, 8);
    double worst = 0;
    for (int k = 0; k < 60; k++) {
        const Transform pose{{random.in(-9, 9), random.in(-1.2, 0.8), 0}, {}};
        const double time = random.in(0, 5);
        const PressureSample ball = sample_pressure(waves, Sphere{radius}, pose, time, 1);
        const PressureSample flat = sample_pressure(waves, Hull{hull}, pose, time, 1);
        const double most = 1000 * g * 4.0 / 3 * pi * radius * radius * radius;
        worst = maximum(worst, length(ball.force - flat.force * (1 / missing)) / most);
    }
    RecordProperty("worst_ball_error", std::to_string(worst));
    EXPECT_LT(worst, 0.03);
}

// A body much shorter than the wave follows it; a body as long as the wave hardly heaves.
TEST(Waves, short_bodies_follow_waves_and_long_bodies_do_not) {
    const auto heave_of = [](double half_length) {
        World world = test::make_world();
        const BodyId body = test::add(
            world,
            {.geometry = Box{{half_length, 0.2, 1}}, .density = 500, .sleep_allowed = false});
        add_field(world, {.law = one_wave(0.2, 20)});
        double low = 1, high = -1;
        for (int step = 0; step < 3000; step++) {
            test::must(world.step(1.0 / 60));
            if (step < 1500) continue;
            const double y = test::position_of(world, body).y;
            low = minimum(low, y), high = maximum(high, y);
        }
        return 0.5 * (high - low);
    };
    const double shorter = heave_of(0.5), longer = heave_of(10);
    RecordProperty("heave_over_amplitude_of_1_m", std::to_string(shorter / 0.2));
    RecordProperty("heave_over_amplitude_of_20_m", std::to_string(longer / 0.2));
    EXPECT_NEAR(shorter / 0.2, 1, 0.1);
    EXPECT_LT(longer / 0.2, 0.15);
}

}  // namespace
}  // namespace jostle::modules
