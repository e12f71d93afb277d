// SPDX-License-Identifier: MIT
//
// How a body answers to torques, turned and with locked axes.
#include "physics/src/state/body_store.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

// 2, 4 and 8 kg m^2 about its own axes, 5 kg.
BodyCold uneven_body() {
    BodyCold cold;
    cold.mass = 5;
    cold.isotropic = false;
    cold.inertia = diagonal({2, 4, 8});
    invert_mass(cold);
    return cold;
}
BodyWarm turned(Quat rotation) {
    return {.rotation = rotation, .axes = to_matrix(rotation)};
}
const Quat eighth_about_x = from_axis_angle({1, 0, 0}, pi / 4);

TEST(BodyStore, inverts_mass_and_inertia) {
    const BodyCold cold = uneven_body();
    EXPECT_EQ(cold.inverse_mass, 0.2);
    EXPECT_TRUE(near(cold.inverse_inertia * Vec3{1, 1, 1}, {0.5, 0.25, 0.125}, 1e-15));
    BodyCold ball;
    ball.mass = 4;
    ball.inertia = diagonal({3, 3, 3});
    invert_mass(ball);
    EXPECT_EQ(ball.inverse_inertia, diagonal(Vec3{1, 1, 1} * (1.0 / 3)));
    BodyCold wall;
    invert_mass(wall);
    EXPECT_EQ(wall.inverse_mass, 0) << "infinite mass";
    EXPECT_EQ(wall.inverse_inertia, diagonal({0, 0, 0}));
}

// Turned by 45 degrees about x, y and z of the world lie half way between its own: both diagonal
// elements are the mean of 1/4 and 1/8, and they couple by half the difference.
TEST(BodyStore, inertia_rotates_with_the_body) {
    const Mat3 inverse = world_inverse_inertia(turned(eighth_about_x), uneven_body());
    EXPECT_TRUE(near(inverse.x, {0.5, 0, 0}, 1e-12));
    EXPECT_TRUE(near(inverse.y, {0, 0.1875, 0.0625}, 1e-12));
    EXPECT_TRUE(near(inverse.z, {0, 0.0625, 0.1875}, 1e-12));
}

// With turns about y alone it answers by the inertia about y, (4 + 8) / 2, not by a part of the
// full inverse: a door does not turn about anything but its hinge.
TEST(BodyStore, locked_rotations_invert_the_remaining_inertia) {
    BodyCold cold = uneven_body();
    cold.locks = lock_rotation_x | lock_rotation_z;
    const Mat3 inverse = world_inverse_inertia(turned(eighth_about_x), cold);
    EXPECT_TRUE(near(inverse.y, {0, 1 / 6.0, 0}, 1e-12));
    EXPECT_TRUE(near(inverse.x, {}, 1e-12));
    EXPECT_TRUE(near(inverse.z, {}, 1e-12));
    cold.locks = lock_rotation_x | lock_rotation_y | lock_rotation_z;
    EXPECT_EQ(world_inverse_inertia(turned({}), cold), diagonal({0, 0, 0}));
    EXPECT_EQ(free_rotations(cold), Vec3{});
    EXPECT_EQ(free_directions(cold), (Vec3{1, 1, 1}));
}

TEST(BodyStore, body_origin_differs_from_the_center_of_mass) {
    BodyCold cold;
    cold.local_center = {0, 1, 0};
    BodyWarm warm = turned(from_axis_angle({0, 0, 1}, pi / 2));  // its y axis points along -x
    warm.center = {10, 20, 30};
    EXPECT_TRUE(near(pose_of(warm, cold).position, {11, 20, 30}, 1e-12));
}

}  // namespace
}  // namespace jostle::test
