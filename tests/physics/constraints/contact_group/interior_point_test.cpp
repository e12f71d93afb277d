// SPDX-License-Identifier: MIT
//
// Point masses with closed forms: y = M^1/2 v, so a row of a mass m has G = direction / sqrt(m).
#include "physics/src/constraints/contact_group/interior_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace jostle::test {
namespace {
using namespace physics;

constexpr double tolerance = 1e-9;  // m/s

// A contact of two point masses along y, with friction along x and z. b: -1 for the floor.
void add_contact(GroupProblem& problem, int a, int b, const std::vector<double>& masses, double mu,
                 const double (&free_a)[3], const double (&free_b)[3]) {
    problem.contacts.push_back(
        {static_cast<int>(problem.rows.size()), 1, static_cast<int>(problem.discs.size()), 1});
    problem.discs.push_back({static_cast<int>(problem.rows.size()) + 1, 2, mu});
    for (const int axis : {1, 0, 2}) {
        GroupRow row{.a = a, .b = b};
        row.ga[axis] = 1 / std::sqrt(masses[static_cast<std::size_t>(a)]);
        row.response = row.ga[axis] * row.ga[axis];
        row.offset = free_a[axis];
        if (b >= 0) {
            row.gb[axis] = -1 / std::sqrt(masses[static_cast<std::size_t>(b)]);
            row.response += row.gb[axis] * row.gb[axis];
            row.offset -= free_b[axis];
        }
        problem.rows.push_back(row);
    }
}

struct Solved {
    bool solved = false;
    int iterations = 0;
    std::vector<double> y;
};
Solved solve(GroupProblem& problem, const std::vector<double>& masses) {
    problem.root.clear();
    for (const double mass : masses) problem.root.push_back(1 / std::sqrt(mass));
    SkylineCholesky matrix;
    std::vector<int> first(masses.size(), 0);
    matrix.set_pattern(first);
    Solved result;
    result.y.resize(6 * masses.size());
    InteriorPoint solver;
    result.solved = solver.solve(problem, matrix, result.y, tolerance);
    result.iterations = solver.iterations();
    return result;
}

constexpr double none[3] = {};

TEST(InteriorPoint, falling_mass_is_stopped) {
    GroupProblem problem;
    problem.clear(1);
    add_contact(problem, 0, -1, {2}, 0.5, {0, -0.1, 0}, none);
    const Solved result = solve(problem, {2});
    EXPECT_TRUE(result.solved);
    EXPECT_NEAR(problem.rows[0].impulse, 0.2, 1e-8);
    EXPECT_NEAR(problem.rows[1].impulse, 0, 1e-8);
}

TEST(InteriorPoint, rising_mass_is_not_held) {
    GroupProblem problem;
    problem.clear(1);
    add_contact(problem, 0, -1, {2}, 0.5, {1, 0.1, 0}, none);
    const Solved result = solve(problem, {2});
    EXPECT_TRUE(result.solved);
    for (const GroupRow& row : problem.rows) EXPECT_EQ(row.impulse, 0);
}

// Sliding at 1 m/s obliquely: friction of mu times the load, opposed to the motion.
TEST(InteriorPoint, sliding_mass_feels_friction_of_mu_times_its_load) {
    GroupProblem problem;
    problem.clear(1);
    add_contact(problem, 0, -1, {3}, 0.5, {0.6, -0.1, 0.8}, none);
    const Solved result = solve(problem, {3});
    EXPECT_TRUE(result.solved);
    EXPECT_NEAR(problem.rows[0].impulse, 0.3, 1e-8);
    EXPECT_NEAR(problem.rows[1].impulse, -0.6 * 0.15, 1e-5);
    EXPECT_NEAR(problem.rows[2].impulse, -0.8 * 0.15, 1e-5);
}

TEST(InteriorPoint, slow_mass_is_held_by_friction) {
    GroupProblem problem;
    problem.clear(1);
    add_contact(problem, 0, -1, {3}, 0.5, {0.02, -0.1, -0.01}, none);
    EXPECT_TRUE(solve(problem, {3}).solved);
    EXPECT_NEAR(problem.rows[1].impulse, -0.06, 1e-8);
    EXPECT_NEAR(problem.rows[2].impulse, 0.03, 1e-8);
}

// Ten masses on top of each other, of ratios up to a million.
TEST(InteriorPoint, column_of_any_mass_ratio_takes_few_iterations) {
    for (const double ratio : {1.0, 30.0, 1e3, 1e6}) {
        std::vector<double> masses;
        for (int k = 0; k < 10; k++) masses.push_back(k % 2 == 0 ? 1 : ratio);
        GroupProblem problem;
        problem.clear(10);
        const double falls[3] = {0, -0.02, 0};
        for (int k = 0; k < 10; k++) add_contact(problem, k, k - 1, masses, 0.5, falls, falls);
        problem.contacts[0].load = 5 + 5 * ratio;
        for (GroupRow& row : problem.rows)
            if (row.b >= 0) row.offset = 0;
        const Solved result = solve(problem, masses);
        EXPECT_TRUE(result.solved) << ratio;
        EXPECT_LE(result.iterations, 20) << ratio;
        double load = 0;
        for (int k = 9; k >= 0; k--) {
            load += 0.02 * masses[static_cast<std::size_t>(k)];
            EXPECT_NEAR(problem.rows[static_cast<std::size_t>(3 * k)].impulse / load, 1, 1e-4)
                << "contact " << k << ", ratio " << ratio;
        }
    }
}

TEST(InteriorPoint, solution_still_solves_until_the_load_changes) {
    GroupProblem problem;
    problem.clear(1);
    add_contact(problem, 0, -1, {2}, 0.5, {0, -0.1, 0}, none);
    problem.root = {1 / std::sqrt(2.0)};
    SkylineCholesky matrix;
    const std::vector<int> first{0};
    matrix.set_pattern(first);
    std::vector<double> y(6);
    InteriorPoint solver;
    ASSERT_TRUE(solver.solve(problem, matrix, y, tolerance));
    EXPECT_TRUE(solver.still_solves(problem, y, tolerance));
    problem.rows[0].offset = -0.11;
    EXPECT_FALSE(solver.still_solves(problem, y, tolerance));
}

}  // namespace
}  // namespace jostle::test
