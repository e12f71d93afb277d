// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/shape_distance.h"

#include "jostle/base/check.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

SignedDistance from_plane(const TransformedShape& plane, const TransformedShape& shape) {
    const Vec3 n = plane.axes * std::get<Plane>(*plane.geometry).normal;
    const Convex c = convex_of(shape, shape.position);
    ASSERT(is_unit(n));
    const Vec3 lowest = shape.position + support(c, -n) - n * c.radius;
    const double distance = dot(lowest - plane.position, n);
    return {distance, n, lowest - n * distance, lowest};
}

}  // namespace

SignedDistance signed_distance(const TransformedShape& a, const TransformedShape& b,
                               PairCache& cache) {
    if (kind_of(*a.geometry) == ShapeKind::plane) return from_plane(a, b);
    if (kind_of(*b.geometry) == ShapeKind::plane) {
        const SignedDistance d = from_plane(b, a);
        return {d.distance, -d.normal, d.on_b, d.on_a};
    }
    const Convex ca = convex_of(a, a.position), cb = convex_of(b, a.position);
    const Witness w = find_witness(ca, cb, 1e300, cache);
    return {w.distance - ca.radius - cb.radius, w.normal,
            a.position + w.on_a + w.normal * ca.radius, a.position + w.on_b - w.normal * cb.radius};
}

}  // namespace jostle::physics
