// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/shape_distance.h"

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/geometry/surface.h"

namespace jostle::physics {
namespace {

// A ball of zero radius lets the shape distance algorithms handle a point.
const Geometry dot_ball = Sphere{0};

SurfacePoint nearest_on_simple(const TransformedShape& shape, Vec3 point) {
    PairCache cache;
    const SignedDistance d = signed_distance(shape, {&dot_ball, point, {}}, cache);
    return {d.distance, d.on_a, d.normal};
}

// Queries a growing box until the best distance is less than the reach of the box.
template <class Query>
SurfacePoint nearest_in(const Aabb& all, Vec3 local, Query&& query) {
    SurfacePoint best{1e300, {}, {0, 1, 0}};
    const Vec3 inside = max(all.low, min(local, all.high));
    const double size = length(all.high - all.low) + 1e-9;
    ASSERT(!(all.low.x > all.high.x) && !(all.low.y > all.high.y) && !(all.low.z > all.high.z));
    const double away = length(local - inside);
    for (double reach = away + 0.02 * size;; reach *= 3) {
        query(Aabb{local - Vec3{reach, reach, reach}, local + Vec3{reach, reach, reach}}, best);
        if (best.distance <= reach || reach > away + size) return best;
    }
}

SurfacePoint nearest_on_surface(const TransformedShape& shape, Vec3 point) {
    const Vec3 local = transposed_times(shape.axes, point - shape.position);
    const Aabb all = std::holds_alternative<Mesh>(*shape.geometry)
                         ? std::get<Mesh>(*shape.geometry).data->bounds
                         : std::get<HeightField>(*shape.geometry).data->bounds;
    const Convex dot_core{.position = {}, .axes = {}, .size = {}};
    SurfacePoint best = nearest_in(all, local, [&](const Aabb& box, SurfacePoint& found) {
        for_each_triangle(*shape.geometry, box, [&](const SurfaceTriangle& t) {
            const Vec3 corner[3] = {t.corner[0] - local, t.corner[1] - local, t.corner[2] - local};
            const Convex triangle = triangle_convex(corner, {}, {});
            PairCache cache;
            const Witness w = find_witness(triangle, dot_core, 1e300, cache);
            const double distance = absolute(w.distance);
            if (distance >= found.distance) return;
            const Vec3 front = normal_of(t);
            Vec3 normal = w.distance > 0 ? w.normal : front;
            found = {distance, w.on_a + local, normal};
        });
    });
    best.point = shape.position + shape.axes * best.point;
    best.normal = shape.axes * best.normal;
    return best;
}

SurfacePoint nearest_on_compound(const TransformedShape& shape, Vec3 point) {
    const CompoundShape& data = *std::get<Compound>(*shape.geometry).data;
    const Vec3 local = transposed_times(shape.axes, point - shape.position);
    SurfacePoint best = nearest_in(data.bounds, local, [&](const Aabb& box, SurfacePoint& found) {
        data.tree->query(box, [&](std::uint32_t k) {
            const CompoundChild& child = data.children[k];
            const SurfacePoint p =
                nearest_on_simple(transformed_shape(child.geometry, child.pose), local);
            if (p.distance < found.distance) found = p;
        });
    });
    best.point = shape.position + shape.axes * best.point;
    best.normal = shape.axes * best.normal;
    return best;
}

}  // namespace

SurfacePoint nearest_point(const TransformedShape& shape, Vec3 point) {
    switch (kind_of(*shape.geometry)) {
        case ShapeKind::mesh:
        case ShapeKind::height_field:
            return nearest_on_surface(shape, point);
        case ShapeKind::compound:
            return nearest_on_compound(shape, point);
        default:
            return nearest_on_simple(shape, point);
    }
}

}  // namespace jostle::physics
