// SPDX-License-Identifier: MIT
#include "modules/destruction/src/fracture_cells.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

// Any unit vector perpendicular to a unit vector.
Vec3 across(Vec3 n) {
    const Vec3 a = abs(n);
    const Vec3 least = a.x <= a.y && a.x <= a.z ? Vec3{1, 0, 0}
                       : a.y <= a.z             ? Vec3{0, 1, 0}
                                                : Vec3{0, 0, 1};
    return normalized(cross(n, least));
}

struct Moments {
    double area = 0, xx = 0, yy = 0, xy = 0;  // integrals of x^2, y^2 and x y over the face
    Vec3 first;
};

// Sums triangles from the first point. For a triangle with corners about the origin: integral of x
// y dA = area / 12 (sum of x_i y_i + (sum x_i) (sum y_i)).
Moments moments_of(std::span<const Vec3> points, Vec3 normal, Vec3 origin, Vec3 x, Vec3 y) {
    Moments m;
    for (std::size_t k = 2; k < points.size(); k++) {
        const Vec3 p[3] = {points[0] - origin, points[k - 1] - origin, points[k] - origin};
        const double area = 0.5 * dot(cross(p[1] - p[0], p[2] - p[0]), normal);
        m.area += area;
        m.first += (p[0] + p[1] + p[2]) * (area / 3);
        double sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
        for (const Vec3 q : p) {
            const double qx = dot(q, x), qy = dot(q, y);
            sx += qx, sy += qy, sxx += qx * qx, syy += qy * qy, sxy += qx * qy;
        }
        m.xx += area / 12 * (sxx + sx * sx);
        m.yy += area / 12 * (syy + sy * sy);
        m.xy += area / 12 * (sxy + sx * sy);
    }
    return m;
}

// Direction of the largest second moment: half of the angle of (xx - yy, 2 xy).
Vec3 principal(const Moments& m, Vec3 x, Vec3 y) {
    const double spread = m.xx + m.yy;
    if (absolute(m.xx - m.yy) + absolute(m.xy) < 1e-9 * spread) return x;
    const SinCos turn = sin_cos(0.5 * arc_tangent(2 * m.xy, m.xx - m.yy));
    return x * turn.cos + y * turn.sin;
}

}  // namespace

Section section_of(std::span<const Vec3> points, Vec3 normal) {
    Section s;
    if (points.size() < 3) return s;
    const Vec3 x = across(normal), y = cross(normal, x);
    const Moments about_first = moments_of(points, normal, points[0], x, y);
    if (!(about_first.area > 0)) return s;
    s.area = about_first.area;
    s.center = points[0] + about_first.first / s.area;
    s.axis = normalized(principal(moments_of(points, normal, s.center, x, y), x, y), x);
    const Vec3 v = cross(normal, s.axis);
    const Moments own = moments_of(points, normal, s.center, s.axis, v);
    s.moment_u = own.yy;  // about u: squares of the distances along v
    s.moment_v = own.xx;
    for (const Vec3 p : points) {
        s.reach_u = maximum(s.reach_u, absolute(dot(p - s.center, v)));
        s.reach_v = maximum(s.reach_v, absolute(dot(p - s.center, s.axis)));
    }
    return s;
}

}  // namespace jostle::modules::destruction_detail
