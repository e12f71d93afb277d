// SPDX-License-Identifier: MIT
//
// Checks of the numbers in a geometry that callers hand in.
#pragma once

#include "jostle/physics/geometry.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

// An Error names the field ("geometry.box.half_extents.x"), its value and its range.
Status check_geometry(const char* name, const Geometry& geometry);
Status check_range(const char* name, double value, double low, double high);
// Each component is finite and at most `limit` in size.
// Not so of what is not a number.
inline bool is_within(Vec3 value, double limit) {
    const Vec3 size = abs(value);
    return size.x <= limit && size.y <= limit && size.z <= limit;
}
Status check_vector(const char* name, Vec3 value, double limit);

}  // namespace jostle::physics
