// SPDX-License-Identifier: MIT
//
// Signed distance of a point to a shape from textbook definitions: the reference for queries and
// masses. Shares only vector types with the library.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "jostle/physics/compound.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"
#include "jostle/physics/transform.h"

namespace jostle::test {

// The point of a triangle nearest to p: the projection of p if it is inside, otherwise the nearest
// point of a side.
inline physics::Vec3 nearest_on_triangle(physics::Vec3 p, physics::Vec3 a, physics::Vec3 b,
                                         physics::Vec3 c) {
    using physics::Vec3;
    const Vec3 n = cross(b - a, c - a);
    const auto left_of = [&](Vec3 from, Vec3 to) {
        return dot(cross(n, to - from), p - from) >= 0;
    };
    if (left_of(a, b) && left_of(b, c) && left_of(c, a)) return p - n * (dot(p - a, n) / dot(n, n));
    Vec3 best;
    double nearest = 1e300;
    const Vec3 ends[3][2] = {{a, b}, {b, c}, {c, a}};
    for (const auto& e : ends) {
        const Vec3 side = e[1] - e[0];
        const double t = std::clamp(dot(p - e[0], side) / dot(side, side), 0.0, 1.0);
        const Vec3 q = e[0] + side * t;
        if (length(p - q) < nearest) nearest = length(p - q), best = q;
    }
    return best;
}

// The point of the surface of the hull nearest to p.
inline physics::Vec3 nearest_on_border(const physics::ConvexHull& hull, physics::Vec3 p) {
    physics::Vec3 best;
    double nearest = 1e300;
    for (const physics::HullFace& face : hull.faces) {
        const auto loop = hull.vertices_of(face);
        for (std::size_t k = 1; k + 1 < loop.size(); k++) {
            const physics::Vec3 q = nearest_on_triangle(
                p, hull.vertices[loop[0]], hull.vertices[loop[k]], hull.vertices[loop[k + 1]]);
            if (length(p - q) < nearest) nearest = length(p - q), best = q;
        }
    }
    return best;
}

// The nearest point of a convex polygon in the half plane (r, y), with ordered vertices. It is the
// outline of a solid of revolution about the y axis.
struct Flat {
    double r, y;
};
inline double distance_to_outline(const std::vector<Flat>& corners, Flat p, Flat& nearest) {
    double best = 1e300;
    bool inside = true;
    for (std::size_t k = 0; k < corners.size(); k++) {
        const Flat a = corners[k], b = corners[(k + 1) % corners.size()];
        const double ur = b.r - a.r, uy = b.y - a.y, l2 = ur * ur + uy * uy;
        if (ur * (p.y - a.y) - uy * (p.r - a.r) < 0) inside = false;
        if (a.r == 0 && b.r == 0) continue;  // the axis is not a border
        const double t = std::clamp(((p.r - a.r) * ur + (p.y - a.y) * uy) / l2, 0.0, 1.0);
        const Flat q{a.r + t * ur, a.y + t * uy};
        const double d = std::hypot(p.r - q.r, p.y - q.y);
        if (d < best) best = d, nearest = q;
    }
    return inside ? -best : best;
}
inline std::vector<Flat> outline_of(const physics::Cylinder& c) {
    return {{0, -c.half_length},
            {c.radius, -c.half_length},
            {c.radius, c.half_length},
            {0, c.half_length}};
}
inline std::vector<Flat> outline_of(const physics::Cone& c) {
    return {{0, -c.half_length}, {c.radius, -c.half_length}, {0, c.half_length}};
}

// In the local frame of the shape, m; negative inside.
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
        case physics::ShapeKind::cylinder: {
            Flat nearest{};
            return distance_to_outline(outline_of(std::get<physics::Cylinder>(geometry)),
                                       {std::hypot(p.x, p.z), p.y}, nearest);
        }
        case physics::ShapeKind::cone: {
            Flat nearest{};
            return distance_to_outline(outline_of(std::get<physics::Cone>(geometry)),
                                       {std::hypot(p.x, p.z), p.y}, nearest);
        }
        case physics::ShapeKind::hull: {
            const physics::ConvexHull& hull = *std::get<physics::Hull>(geometry).data;
            double deepest = -1e300;
            for (const physics::HullFace& face : hull.faces)
                deepest = std::max(deepest, dot(face.normal, p) - face.offset);
            return deepest <= 0 ? deepest : length(p - nearest_on_border(hull, p));
        }
        case physics::ShapeKind::compound: {
            double nearest = 1e300;
            for (const auto& child : std::get<physics::Compound>(geometry).data->children)
                nearest = std::min(nearest, signed_distance(child.geometry,
                                                            physics::apply_inverse(child.pose, p)));
            return nearest;
        }
        case physics::ShapeKind::mesh: {
            const auto& mesh = *std::get<physics::Mesh>(geometry).data;
            double nearest = 1e300;
            for (const auto& t : mesh.triangles)
                nearest = std::min(nearest, length(p - nearest_on_triangle(p, mesh.vertices[t[0]],
                                                                           mesh.vertices[t[1]],
                                                                           mesh.vertices[t[2]])));
            return nearest;
        }
        case physics::ShapeKind::height_field: {
            const auto& grid = *std::get<physics::HeightField>(geometry).data;
            const auto at = [&](std::uint32_t c, std::uint32_t r) {
                return Vec3{(c - (grid.columns - 1) / 2.0) * grid.spacing_x,
                            grid.heights[r * grid.columns + c],
                            (r - (grid.rows - 1) / 2.0) * grid.spacing_z};
            };
            double nearest = 1e300;
            for (std::uint32_t r = 0; r + 1 < grid.rows; r++)
                for (std::uint32_t c = 0; c + 1 < grid.columns; c++) {
                    if (!grid.holes.empty() && grid.holes[r * (grid.columns - 1) + c] != 0)
                        continue;
                    for (const Vec3 third : {at(c + 1, r), at(c, r + 1)})
                        nearest = std::min(
                            nearest,
                            length(p - nearest_on_triangle(p, at(c, r), third, at(c + 1, r + 1))));
                }
            return nearest;
        }
    }
    return 0;
}

inline double signed_distance(const physics::Geometry& geometry, const physics::Transform& pose,
                              physics::Vec3 p) {
    return signed_distance(geometry, physics::apply_inverse(pose, p));
}

}  // namespace jostle::test
