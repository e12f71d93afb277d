// SPDX-License-Identifier: MIT
//
// The principal axes of an inertia tensor.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

struct PrincipalAxes {
    Quat frame;    // of the axes, in the body's
    Vec3 moments;  // kg m^2, about them

    bool operator==(const PrincipalAxes&) const = default;
};

// Of a symmetric matrix, by Jacobi's rotations. One that is diagonal keeps its axes, to the bit.
PrincipalAxes principal_axes(const Mat3& inertia);

}  // namespace jostle::physics
