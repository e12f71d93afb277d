// SPDX-License-Identifier: MIT
#include "physics/src/geometry/outline.h"

#include <algorithm>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

double cross_z(Vec3 a, Vec3 b) {
    return a.x * b.y - a.y * b.x;
}

// The convex hull of points in the plane (Andrew's monotone chain, 1979).
int hull_of(std::vector<Vec3>& points, Vec3* out) {
    std::sort(points.begin(), points.end(),
              [](Vec3 a, Vec3 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Vec3> chain(2 * points.size());
    ASSERT(points.size() >= 3);
    std::size_t n = 0;
    const auto add = [&](Vec3 p, std::size_t least) {
        // The last point equals the first.
        while (n >= least + 2 && cross_z(chain[n - 1] - chain[n - 2], p - chain[n - 2]) <= 0) n--;
        chain[n++] = p;
    };
    for (const Vec3 p : points) add(p, 0);
    const std::size_t upper = n - 1;
    for (std::size_t k = points.size() - 1; k-- > 0;) add(points[k], upper);
    n--;  // the last point equals the first
    const auto count = static_cast<int>(std::min(n, max_hull_vertices));
    ASSERT(count >= 1);
    for (int k = 0; k < count; k++) out[k] = chain[static_cast<std::size_t>(k)];
    return count;
}

// Area, centre and second moment of a polygon.
MassProperties mass_of_polygon(const Outline& outline, double density) {
    double area = 0, second = 0;
    Vec3 moment;
    for (int k = 0; k < outline.count; k++) {
        const Vec3 p = outline.corner[k], q = outline.corner[(k + 1) % outline.count];
        const double c = cross_z(p, q);
        area += 0.5 * c;
        moment += (p + q) * (c / 6);
        second += c * (dot(p, p) + dot(p, q) + dot(q, q)) / 12;
    }
    const Vec3 center = moment / area;
    ASSERT(area > 0);
    const double about_center = density * (second - area * dot(center, center));
    return {density * area, center, diagonal({about_center, about_center, about_center})};
}

}  // namespace

Outline outline_of(const TransformedShape& shape, Vec3 origin) {
    Outline out;
    const Vec3 at = shape.position - origin;
    const auto put = [&](Vec3 local) {
        Vec3 p = at + shape.axes * local;
        p.z = 0;
        out.corner[out.count++] = p;
    };
    switch (kind_of(*shape.geometry)) {
        case ShapeKind::sphere:
            out.radius = std::get<Sphere>(*shape.geometry).radius;
            put({});
            break;
        case ShapeKind::capsule: {
            const Capsule& c = std::get<Capsule>(*shape.geometry);
            out.radius = c.radius;
            put({0, -c.half_length, 0});
            put({0, c.half_length, 0});
            break;
        }
        case ShapeKind::box: {
            const Vec3 h = std::get<Box>(*shape.geometry).half_extents;
            put({-h.x, -h.y, 0});
            put({h.x, -h.y, 0});
            put({h.x, h.y, 0});
            put({-h.x, h.y, 0});
            break;
        }
        case ShapeKind::hull: {
            std::vector<Vec3> points;
            for (const Vec3 v : std::get<Hull>(*shape.geometry).data->vertices) {
                Vec3 p = at + shape.axes * v;
                p.z = 0;
                points.push_back(p);
            }
            out.count = hull_of(points, out.corner.data());
            break;
        }
        default:
            break;
    }
    return out;
}

MassProperties planar_mass_of(const Geometry& geometry, double density) {
    const auto disc = [&](double mass, double inertia) {
        return MassProperties{mass, {}, diagonal({inertia, inertia, inertia})};
    };
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
        const double r2 = sphere->radius * sphere->radius, m = density * pi * r2;
        return disc(m, 0.5 * m * r2);
    }
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
        // A rectangle and two half discs, whose centroids are 4 r / (3 pi) beyond its ends.
        const double r = capsule->radius, h = capsule->half_length, r2 = r * r;
        const double rectangle = density * 4 * r * h, ends = density * pi * r2;
        return disc(rectangle + ends, rectangle * (r2 + h * h) / 3 +
                                          ends * (0.5 * r2 + h * h + 8 * r * h / (3 * pi)));
    }
    if (kind_of(geometry) == ShapeKind::box || kind_of(geometry) == ShapeKind::hull)
        return mass_of_polygon(outline_of(transformed_shape(geometry, {}), {}), density);
    return {};
}

}  // namespace jostle::physics
