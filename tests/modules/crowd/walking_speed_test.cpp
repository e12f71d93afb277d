// SPDX-License-Identifier: MIT
#include "modules/crowd/src/walking_speed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jostle/modules/exponential.h"
#include "tests/modules/crowd/people.h"

namespace jostle::modules {
namespace {

using physics::Vec2;
using physics::Vec3;

double weidmann(double density) {
    return 1.34 * (1 - std::exp(-1.913 * (1 / density - 1 / 5.4)));
}

TEST(WalkingSpeed, follows_the_diagram_of_weidmann) {
    for (const double density : {0.3, 0.5, 1.0, 1.75, 3.0, 4.5})
        EXPECT_NEAR(1.34 * crowd_detail::relative_walking_speed(density), weidmann(density), 1e-9);
    EXPECT_EQ(crowd_detail::relative_walking_speed(6), 0.02);
    // The largest flow is 1.22 persons per metre and second, at 1.75 per m^2 (Weidmann 1993).
    EXPECT_NEAR(1.34 * crowd_detail::relative_walking_speed(1.75) * 1.75, 1.22, 0.01);
}

TEST(WalkingSpeed, exponential_agrees_with_the_c_library) {
    for (double x = 0; x > -40; x -= 0.37) EXPECT_NEAR(exp_of_negative(x) / std::exp(x), 1, 1e-11);
    EXPECT_EQ(exp_of_negative(-800), 0);
}

TEST(WalkingSpeed, walls_do_not_count_as_free_space) {
    const double open = crowd_detail::density_ahead(2, 5, {});
    EXPECT_NEAR(open, 5.5 / (0.5 * physics::pi * 4), 1e-12);
    // A wall through the centre halves the area.
    const crowd_detail::NearWall wall{{1, 0}, 0, false};
    EXPECT_NEAR(crowd_detail::density_ahead(2, 5, {&wall, 1}), 2 * open, 1e-9);
}

// A corridor of 3 m that is closed into a ring, as in pedestrian experiments. The flow per metre of
// width agrees with the diagram within 15 %.
double ring_flow_error(double density) {
    constexpr double inner = 13.5, outer = 16.5;
    constexpr int sides = 96;
    physics::World world;
    Crowd& crowd = add_crowd(world);
    for (int k = 0; k < sides; k++) {
        const auto a = physics::sin_cos(2 * physics::pi * k / sides);
        const auto b = physics::sin_cos(2 * physics::pi * (k + 1) / sides);
        test::must(crowd.add_wall(Vec2{a.cos, a.sin} * inner, Vec2{b.cos, b.sin} * inner));
        test::must(crowd.add_wall(Vec2{a.cos, a.sin} * outer, Vec2{b.cos, b.sin} * outer));
    }
    const double area = physics::pi * (outer * outer - inner * inner);
    const int rows = static_cast<int>(3 * std::sqrt(density) + 0.5);
    std::vector<AgentId> ids;
    for (int row = 0; row < rows; row++) {
        const double at = inner + 3 * (row + 0.5) / rows;
        const int count = static_cast<int>(density * 2 * physics::pi * at * 3 / rows);
        for (int k = 0; k < count; k++) {
            const auto turn = physics::sin_cos(2 * physics::pi * (k + 0.5 * (row % 2)) / count);
            ids.push_back(test::must(crowd.add(
                world, {.position = {at * turn.cos, 0, at * turn.sin}, .slows_in_crowds = true})));
        }
    }
    double sum = 0;
    constexpr int settling = 300, steps = 600;
    for (int step = 0; step < steps; step++) {
        for (const AgentId id : ids) {
            const AgentState state = test::must(crowd.state(world, id));
            const Vec3 along =
                normalized(Vec3{-state.position.z, 0, state.position.x}, Vec3{1, 0, 0});
            if (step >= settling) sum += dot(state.velocity, along);
            test::must(crowd.set_destination(id, moving(along * 1.34)));
        }
        test::must(world.step(1.0 / 60));
    }
    const double people = static_cast<double>(ids.size()), real = people / area;
    const double speed = sum / ((steps - settling) * people);
    return speed / weidmann(real) - 1;
}

TEST(WalkingSpeed, flow_through_a_corridor_matches_the_fundamental_diagram) {
    for (const double density : {0.5, 1.0, 1.75, 3.0, 4.0}) {
        const double error = ring_flow_error(density);
        RecordProperty("percent_" + std::to_string(static_cast<int>(100 * density)),
                       std::to_string(100 * error));
        EXPECT_LT(std::abs(error), 0.15) << density << " per m^2";
    }
}

}  // namespace
}  // namespace jostle::modules
