// SPDX-License-Identifier: MIT
//
// Checks of values that occur both in arguments and in saved worlds. Each returns an Error that
// names the argument, its value and its range.
#pragma once

#include "jostle/physics/defs.h"
#include "jostle/physics/result.h"
#include "physics/src/geometry/geometry_checks.h"

namespace jostle::physics {

Status check_mass(double mass);  // 0 means no explicit mass
// Checks that the pose is finite and the rotation is not zero.
Status check_pose(const char* name, const Transform& pose);
Status check_material(const Material& material);

}  // namespace jostle::physics
