// SPDX-License-Identifier: MIT
#include "jostle/analysis/analysis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/analysis/methods.h"
#include "tests/support/world_builder.h"

namespace jostle::analysis {
namespace {

using namespace test;
using namespace physics;

// Checks that redundant rows are the stated combinations of the other rows.
void expect_true(const Problem& problem, const Analysis& analysis) {
    ASSERT_EQ(analysis.redundancies.size(), problem.count - analysis.rank);
    for (const Redundancy& redundancy : analysis.redundancies)
        for (std::size_t k = 0; k < problem.count; k++) {
            double sum = 0;
            for (const Term& share : redundancy.of) sum += share.factor * problem.at(share.row, k);
            EXPECT_NEAR(problem.at(redundancy.row, k), sum, 1e-9 * problem.at(k, k))
                << to_text(redundancy, problem);
        }
}

// Two rods on the world and a bar between their ends: four hinges with parallel axes. The loop
// closes without the rotations of the third and fourth hinge and the displacement along the axis.
// Three of twenty rows are redundant, so the three bodies have one degree of freedom.
TEST(Analysis, a_four_bar_linkage_has_three_redundant_rows) {
    World world = make_world();
    const auto bar = [&](Vec3 half, Vec3 at) {
        return add(world, {.geometry = Box{half}, .position = at});
    };
    const BodyId left = bar({0.05, 0.05, 0.5}, {0, 0, -0.5}),
                 right = bar({0.05, 0.05, 0.5}, {1.5, 0, -0.5}),
                 coupler = bar({0.75, 0.05, 0.05}, {0.75, 0, -1});
    const Quat about_y = from_axis_angle({1, 0, 0}, -0.5 * pi);
    const auto hinge = [&](BodyId a, BodyId b, Vec3 at) {
        const auto in = [&](BodyId body) {
            return is_null(body) ? at : at - position_of(world, body);
        };
        must(world.create_joint({.body_a = a,
                                 .body_b = b,
                                 .frame_a = {in(a), about_y},
                                 .frame_b = {in(b), about_y},
                                 .kind = HingeJoint{},
                                 .collide_connected = false}));
    };
    hinge({}, left, {0, 0, 0});
    hinge({}, right, {1.5, 0, 0});
    hinge(left, coupler, {0, 0, -1});
    hinge(right, coupler, {1.5, 0, -1});
    const ConstraintSystem system =
        must(world.constraint_system(coupler, {.position_correction = 0}));
    const Problem problem = problem_of(system);
    ASSERT_EQ(problem.count, 20u);
    const Analysis analysis = analyse(problem);
    EXPECT_EQ(analysis.rank, 17u);
    EXPECT_EQ(6 * system.moving_bodies() - static_cast<int>(analysis.rank), 1);
    EXPECT_TRUE(analysis.singular());
    EXPECT_LT(analysis.inconsistency, 1e-12);
    expect_true(problem, analysis);
    // In the loop's last joint, out of its plane.
    for (const Redundancy& redundancy : analysis.redundancies)
        EXPECT_EQ(problem.names[redundancy.row].substr(0, 8), "joint 3 ");
    // The impulses of the three redundant rows are undetermined; the minimum-norm solution still
    // holds the coupler.
    const Solution least = solve(problem, Method::minimum_norm);
    EXPECT_LT(least.residual, 1e-10);
    EXPECT_NE(solve(problem, Method::cholesky).failed, "");
}

// A rod from the world to 1 kg, another one from there to 1000 kg: [1 -1; -1 1.001].
TEST(Analysis, computes_the_condition_number_of_a_chain_with_a_mass_ratio_of_1000) {
    World world = make_world();
    std::vector<BodyId> bodies = {BodyId{}};
    for (const double mass : {1.0, 1000.0}) {
        bodies.push_back(must(
            world.create_body({.pose = {.position = {0, -static_cast<double>(bodies.size()), 0}}},
                              {.geometry = Sphere{0.1}, .mass = mass})));
        must(world.create_joint({.body_a = bodies[bodies.size() - 2],
                                 .body_b = bodies.back(),
                                 .kind = DistanceJoint{}}));
    }
    const Problem problem = problem_of(must(world.constraint_system(bodies.back())));
    ASSERT_EQ(problem.count, 2u);
    const Analysis analysis = analyse(problem);
    const double sum = 2.001, determinant = 0.001;
    const double root = std::sqrt(sum * sum - 4 * determinant);
    const double condition = (sum + root) * (sum + root) / (4 * determinant);
    EXPECT_NEAR(condition, 4002, 0.01);
    EXPECT_NEAR(analysis.condition, condition, 1e-6 * condition);
    EXPECT_EQ(analysis.rank, 2u);
    EXPECT_TRUE(analysis.redundancies.empty());
    // With ones on the diagonal: 1 +- 1 / sqrt(1.001).
    const double off = 1 / std::sqrt(1.001);
    EXPECT_NEAR(analysis.scaled_condition, (1 + off) / (1 - off), 1e-6 * 4000);
}

// Four corners of a resting box: a plane has three degrees of freedom.
TEST(Analysis, the_fourth_corner_of_a_box_is_redundant) {
    World world = make_world();
    add(world, {.geometry = Plane{}, .friction = 0, .type = BodyType::static_body});
    const BodyId box = add(world, {.position = {0, 0.5, 0}, .friction = 0});
    run(world, 0.3);
    const Problem problem = problem_of(must(world.constraint_system(box)));
    ASSERT_EQ(problem.count, 4u);
    const Analysis analysis = analyse(problem);
    EXPECT_EQ(analysis.rank, 3u);
    ASSERT_EQ(analysis.redundancies.size(), 1u);
    EXPECT_EQ(analysis.redundancies[0].row, 3u);
    double sum = 0;
    for (const Term& share : analysis.redundancies[0].of) sum += share.factor;
    EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(Analysis, text_names_rows_and_factors) {
    Problem problem = problem_of(3, {1, 0, 0.5, 0, 1, -1, 0.5, -1, 1.25}, {1, 0, 1});
    problem.names = {"a", "b", "c"};
    const Analysis analysis = analyse(problem);
    ASSERT_EQ(analysis.redundancies.size(), 1u);
    EXPECT_EQ(to_text(analysis.redundancies[0], problem), "c = 0.5 a - b");
    EXPECT_EQ(to_text(analysis.redundancies[0], problem, 1), "c = -b and 1 more");
    // c should be 0.5; its right-hand side is 1.
    EXPECT_GT(analysis.inconsistency, 0.1);
    EXPECT_EQ(analyse(problem_of(0, {}, {})).rank, 0u);
}

}  // namespace
}  // namespace jostle::analysis
