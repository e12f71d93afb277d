// SPDX-License-Identifier: MIT
//
// The principal axes of an inertia tensor.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

struct PrincipalAxes {
    Quat frame;    // orientation of the axes in the body's frame
    Vec3 moments;  // kg m^2, about them

    bool operator==(const PrincipalAxes&) const = default;
};

// Principal axes of a symmetric matrix, by Jacobi rotations. A diagonal matrix retains its axes bit
// by bit.
PrincipalAxes principal_axes(const Mat3& inertia);

}  // namespace jostle::physics
