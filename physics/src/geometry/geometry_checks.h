// SPDX-License-Identifier: MIT
//
// Range checks of geometry and of scalar and vector arguments.
#pragma once

#include "jostle/physics/defs.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

// Returns an error that names the field ("geometry.box.half_extents.x"), its value and its range.
Status check_geometry(const char* name, const Geometry& geometry);
Status check_range(const char* name, double value, double low, double high);
// Returns true if the magnitude of each component is at most `limit`. Returns false for NaN.
inline bool is_within(Vec3 value, double limit) {
    const Vec3 size = abs(value);
    return size.x <= limit && size.y <= limit && size.z <= limit;
}
Status check_vector(const char* name, Vec3 value, double limit);

// Checks of values that occur both in arguments and in saved worlds. Each returns an Error that
// names the argument, its value and its range.
Status check_mass(double mass);  // 0 means no explicit mass
// Checks that the pose is finite and the rotation is not zero.
Status check_pose(const char* name, const Transform& pose);
Status check_material(const Material& material);

}  // namespace jostle::physics
