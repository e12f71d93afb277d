// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/group_fields.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double pull = 4 * pi * pi;  // m^3/s^2: a circle of 1 m takes a second

// Two bodies on a rod around a point that pulls: energy and the momentum about it are kept, and
// halving the step divides the error by four.
double drift_of_dumbbell(int substeps) {
    World world = make_world({.gravity = {}, .substeps = substeps});
    must(world.create_field(
        {.force = RadialField{
             .strength = -pull, .falloff = 2, .min_distance = 1e-3, .per_mass = true}}));
    const BodyId a =
        add(world, {.geometry = Sphere{0.1}, .position = {1, 0, 0}, .velocity = {0, 5.5, 0}});
    const BodyId b =
        add(world, {.geometry = Sphere{0.1}, .position = {1.4, 0, 0}, .velocity = {0, 7.7, 0}});
    must(world.create_joint(
        {.body_a = a, .body_b = b, .kind = DistanceJoint{.min_length = 0.4, .max_length = 0.4}}));
    const auto energy = [&] {
        double sum = 0;
        for (const BodyId id : {a, b}) {
            const BodyState body = state_of(world, id);
            sum +=
                0.5 * dot(body.linear_velocity, body.linear_velocity) - pull / length(body.center);
        }
        return sum;
    };
    const double before = energy();
    double worst = 0;
    for (int k = 0; k < 120; k++) {
        must(world.step(1.0 / 60));
        EXPECT_EQ(world.profile().joints_direct, 1);
        worst = maximum(worst, absolute(energy() / before - 1));
    }
    return worst;
}

TEST(GroupFields, are_second_order_and_conserve_energy) {
    const double coarse = drift_of_dumbbell(4), fine = drift_of_dumbbell(8);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_GT(coarse / fine, 3.5);
    EXPECT_LT(coarse / fine, 4.5);
}

// A pendulum that a field does not reach moves to the bit as without.
TEST(GroupFields, ignore_bodies_out_of_reach) {
    World world = make_world(), other = make_world();
    must(other.create_field(
        {.force = RadialField{.strength = 10}, .region = Aabb{{10, 0, 0}, {20, 10, 10}}}));
    BodyState ends[2];
    int k = 0;
    for (World* of : {&world, &other}) {
        const BodyId bob = add(*of, {.geometry = Sphere{0.2}, .position = {1, 100, 0}});
        must(of->create_joint({.body_b = bob,
                               .frame_a = {.position = {0, 100, 0}},
                               .frame_b = {.position = {-1, 0, 0}}}));
        run(*of, 1);
        EXPECT_EQ(of->profile().joints_direct, 1);
        ends[k++] = state_of(*of, bob);
    }
    EXPECT_EQ(ends[0].center, ends[1].center);
    EXPECT_EQ(ends[0].linear_velocity, ends[1].linear_velocity);
}

}  // namespace
}  // namespace jostle::test
