// SPDX-License-Identifier: MIT
#include "jostle/analysis/preconditioning.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::analysis {
namespace {

std::vector<PreconditioningResult> treat(const Problem& problem) {
    return evaluate_preconditioning(problem, analyse(problem));
}

// [1 1; 1 1] + epsilon has the eigenvalues epsilon and 2 + epsilon.
TEST(Preconditioning, softness_bounds_the_condition_number) {
    const Problem problem = problem_of(2, {1, 1, 1, 1}, {2, 2});
    const std::vector<PreconditioningResult> all = treat(problem);
    ASSERT_EQ(all.size(), 2 * std::size(default_epsilons));
    EXPECT_TRUE(std::isinf(all[0].condition));
    for (const PreconditioningResult& treatment : all) {
        if (treatment.epsilon == 0) continue;
        const double condition = (2 + treatment.epsilon) / treatment.epsilon;
        EXPECT_NEAR(treatment.condition, condition, 1e-3 * condition);
        // The sum of both rows yields by epsilon in 2.
        EXPECT_NEAR(treatment.error, treatment.epsilon / (2 + treatment.epsilon),
                    1e-9 + 1e-3 * treatment.epsilon);
    }
}

TEST(Preconditioning, scaling_removes_the_effect_of_units_and_mass_ratios) {
    const std::vector<PreconditioningResult> all =
        treat(problem_of(3, {1, 0, 0, 0, 10, 0, 0, 0, 100}, {1, 10, 100}));
    const std::size_t scaled = std::size(default_epsilons);
    EXPECT_NEAR(all[0].condition, 100, 1e-9);
    EXPECT_FALSE(all[0].scaled);
    EXPECT_EQ(all[0].gradient_iterations, 3);
    EXPECT_TRUE(all[scaled].scaled);
    EXPECT_NEAR(all[scaled].condition, 1, 1e-9);
    EXPECT_EQ(all[scaled].gradient_iterations, 1);
    EXPECT_LT(all[scaled].error, 1e-12);
}

}  // namespace
}  // namespace jostle::analysis
