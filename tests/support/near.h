// SPDX-License-Identifier: MIT
//
// Comparisons of vectors whose failure message contains the error.
#pragma once

#include <gtest/gtest.h>

#include "jostle/physics/vec3.h"

namespace jostle::test {

inline testing::AssertionResult near(physics::Vec3 value, physics::Vec3 expected,
                                     double tolerance) {
    const double off = physics::length(value - expected);
    if (off <= tolerance) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "(" << value.x << ", " << value.y << ", " << value.z << ") is " << off << " from ("
           << expected.x << ", " << expected.y << ", " << expected.z << "), allowed " << tolerance;
}

}  // namespace jostle::test
