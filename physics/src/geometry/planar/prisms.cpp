// SPDX-License-Identifier: MIT
#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/geometry_checks.h"
#include "physics/src/geometry/planar/planar_checks.h"

namespace jostle::physics::planar {
namespace {

// Of the square of a prism's size; prisms with a smaller face are dropped.
constexpr double sliver = 1e-5;

double size_of(std::span<const Vec2> corners, double half_depth) {
    Vec2 low = corners[0], high = corners[0];
    ASSERT(corners.size() >= 3 && half_depth > 0);
    for (const Vec2 p : corners) {
        low = {minimum(low.x, p.x), minimum(low.y, p.y)};
        high = {maximum(high.x, p.x), maximum(high.y, p.y)};
    }
    return maximum(2 * half_depth, maximum(high.x - low.x, high.y - low.y));
}

Status check_reach(std::span<const Vec2> polygon) {
    for (std::size_t k = 0; k < polygon.size(); k++) {
        const Vec2 p = polygon[k];
        if (absolute(p.x) > max_shape_size || absolute(p.y) > max_shape_size)
            return invalid_argument("polygon[" + std::to_string(k) + "] is (" + text(p.x) + ", " +
                                    text(p.y) + "); coordinates must be within +-" +
                                    text(max_shape_size) + " m");
    }
    return {};
}

}  // namespace

Result<std::vector<std::shared_ptr<const ConvexHull>>> build_prisms(std::span<const Vec2> polygon,
                                                                    double half_depth) {
    if (Status s = check_range("half_depth", half_depth, min_shape_size, max_shape_size); !s.ok())
        return s.error();
    if (Status s = check_reach(polygon); !s.ok()) return s.error();
    const auto parts = convex_parts(polygon, max_face_vertices);
    if (!parts.ok()) return parts.error();
    std::vector<std::shared_ptr<const ConvexHull>> prisms;
    for (std::size_t k = 0; k < parts->size(); k++) {
        std::vector<Vec2> face;
        for (const std::uint32_t corner : (*parts)[k]) face.push_back(polygon[corner]);
        const double size = size_of(face, half_depth);
        if (signed_area(face) < sliver * size * size) continue;
        std::vector<Vec3> points;
        for (const double z : {-half_depth, half_depth})
            for (const Vec2 p : face) points.push_back({p.x, p.y, z});
        const auto prism = build_hull(points);
        if (!prism.ok())
            return invalid_argument("polygon: the part at corner " +
                                    std::to_string((*parts)[k][0]) +
                                    " cannot be converted to a prism: " + prism.error().message);
        prisms.push_back(*prism);
    }
    if (prisms.empty())
        return invalid_argument("polygon: it is too thin for half_depth " + text(half_depth) +
                                "; all its parts are slivers");
    return prisms;
}

Result<std::shared_ptr<const CompoundShape>> build_prism_compound(std::span<const Vec2> polygon,
                                                                  double half_depth) {
    const auto prisms = build_prisms(polygon, half_depth);
    if (!prisms.ok()) return prisms.error();
    std::vector<CompoundChild> children;
    for (const auto& prism : *prisms) children.push_back({Hull{prism}, {}});
    return build_compound(std::move(children));
}

}  // namespace jostle::physics::planar
