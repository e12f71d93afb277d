// SPDX-License-Identifier: MIT
//
// Signed distance of a point to a shape, from the textbook definitions: the ground truth of queries
// and masses. Shares no code with the library beyond the vector types.
#pragma once

#include <algorithm>
#include <cmath>

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::test {

// In the shape's own frame, m; negative inside.
inline double signed_distance(const physics::Geometry& geometry, physics::Vec3 p) {
    using physics::Vec3;
    switch (physics::kind_of(geometry)) {
        case physics::ShapeKind::sphere:
            return length(p) - std::get<physics::Sphere>(geometry).radius;
        case physics::ShapeKind::capsule: {
            const auto& c = std::get<physics::Capsule>(geometry);
            const Vec3 nearest{0, std::clamp(p.y, -c.half_length, c.half_length), 0};
            return length(p - nearest) - c.radius;
        }
        case physics::ShapeKind::box: {
            const Vec3 h = std::get<physics::Box>(geometry).half_extents;
            const Vec3 q{std::fabs(p.x) - h.x, std::fabs(p.y) - h.y, std::fabs(p.z) - h.z};
            const Vec3 outside{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
            return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0);
        }
        case physics::ShapeKind::plane:
            return dot(p, std::get<physics::Plane>(geometry).normal);
    }
    return 0;
}

inline double signed_distance(const physics::Geometry& geometry, const physics::Transform& pose,
                              physics::Vec3 p) {
    return signed_distance(geometry, physics::apply_inverse(pose, p));
}

}  // namespace jostle::test
