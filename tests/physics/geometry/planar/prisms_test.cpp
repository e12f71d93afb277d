// SPDX-License-Identifier: MIT
//
// Prisms made of polygons: what they weigh, and how they lie in worlds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jostle/physics/polygon.h"
#include "physics/src/geometry/mass_properties.h"
#include "tests/support/grid_oracle.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;
using testing::HasSubstr;

template <class T>
std::string message_of(const Result<T>& result) {
    return result.ok() ? "no error" : result.error().message;
}

const std::vector<Vec2> corner{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};  // an L

TEST(Prisms, have_the_volume_of_the_polygon) {
    Random random(91);
    for (int round = 0; round < 300; round++) {
        const auto polygon = real(random_polygon(random, 16, 12));
        double volume = 0;
        for (const auto& prism : must(build_prisms(polygon, 0.5))) volume += prism->volume;
        ASSERT_NEAR(volume, absolute(signed_area(polygon)), 1e-9);
    }
}

// Three squares of 1 m^2: the centre is the mean of theirs.
TEST(Prisms, compound_has_the_mass_of_three_boxes) {
    const Geometry compound = Compound{must(build_prism_compound(corner, 0.5))};
    const MassProperties mass = mass_of(compound, 10);
    EXPECT_NEAR(mass.mass, 30, 1e-9);
    EXPECT_TRUE(near(mass.center, {2.5 / 3, 2.5 / 3, 0}, 1e-12));
    // Each about its own centre 10 (1 + 1) / 12, and 10 times the square of how far that lies off.
    EXPECT_NEAR(mass.inertia.z.z, 3 * 20.0 / 12 + 10 * (2.0 / 9 + 5.0 / 9 + 5.0 / 9), 1e-9);
}

// In a planar world: one body of several shapes. It stands on its foot, which is as wide as it is.
TEST(Prisms, come_to_rest_in_a_planar_world) {
    World world = make_world({.gravity = {0, -9.81, 0}, .planar = true});
    add_floor(world);
    const BodyId body = must(world.create_body({.pose = {{0, 0, 0}, {}}}));
    for (const auto& prism : must(build_prisms(corner, 0.5)))
        must(world.create_shape(body, {.geometry = Hull{prism}}));
    run(world, 3);
    EXPECT_TRUE(near(position_of(world, body), {0, 0, 0}, 2e-3));
}

TEST(Prisms, polygon_of_a_hundred_corners_is_split_to_the_hull_limit) {
    std::vector<Vec2> round;
    for (int k = 0; k < 300; k++) {
        const SinCos a = sin_cos(k * (2 * pi / 300));
        round.push_back({a.cos, a.sin});
    }
    double volume = 0;
    const auto prisms = must(build_prisms(round, 0.5));
    EXPECT_GT(prisms.size(), 1u);
    for (const auto& prism : prisms) volume += prism->volume;
    EXPECT_NEAR(volume, signed_area(round), 1e-5 * static_cast<double>(prisms.size()));
}

TEST(Prisms, drop_slivers) {
    // A square with a corner that sticks out by a micrometre: two parts at most, one of them none.
    const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0.5, 1 - 1e-6}, {0, 1}};
    double volume = 0;
    for (const auto& prism : must(build_prisms(square, 0.5))) volume += prism->volume;
    EXPECT_NEAR(volume, 1, 1e-5);
    EXPECT_THAT(message_of(build_prisms(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1e-7}}, 1)),
                HasSubstr("too thin"));
}

TEST(Prisms, errors_name_the_offending_corners) {
    EXPECT_THAT(message_of(build_prisms(corner, 0)), HasSubstr("half_depth is 0"));
    EXPECT_THAT(message_of(build_prisms(std::vector<Vec2>{{0, 0}, {2e4, 0}, {0, 1}}, 1)),
                HasSubstr("polygon[1] is (20000, 0)"));
    EXPECT_THAT(message_of(build_prism_compound(std::vector<Vec2>{{0, 0}, {1, 0}}, 1)),
                HasSubstr("polygon has 2 points"));
}

}  // namespace
}  // namespace jostle::test
