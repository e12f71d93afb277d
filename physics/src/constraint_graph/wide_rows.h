// SPDX-License-Identifier: MIT
//
// Access to the values of one body, contact or joint in rows of eight lanes.
#pragma once

#include "jostle/base/check.h"
#include "jostle/physics/vec3.h"

namespace jostle::physics {

inline float as_float(double x) {
    return static_cast<float>(x);
}

inline Vec3 get_lane(const float (*rows)[8], int lane) {
    ASSERT(lane >= 0 && lane < 8);
    return {double{rows[0][lane]}, double{rows[1][lane]}, double{rows[2][lane]}};
}
inline void put_lane(float (*rows)[8], int lane, Vec3 v) {
    ASSERT(lane >= 0 && lane < 8);
    rows[0][lane] = as_float(v.x);
    rows[1][lane] = as_float(v.y);
    rows[2][lane] = as_float(v.z);
}

}  // namespace jostle::physics
