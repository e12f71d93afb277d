// SPDX-License-Identifier: MIT
#include "modules/crowd/src/linear_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "jostle/physics/scalar.h"
#include "tests/support/random.h"

namespace jostle::modules::crowd_detail {
namespace {

constexpr float max_speed = 2;
constexpr double limit = 2;

std::vector<HalfPlane> random_planes(test::Random& random, int count, double low, double high) {
    std::vector<HalfPlane> planes;
    for (int k = 0; k < count; k++) {
        const physics::SinCos turn = physics::sin_cos(random.in(0, 2 * physics::pi));
        planes.push_back({static_cast<float>(turn.cos), static_cast<float>(turn.sin),
                          static_cast<float>(random.in(low, high))});
    }
    return planes;
}

double violation(const std::vector<HalfPlane>& planes, std::size_t first, std::size_t last,
                 double x, double y) {
    double worst = -1e9;
    for (std::size_t k = first; k < last; k++)
        worst = std::max(
            worst, double{planes[k].offset} - double{planes[k].x} * x - double{planes[k].y} * y);
    return worst;
}

// Calls visit(x, y) for a fine grid of velocities within the speed limit.
template <class Visit>
void for_velocities(const Visit& visit) {
    constexpr int steps = 200;
    for (int i = -steps; i <= steps; i++)
        for (int j = -steps; j <= steps; j++) {
            const double x = limit * i / steps, y = limit * j / steps;
            if (x * x + y * y <= limit * limit) visit(x, y);
        }
}

TEST(LinearProgram, permitted_wish_is_returned_unchanged) {
    const HalfPlane planes[] = {{1, 0, 0.5f}};
    const Velocity2 v = nearest_permitted_velocity(planes, 0, {1, 0.25f}, max_speed);
    EXPECT_EQ(v.x, 1);
    EXPECT_EQ(v.y, 0.25f);
}

TEST(LinearProgram, wish_is_projected_onto_the_speed_limit_and_the_planes) {
    const Velocity2 fast = nearest_permitted_velocity({}, 0, {3, 4}, max_speed);
    EXPECT_NEAR(double{fast.x}, 1.2, 1e-6);
    EXPECT_NEAR(double{fast.y}, 1.6, 1e-6);
    const HalfPlane planes[] = {{-1, 0, -0.5f}};  // x <= 0.5
    const Velocity2 v = nearest_permitted_velocity(planes, 0, {1, 0.25f}, max_speed);
    EXPECT_NEAR(double{v.x}, 0.5, 1e-6);
    EXPECT_NEAR(double{v.y}, 0.25, 1e-6);
}

TEST(LinearProgram, result_is_the_nearest_permitted_velocity) {
    test::Random random(1);
    int feasible = 0;
    for (int k = 0; k < 60; k++) {
        const auto planes = random_planes(random, 6, -2, 0.4);
        const Velocity2 wish{static_cast<float>(random.in(-1.4, 1.4)),
                             static_cast<float>(random.in(-1.4, 1.4))};
        double nearest = 1e9;
        for_velocities([&](double x, double y) {
            if (violation(planes, 0, planes.size(), x, y) <= 0)
                nearest = std::min(nearest, std::hypot(x - double{wish.x}, y - double{wish.y}));
        });
        if (nearest > 1e8) continue;
        feasible++;
        const Velocity2 v = nearest_permitted_velocity(planes, 0, wish, max_speed);
        EXPECT_LE(violation(planes, 0, planes.size(), double{v.x}, double{v.y}), 2e-6);
        EXPECT_LE(double{std::hypot(v.x - wish.x, v.y - wish.y)}, nearest + 1e-6);
    }
    EXPECT_GT(feasible, 20);
}

// The grid of the search is 1 cm/s wide, so its minimum is at most 1.5 cm/s too large.
TEST(LinearProgram, contradicting_planes_are_violated_least_and_hard_ones_obeyed) {
    test::Random random(2);
    int infeasible = 0;
    for (int k = 0; k < 60; k++) {
        auto planes = random_planes(random, 2, -1, -0.2);  // hard: standing is permitted
        const auto soft = random_planes(random, 6, 0.3, 1.2);
        planes.insert(planes.end(), soft.begin(), soft.end());
        double least = 1e9;
        for_velocities([&](double x, double y) {
            if (violation(planes, 0, 2, x, y) <= 0)
                least = std::min(least, violation(planes, 2, planes.size(), x, y));
        });
        if (least <= 0.02) continue;
        infeasible++;
        const Velocity2 v = nearest_permitted_velocity(planes, 2, {0.5f, 0}, max_speed);
        EXPECT_LE(violation(planes, 0, 2, double{v.x}, double{v.y}), 1e-5);
        EXPECT_LE(violation(planes, 2, planes.size(), double{v.x}, double{v.y}), least + 1e-4);
        EXPECT_GE(violation(planes, 2, planes.size(), double{v.x}, double{v.y}), least - 0.015);
    }
    EXPECT_GT(infeasible, 30);
}

}  // namespace
}  // namespace jostle::modules::crowd_detail
