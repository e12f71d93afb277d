// SPDX-License-Identifier: MIT
//
// Intersections of rays with the parts of deformable objects: links of ropes and triangles of
// cloth. Pure functions; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "jostle/physics/queries.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules {

/// Where a ray enters a link.
struct LinkHit {
    double fraction = 0;  ///< of the motion of the ray, 0 to 1
    double share = 0;     ///< of the link from a to b, 0 to 1
};

/// Returns where a ray enters the link from `a` to `b` (m), a cylinder of a radius (m), nothing if
/// it passes by.
inline std::optional<LinkHit> enter_link(const physics::Ray& ray, physics::Vec3 a, physics::Vec3 b,
                                         double radius) {
    using namespace physics;
    const Vec3 along = b - a, from = ray.origin - a;
    const double mm = length_squared(ray.motion), ll = length_squared(along);
    const double ml = dot(ray.motion, along), det = mm * ll - ml * ml;
    const auto best_share = [&](double s) {
        return ll > 0 ? clamp(dot(from + ray.motion * s, along) / ll, 0, 1) : 0;
    };
    // The closest points of both lines, then of both segments.
    double s = det > 1e-12 * mm * ll
                   ? clamp((ml * dot(from, along) - ll * dot(from, ray.motion)) / det, 0, 1)
                   : 0;
    double share = best_share(s);
    s = clamp(dot(a + along * share - ray.origin, ray.motion) / mm, 0, 1);
    share = best_share(s);
    const double apart2 = length_squared(ray.origin + ray.motion * s - a - along * share);
    if (!(apart2 <= radius * radius)) return std::nullopt;
    const double across = ll > 0 ? maximum(det / ll, 1e-12 * mm) : mm;
    return LinkHit{maximum(s - square_root((radius * radius - apart2) / across), 0), share};
}

/// Where a ray meets a triangle.
struct TriangleHit {
    double fraction = 0;     ///< of the motion of the ray, 0 to 1
    std::size_t corner = 0;  ///< the nearest corner
};

/// Returns where a ray meets a triangle (m) from either side, nothing if it passes by. Source:
/// T. Moeller, B. Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
inline std::optional<TriangleHit> meet_triangle(const physics::Ray& ray,
                                                const std::array<physics::Vec3, 3>& p) {
    using namespace physics;
    const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0], q = cross(ray.motion, e2);
    const double det = dot(e1, q);
    if (absolute(det) < 1e-14 * length(ray.motion) * length(e1) * length(e2)) return std::nullopt;
    const Vec3 from = ray.origin - p[0], r = cross(from, e1);
    const double u = dot(from, q) / det, v = dot(ray.motion, r) / det, t = dot(e2, r) / det;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1)) return std::nullopt;
    const double first = 1 - u - v;
    return TriangleHit{t, first >= u && first >= v ? 0u : u >= v ? 1u : 2u};
}

}  // namespace jostle::modules
