// SPDX-License-Identifier: MIT
//
// The linear system of what hangs together, against what it is on paper and what a step does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::HasSubstr;

// A ball of 2 kg whose joint is a metre above its centre.
struct Pendulum {
    static constexpr double mass = 2, radius = 0.5, inertia = 0.4 * mass * radius * radius;
    World world = make_world();
    BodyId bob = must(world.create_body({.pose = {.position = {0, -1, 0}}},
                                        {.geometry = Sphere{radius}, .mass = mass}));
    JointId joint = must(world.create_joint({.body_b = bob, .frame_b = {.position = {0, 1, 0}}}));
};

TEST(ConstraintSystem, pendulum_matches_the_hand_computed_system) {
    const Pendulum p;
    const ConstraintSystem s = must(p.world.constraint_system(p.bob, {.h = 0.01}));
    ASSERT_EQ(s.rows.size(), 3u);
    ASSERT_EQ(s.bodies.size(), 1u);
    EXPECT_EQ(s.bodies[0].id, p.bob);
    EXPECT_EQ(s.moving_bodies(), 1);
    EXPECT_EQ(name_of(s.rows[2]), "point z");
    EXPECT_EQ(s.rows[0].joint, p.joint);
    const double across = 1 / p.mass + 1 / p.inertia, along = 1 / p.mass;
    const double matrix[3][3] = {{across, 0, 0}, {0, along, 0}, {0, 0, across}};
    for (std::size_t i = 0; i < 3; i++)
        for (std::size_t j = 0; j < 3; j++) EXPECT_NEAR(s.at(i, j), matrix[i][j], 1e-12);
    // Gravity for h; so the impulse is m g h, up.
    const double right[3] = {0, 9.81 * 0.01, 0};
    for (std::size_t i = 0; i < 3; i++) EXPECT_NEAR(s.rhs[i], right[i], 1e-12);
    EXPECT_NEAR(s.rhs[1] / s.at(1, 1), p.mass * 9.81 * 0.01, 1e-12);
    const std::vector<double> jacobian = s.jacobian();
    const double row_x[6] = {1, 0, 0, 0, 0, -1};  // v_x - w_z
    for (std::size_t k = 0; k < 6; k++) EXPECT_NEAR(jacobian[k], row_x[k], 1e-15);
    const std::vector<double> masses = s.inverse_mass();
    EXPECT_NEAR(masses[0], 1 / p.mass, 1e-15);
    EXPECT_NEAR(masses[5 * 6 + 5], 1 / p.inertia, 1e-12);
}

TEST(ConstraintSystem, right_hand_side_uses_current_velocities) {
    Pendulum p;
    must(p.world.set_velocity(p.bob, {0.5, 2, 0}, {0, 0, 0.25}));
    const ConstraintSystem s = must(p.world.constraint_system(p.joint, {.forces = false}));
    EXPECT_DOUBLE_EQ(s.h, 1.0 / 60 / p.world.substeps());
    EXPECT_NEAR(s.rows[0].rate, 0.25, 1e-12);  // v + w x r, r = (0, 1, 0)
    EXPECT_NEAR(s.rhs[0], -0.25, 1e-12);
    EXPECT_NEAR(s.rhs[1], -2, 1e-12);
    // Apart by 0.1 m: a fifth of it in h.
    must(p.world.set_pose(p.bob, {.position = {0.1, -1, 0}}));
    const ConstraintSystem apart = must(p.world.constraint_system(
        p.joint, {.h = 0.01, .forces = false, .position_correction = 0.2}));
    EXPECT_NEAR(apart.rows[0].error, 0.1, 1e-12);
    EXPECT_NEAR(apart.rows[0].bias, -0.2 * 0.1 / 0.01, 1e-9);
}

TEST(ConstraintSystem, matrix_is_j_inverse_m_j_transposed) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.geometry = Box{{0.5, 0.2, 0.3}}, .position = {0, 0.2, 0}});
    const BodyId ball = add(world, {.geometry = Sphere{0.3}, .position = {1.2, 0.3, 0.1}});
    must(world.create_joint({.body_a = box,
                             .body_b = ball,
                             .frame_a = {.position = {0.6, 0.1, 0}},
                             .frame_b = {.position = {-0.6, 0, 0}},
                             .kind = HingeJoint{.motor = {true, 1, 5}}}));
    run(world, 0.2);
    const ConstraintSystem s = must(world.constraint_system(ball));
    ASSERT_EQ(s.bodies.size(), 3u);
    EXPECT_EQ(s.moving_bodies(), 2);
    const std::size_t rows = s.rows.size(), columns = 18;
    ASSERT_EQ(rows, 6u + 12 + 3);
    const std::vector<double> j = s.jacobian(), m = s.inverse_mass();
    for (std::size_t a = 0; a < rows; a++)
        for (std::size_t b = 0; b < rows; b++) {
            double sum = a == b ? s.rows[a].softness : 0;
            for (std::size_t i = 0; i < columns; i++)
                for (std::size_t k = 0; k < columns; k++)
                    sum += j[a * columns + i] * m[i * columns + k] * j[b * columns + k];
            EXPECT_NEAR(s.at(a, b), sum, 1e-9);
        }
}

