// SPDX-License-Identifier: MIT
//
// Range checks of geometry and of scalar and vector arguments.
#pragma once

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

}  // namespace jostle::physics
