// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/impact_points.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {

std::vector<ImpactPoint> points_touching(const SweptShape& a, const SweptShape& b, double fraction,
                                         double gap) {
    const TransformedShape pa = transformed_shape_at(a, fraction),
                           pb = transformed_shape_at(b, fraction);
    std::vector<ChildManifold> parts;
    ASSERT(!(gap < 0) && !(fraction < 0) && !(fraction > 1));
    if (is_composite(kind_of(*pa.geometry)) || is_composite(kind_of(*pb.geometry))) {
        collide_composite(pa, pb, gap, parts);
    } else {
        PairCache cache;
        parts.push_back({0, collide(pa, pb, gap, cache)});
    }
    std::vector<ImpactPoint> points;
    for (const ChildManifold& part : parts)
        for (int k = 0; k < part.manifold.count; k++)
            points.push_back({part.manifold.point[k], part.manifold.normal});
    return points;
}

std::vector<ImpactPoint> points_along(const SweptShape& a, const SweptShape& b,
                                      const Impact& impact) {
    const TransformedShape pa = transformed_shape_at(a, impact.fraction),
                           pb = transformed_shape_at(b, impact.fraction);
    const ShapeKind kind_a = kind_of(*pa.geometry), kind_b = kind_of(*pb.geometry);
    ASSERT(impact.fraction <= 1 && is_unit(impact.normal, 1e-4));
    std::vector<ImpactPoint> points;
    if (is_convex(kind_a) && kind_b == ShapeKind::plane) {
        const Convex ca = convex_of(pa, impact.point);
        const Feature feature = feature_along(ca, impact.normal);
        for (int k = 0; k < feature.count; k++) {
            const Vec3 corner = feature.corner[k] + impact.normal * ca.radius;
            if (dot(corner, impact.normal) >= 0)
                points.push_back({impact.point + corner, impact.normal});
        }
    }
    if (!is_convex(kind_a) || !is_convex(kind_b)) {
        if (points.empty()) points.push_back({impact.point, impact.normal});
        return points;
    }
    const Convex ca = convex_of(pa, pa.position), cb = convex_of(pb, pa.position);
    const Vec3 middle = impact.point - pa.position;
    const double distance =
        dot(support(cb, -impact.normal) - support(ca, impact.normal), impact.normal);
    const ContactPoints found =
        contact_points(ca, cb, {impact.normal, distance, middle, middle}, 0);
    for (int k = 0; k < found.count; k++)
        points.push_back({pa.position + found.point[k], impact.normal});
    return points;
}

}  // namespace jostle::physics
