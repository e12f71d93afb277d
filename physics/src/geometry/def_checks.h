// SPDX-License-Identifier: MIT
//
// Checks of numbers that callers hand in and that saved worlds hold, too: each answers with an
// Error that names the argument, its value and its range.
#pragma once

#include "jostle/physics/defs.h"
#include "jostle/physics/result.h"
#include "physics/src/geometry/geometry_checks.h"

namespace jostle::physics {

Status check_mass(double mass);  // 0 is none
// Finite, and a rotation that is not zero.
Status check_pose(const char* name, const Transform& pose);
Status check_material(const Material& material);

}  // namespace jostle::physics
