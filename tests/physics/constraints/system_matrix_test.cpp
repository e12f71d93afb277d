// SPDX-License-Identifier: MIT
#include "physics/src/constraints/system_matrix.h"

#include <gtest/gtest.h>

namespace jostle::physics {
namespace {

// Two carts on a line, of 1 and 4 kg, and one that stands still.
ConstraintSystem carts() {
    ConstraintSystem s;
    for (const double mass : {1.0, 4.0, 0.0}) {
        SystemBody body{.moves = mass > 0, .inverse_inertia = diagonal({0, 0, 0})};
        if (mass > 0) body.inverse_mass = Vec3{1, 1, 1} * (1 / mass);
        s.bodies.push_back(body);
    }
    s.bodies[0].linear_velocity = {3, 0, 0};
    s.bodies[0].free_linear_velocity = {2, 0, 0};
    s.bodies[2].linear_velocity = s.bodies[2].free_linear_velocity = {-1, 0, 0};
    const auto join = [&](int a, int b) {
        s.rows.push_back(
            {.jacobians = {{a, {-1, 0, 0}, {}}, {b, {1, 0, 0}, {}}}, .jacobian_count = 2});
    };
    join(0, 1);
    join(1, 2);
    return s;
}

TEST(SystemMatrix, contains_the_coupling_of_rows) {
    ConstraintSystem s = carts();
    s.rows[0].softness = 0.5;
    s.rows[0].bias = 7;
    assemble(s);
    EXPECT_DOUBLE_EQ(s.at(0, 0), 1 + 0.25 + 0.5);
    EXPECT_DOUBLE_EQ(s.at(0, 1), -0.25);
    EXPECT_DOUBLE_EQ(s.at(1, 0), -0.25);
    EXPECT_DOUBLE_EQ(s.at(1, 1), 0.25);
    EXPECT_DOUBLE_EQ(s.rhs[0], 7 + 2);
    EXPECT_DOUBLE_EQ(s.rhs[1], 1);
    EXPECT_DOUBLE_EQ(rate_now(s.rows[0], s.bodies), -3);
    EXPECT_DOUBLE_EQ(rate_by_forces(s.rows[0], s.bodies), -2);
    EXPECT_DOUBLE_EQ(response_of(s.rows[0], s.bodies), 1.25);
}

TEST(SystemMatrix, softness_of_a_block_is_proportional_to_it) {
    ConstraintSystem s = carts();
    s.rows[0].block = s.rows[1].block = 4;
    s.rows[0].softness = 1.25 * 0.1;
    s.rows[1].softness = 0.25 * 0.1;
    assemble(s);
    EXPECT_NEAR(s.at(0, 0), 1.25 * 1.1, 1e-15);
    EXPECT_NEAR(s.at(1, 1), 0.25 * 1.1, 1e-15);
    EXPECT_NEAR(s.at(0, 1), -0.25 * 1.1, 1e-15);
    EXPECT_EQ(s.at(0, 1), s.at(1, 0));
}

TEST(SystemMatrix, names_contain_role_and_direction) {
    EXPECT_EQ(name_of({.role = RowRole::rotation, .axis = 1}), "rotation y");
    EXPECT_EQ(name_of({.role = RowRole::motor, .axis = 2}), "motor z");
    EXPECT_EQ(name_of({.role = RowRole::gear}), "gear");
    EXPECT_EQ(name_of({.role = RowRole::normal, .point = 2}), "normal of point 2");
    EXPECT_EQ(name_of({.role = RowRole::tangent, .axis = 1}), "friction 2 of point 0");
}

}  // namespace
}  // namespace jostle::physics
