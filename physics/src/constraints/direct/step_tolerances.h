// SPDX-License-Identifier: MIT
//
// Tolerances of the steps of a direct group: joint error, and the energy that it may change.
#pragma once

#include "jostle/physics/scalar.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// Allowed joint error, m: a small part of the error that a step of length h makes anyway. Scaled
// with the group's size. In a loop it makes dependent rows look independent.
inline double joint_tolerance(double h, bool looped, double reach) {
    return minimum(looped ? 2e-9 : 1e-5, 0.1 * h * h) * minimum(1, 2 * reach);
}

struct GapWork {
    double error;      // m: the largest one of the step
    double tolerance;  // m
    double weight;     // N: sum of the external forces
    double tension;    // N: sum of the joint forces
    double mass;       // kg: of all bodies
};
// Energy that may change in h as joint errors are closed or left over, J: weights and tensions do
// work and bodies are displaced.
inline double work_of_gaps(const GapWork& gap, double h) {
    // Of the energy of displacements.
    constexpr double correction_share = 0.1;
    // Sum of the tensions relative to the weights. Larger ones are those of a step that fails.
    constexpr double largest_tension = 100;
    const double left_over = minimum(gap.error, 2 * gap.tolerance);
    const double speed = minimum(gap.error / h, tuning::joint_push_speed);
    return 2 * gap.weight * gap.error +
           2 * minimum(gap.tension, largest_tension * gap.weight) * left_over +
           correction_share * gap.mass * speed * speed;
}

}  // namespace jostle::physics
