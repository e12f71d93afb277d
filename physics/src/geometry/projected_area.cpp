// SPDX-License-Identifier: MIT
#include "physics/src/geometry/shape_measures.h"

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// Sine of the angle between the direction and the y axis.
double across_axis(Vec3 d) {
    return square_root(d.x * d.x + d.z * d.z);
}

// The projection of the base is an ellipse, that of the apex a point on its minor axis. The area is
// that of their convex hull.
double area_of_cone(const Cone& cone, Vec3 d) {
    const double r = cone.radius, squeeze = absolute(d.y);
    const double tip = 2 * cone.half_length * across_axis(d);  // from the centre of the ellipse
    if (squeeze * r >= tip) return pi * r * r * squeeze;       // inside the ellipse
    if (squeeze < 1e-9) return r * tip;                        // a triangle
    // Scaled to a circle: two tangents from the apex, and the arc between the points of contact on
    // the far side.
    const double far = tip / squeeze, tangent = square_root(far * far - r * r);
    return squeeze * (r * r * (pi - arc_tangent(tangent, r)) + r * tangent);
}

// Every face is visible from exactly one of the two directions.
double area_of_hull(const ConvexHull& hull, Vec3 d) {
    double twice = 0;
    for (const HullFace& face : hull.faces) {
        const auto corners = hull.vertices_of(face);
        const Vec3 first = hull.vertices[corners[0]];
        Vec3 doubled;
        for (std::size_t k = 1; k + 1 < corners.size(); k++)
            doubled +=
                cross(hull.vertices[corners[k]] - first, hull.vertices[corners[k + 1]] - first);
        twice += absolute(dot(doubled, d)) * 0.5;
    }
    return 0.5 * twice;
}

}  // namespace

double projected_area(const Geometry& geometry, Vec3 d) {
    ASSERT(is_unit(d, 1e-5));
    if (const auto* sphere = std::get_if<Sphere>(&geometry))
        return pi * sphere->radius * sphere->radius;
    if (const auto* capsule = std::get_if<Capsule>(&geometry))
        return pi * capsule->radius * capsule->radius +
               4 * capsule->radius * capsule->half_length * across_axis(d);
    if (const auto* box = std::get_if<Box>(&geometry)) {
        const Vec3 h = box->half_extents, a = abs(d);
        return 4 * (a.x * h.y * h.z + a.y * h.x * h.z + a.z * h.x * h.y);
    }
    if (const auto* cylinder = std::get_if<Cylinder>(&geometry))
        return pi * cylinder->radius * cylinder->radius * absolute(d.y) +
               4 * cylinder->radius * cylinder->half_length * across_axis(d);
    if (const auto* cone = std::get_if<Cone>(&geometry)) return area_of_cone(*cone, d);
    if (const auto* hull = std::get_if<Hull>(&geometry)) return area_of_hull(*hull->data, d);
    double sum = 0;
    if (const auto* compound = std::get_if<Compound>(&geometry))
        for (const CompoundChild& child : compound->data->children)
            sum += projected_area(child.geometry, inverse_rotate(child.pose.rotation, d));
    return sum;
}

}  // namespace jostle::physics
