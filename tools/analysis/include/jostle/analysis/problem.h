// SPDX-License-Identifier: MIT
//
// A bounded linear system of impulses: find x with A x = b, as closely as lower <= x <= upper
// allows. A is symmetric and positive semi-definite.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "jostle/physics/constraint_system.h"

namespace jostle::analysis {

struct Problem {
    std::size_t count = 0;       ///< number of rows
    std::vector<double> matrix;  ///< count x count, row by row
    std::vector<double> rhs;
    std::vector<double> lower, upper;
    /// Friction: the bounds of a row are -friction x .. friction x with x the impulse of its normal
    /// row. -1: not a friction row.
    std::vector<int> normal_row;
    std::vector<double> friction;
    std::vector<std::string> names;  ///< of rows, for messages

    double at(std::size_t row, std::size_t column) const { return matrix[row * count + column]; }
    /// Bounds of a row for the impulses x.
    double lower_at(std::size_t row, const std::vector<double>& x) const;
    double upper_at(std::size_t row, const std::vector<double>& x) const;
    bool has_bounds() const;  ///< at least one row has a finite bound
};

/// Converts a constraint system. Names are "joint 3 point x" and "contact 4-1 normal of point 0",
/// with the indices of the ids.
Problem problem_of(const physics::ConstraintSystem& system);

/// A problem without bounds and names.
Problem problem_of(std::size_t count, std::vector<double> matrix, std::vector<double> rhs);

}  // namespace jostle::analysis
