// SPDX-License-Identifier: MIT
#include "physics/src/constraint_graph/joint_solver_preferences.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace jostle::test {
namespace {
using namespace physics;

// Own wishes go before the world's; of them direct before iterative before automatic.
TEST(JointSolverPreferences, are_resolved_by_priority) {
    constexpr JointSolver all[] = {JointSolver::automatic, JointSolver::iterative,
                                   JointSolver::direct};
    for (const JointSolver of_world : all) {
        EXPECT_EQ(solver_of(preference_bit({}), of_world), of_world);
        for (const JointSolver own : all)
            EXPECT_EQ(solver_of(static_cast<JointSolverPreferences>(preference_bit({}) |
                                                                    preference_bit(own)),
                                of_world),
                      own);
        for (const JointSolver first : all)
            for (const JointSolver second : all)
                EXPECT_EQ(solver_of(static_cast<JointSolverPreferences>(preference_bit(first) |
                                                                        preference_bit(second)),
                                    of_world),
                          first > second ? first : second);
    }
}

// However many groups there are, one factorisation of all stays within the ceiling or what is
// affordable anyway: nobody who does not ask is granted more.
TEST(JointSolverPreferences, share_one_work_budget) {
    for (const std::size_t joints : {1u, 100u, 3000u, 200000u}) {
        const std::int64_t budget = direct_budget(joints);
        const auto cubes = static_cast<std::int64_t>(27 * joints);
        EXPECT_LE(max_work(cubes, joints, budget),
                  std::max(tuning::max_direct_work, tuning::direct_work * cubes));
        EXPECT_EQ(max_work(cubes, joints, 0), tuning::direct_work * cubes);
        EXPECT_GE(max_work(cubes, joints, budget), max_work(cubes, joints, 0));
    }
    EXPECT_EQ(direct_budget(0), tuning::max_direct_work);
}

}  // namespace
}  // namespace jostle::test
