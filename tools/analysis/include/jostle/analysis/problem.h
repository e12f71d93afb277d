// SPDX-License-Identifier: MIT
//
// A system of impulses with bounds, as numbers alone: find x with A x = b, or as near to it as
// lower <= x <= upper allow. A is symmetric and positive semi-definite.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "jostle/physics/constraint_system.h"

namespace jostle::linear_systems {

struct Problem {
    std::size_t count = 0;       // rows
    std::vector<double> matrix;  // count x count, row by row
    std::vector<double> rhs;
    std::vector<double> lower, upper;
    // Friction: the bounds of a row are -friction x .. friction x of the row that it leans on. -1:
    // it leans on none.
    std::vector<int> normal_row;
    std::vector<double> friction;
    std::vector<std::string> names;  // of rows, for words

    double at(std::size_t row, std::size_t column) const { return matrix[row * count + column]; }
    // Bounds of a row when the impulses are x.
    double lower_at(std::size_t row, const std::vector<double>& x) const;
    double upper_at(std::size_t row, const std::vector<double>& x) const;
    bool has_bounds() const;  // some row can reach one
};

// Names are "joint 3 point x" and "contact 4-1 normal of point 0", by the indices of the ids.
Problem problem_of(const physics::ConstraintSystem& system);

// Without bounds and names.
Problem problem_of(std::size_t count, std::vector<double> matrix, std::vector<double> rhs);

}  // namespace jostle::linear_systems
