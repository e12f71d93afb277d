// SPDX-License-Identifier: MIT
//
// Bodies that overlap deeply while they move far in a step.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "jostle/physics/hull.h"
#include "jostle/physics/world.h"

namespace jostle::test {
namespace {
using namespace physics;

class Burst {
public:
    explicit Burst(unsigned seed) : random_(seed) {
        for (int k = 0; k < 40; k++) {
            // One value per statement: arguments are evaluated in any order.
            const Vec3 position = 0.6 * vector();
            const BodyId body = *world_.create_body({.pose = {.position = position}}, hull());
            const Vec3 velocity = 40.0 * vector(), spin = 10.0 * vector();
            EXPECT_TRUE(world_.set_velocity(body, velocity, spin));
            bodies_.push_back(body);
        }
    }
    // The number of bodies that move by less than a tenth of their velocity times the step.
    int stuck() {
        constexpr double dt = 1.0 / 60;
        std::vector<Vec3> before;
        for (const BodyId body : bodies_) before.push_back(world_.body(body)->pose.position);
        EXPECT_TRUE(world_.step(dt));
        int count = 0;
        for (std::size_t k = 0; k < bodies_.size(); k++) {
            const BodyState now = *world_.body(bodies_[k]);
            const double expected = length(now.linear_velocity) * dt;
            count += expected > 0.02 && length(now.pose.position - before[k]) < 0.1 * expected;
        }
        return count;
    }

private:
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
    }
    Vec3 vector() {
        const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
        return {x, y, z};
    }
    ShapeDef hull() {
        std::vector<Vec3> points;
        for (int k = 0; k < 8; k++) points.push_back(0.25 * normalized(vector()));
        return {.geometry = Hull{*build_hull(points)}};
    }

    std::mt19937 random_;
    World world_ = *World::create({.sleeping = false});
    std::vector<BodyId> bodies_;
};

// The contact solver pushes overlapping bodies apart. The sweep once stopped both at the start of
// each step, so they stayed in the air: 39 bodies of these 12 bursts.
TEST(FindImpacts, overlapping_fast_bodies_move_on) {
    int stuck = 0;
    for (const unsigned seed : {4u, 15u, 16u, 17u, 21u, 22u, 23u, 26u, 29u, 30u, 32u, 33u}) {
        Burst burst(seed);
        for (int k = 0; k < 29; k++) burst.stuck();
        stuck += burst.stuck();
    }
    EXPECT_EQ(stuck, 0);
}

}  // namespace
}  // namespace jostle::test