TEST(ConstraintSystem, contacts_have_a_normal_and_two_friction_rows) {
    World world = make_world();
    add_floor(world, 0.5);
    const BodyId box = add(world, {.position = {0, 0.5, 0}, .friction = 0.5});
    run(world, 0.5);
    for (const bool asleep : {false, true}) {
        if (asleep) run(world, 2);
        EXPECT_EQ(state_of(world, box).awake, !asleep);
        const ConstraintSystem s =
            must(world.constraint_system(box, {.h = 0.01, .position_correction = 0}));
        ASSERT_EQ(s.rows.size(), 12u);
        for (int k = 0; k < 12; k += 3) {
            const ConstraintRow& normal = s.rows[static_cast<std::size_t>(k)];
            EXPECT_EQ(normal.role, RowRole::normal);
            EXPECT_EQ(normal.lower, 0);
            EXPECT_GE(normal.upper, 1e300);
            // A tonne on one corner: 1/m (1 + 2 (0.5/d)^2...) of a cube: 1/m + 6 (x^2 + z^2) / m.
            EXPECT_NEAR(s.at(static_cast<std::size_t>(k), static_cast<std::size_t>(k)),
                        (1 + 6 * 0.5) / 1000, 1e-5);
            EXPECT_NEAR(s.rhs[static_cast<std::size_t>(k)], 9.81 * 0.01, 1e-3);
            for (int t = 1; t < 3; t++) {
                const ConstraintRow& tangent = s.rows[static_cast<std::size_t>(k + t)];
                EXPECT_EQ(tangent.role, RowRole::tangent);
                EXPECT_EQ(tangent.normal_row, k);
                EXPECT_NEAR(tangent.friction, 0.5, 1e-6);
                EXPECT_NEAR(tangent.upper, 0.5 * 9810.0 / 4 / 60 / 8, 0.5 * 9810.0 / 4 / 60 / 4);
                EXPECT_EQ(tangent.lower, -tangent.upper);
            }
        }
    }
}

TEST(ConstraintSystem, omits_rows_that_cannot_act) {
    World world = make_world();
    // A rope that hangs loose, and one that is just used up.
    for (const double length : {1.5, 1.0}) {
        const BodyId bob = add(world, {.geometry = Sphere{0.1}, .position = {length * 9, -1, 0}});
        must(world.create_joint({.body_b = bob,
                                 .frame_a = {.position = {length * 9, 0, 0}},
                                 .kind = DistanceJoint{.min_length = 0, .max_length = length}}));
        const auto system = world.constraint_system(bob);
        if (length > 1) {
            ASSERT_FALSE(system.ok());
            EXPECT_EQ(system.error().code, ErrorCode::failed_precondition);
            continue;
        }
        ASSERT_EQ(must(system).rows.size(), 1u);
        EXPECT_EQ(system->rows[0].role, RowRole::limit);
        EXPECT_EQ(system->rows[0].lower, 0);
    }
}

TEST(ConstraintSystem, planar_worlds_have_no_out_of_plane_rows) {
    World world = make_world({.planar = true});
    add(world, {.geometry = Plane{}, .type = BodyType::static_body});
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 0.2);
    const ConstraintSystem s = must(world.constraint_system(box));
    EXPECT_EQ(s.rows.size(), 4u);  // two points, each with a normal and one direction
    for (std::size_t k = 0; k < s.rows.size(); k++) EXPECT_GT(s.at(k, k), 0);
}

TEST(ConstraintSystem, softness_of_the_solver_is_on_the_diagonal) {
    const Pendulum p;
    const ConstraintSystem rigid = must(p.world.constraint_system(p.bob)),
                           soft = must(p.world.constraint_system(p.bob, {.solver_softness = true}));
    for (std::size_t k = 0; k < 3; k++) {
        EXPECT_EQ(rigid.rows[k].softness, 0);
        EXPECT_GT(soft.rows[k].softness, 0);
        EXPECT_NEAR(soft.at(k, k), rigid.at(k, k) + soft.rows[k].softness, 1e-12);
    }
}

TEST(ConstraintSystem, rejects_with_a_reason) {
    World world = make_world();
    const BodyId floor = add_floor(world);
    const BodyId alone = add(world, {.position = {0, 5, 0}});
    const auto error = [](const auto& result) {
        EXPECT_FALSE(result.ok());
        return result.ok() ? Error{} : result.error();
    };
    const Error unknown = error(world.constraint_system(BodyId{99, 1}));
    EXPECT_EQ(unknown.code, ErrorCode::not_found);
    EXPECT_THAT(unknown.message, HasSubstr("no body has the id {99, 1}"));
    EXPECT_EQ(error(world.constraint_system(JointId{})).code, ErrorCode::not_found);
    const Error fixed = error(world.constraint_system(floor));
    EXPECT_EQ(fixed.code, ErrorCode::failed_precondition);
    EXPECT_THAT(fixed.message, HasSubstr("not dynamic"));
    const Error empty = error(world.constraint_system(alone));
    EXPECT_EQ(empty.code, ErrorCode::failed_precondition);
    EXPECT_THAT(empty.message, HasSubstr("touches nothing"));
    EXPECT_THAT(error(world.constraint_system(alone, {.h = 1})).message, HasSubstr("h is 1"));
    EXPECT_THAT(error(world.constraint_system(alone, {.position_correction = -1})).message,
                HasSubstr("position_correction"));

    std::vector<BodyId> chain;
    for (int k = 0; k < 502; k++) {
        chain.push_back(add(world, {.geometry = Sphere{0.1}, .position = {k * 1.0, 50, 0}}));
        if (k == 0) continue;
        must(world.create_joint({.body_a = chain[static_cast<std::size_t>(k - 1)],
                                 .body_b = chain.back(),
                                 .frame_a = {.position = {0.5, 0, 0}},
                                 .frame_b = {.position = {-0.5, 0, 0}}}));
    }
    const Error large = error(world.constraint_system(chain[0]));
    EXPECT_EQ(large.code, ErrorCode::resource_exhausted);
    EXPECT_THAT(large.message, HasSubstr("502 bodies with more than 1500 rows"));
    must(world.destroy_body(chain.back()));
    EXPECT_EQ(must(world.constraint_system(chain[0])).rows.size(), 1500u);
}

}  // namespace
}  // namespace jostle::test
