// SPDX-License-Identifier: MIT
//
// Constraint systems of worlds, solved: weights of stacks, and names of rows.
#include "jostle/analysis/problem.h"

#include <gtest/gtest.h>

#include "jostle/analysis/methods.h"
#include "tests/support/world_builder.h"

namespace jostle::analysis {
namespace {

using namespace test;
using namespace physics;

TEST(Problem, stacked_boxes_load_the_boxes_below) {
    World world = make_world();
    add_floor(world);
    const BodyId low = add(world, {.position = {0, 0.5, 0}});
    const BodyId high =
        add(world, {.geometry = Box{{0.4, 0.4, 0.4}}, .position = {0, 1.4, 0}, .density = 500});
    run(world, 0.6);
    constexpr double h = 0.1, g = 9.81;
    const ConstraintSystem system =
        must(world.constraint_system(high, {.h = h, .position_correction = 0}));
    const Problem problem = problem_of(system);
    const Solution solution =
        solve(problem, Method::projected_gauss_seidel, {.iterations_max = 5000});
    EXPECT_TRUE(solution.converged);
    EXPECT_EQ(solution.out_of_bounds, 0);
    double on_low = 0, on_floor = 0;
    for (std::size_t k = 0; k < problem.count; k++) {
        if (system.rows[k].role != RowRole::normal) continue;
        bool names_high = false;
        for (const RowJacobian& part : system.rows[k].jacobians)
            names_high =
                names_high ||
                (part.body >= 0 && system.bodies[static_cast<std::size_t>(part.body)].id == high);
        (names_high ? on_low : on_floor) += solution.x[k];
    }
    const double high_mass = 500 * 0.8 * 0.8 * 0.8, low_mass = 1000;
    EXPECT_NEAR(on_low, high_mass * g * h, 1e-3 * high_mass * g * h);
    EXPECT_NEAR(on_floor, (high_mass + low_mass) * g * h, 1e-3 * (high_mass + low_mass) * g * h);
    EXPECT_EQ(must(world.constraint_system(low, {.h = h, .position_correction = 0})).matrix,
              system.matrix);
}

TEST(Problem, row_names_identify_joint_or_contact) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    must(world.create_joint({.body_b = box, .kind = HingeJoint{}}));
    run(world, 0.1);
    const Problem problem = problem_of(must(world.constraint_system(box)));
    EXPECT_EQ(problem.names.front(), "joint 0 rotation x");
    EXPECT_EQ(problem.names.back(), "contact 1-0 friction 2 of point 3");
    EXPECT_TRUE(problem.has_bounds());
    const std::vector<double> pressed(problem.count, 2);
    EXPECT_NEAR(problem.upper_at(problem.count - 1, pressed), 0.5 * 2, 1e-6);
    EXPECT_NEAR(problem.lower_at(problem.count - 1, pressed), -0.5 * 2, 1e-6);
}

}  // namespace
}  // namespace jostle::analysis
