// SPDX-License-Identifier: MIT
#include "physics/src/geometry/hull_builder.h"

#include "jostle/base/check.h"

namespace jostle::physics {

PolyhedronMass polyhedron_mass(const ConvexHull& hull) {
    const Vec3 origin = hull.vertices[0];
    ASSERT(hull.faces.size() >= 4);
    double volume = 0;
    Vec3 moment;
    // Integrals of x x, y y, z z, x y, y z, z x.
    double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
    for (const HullFace& face : hull.faces) {
        const auto loop = hull.vertices_of(face);
        for (std::size_t k = 1; k + 1 < loop.size(); k++) {
            const Vec3 a = hull.vertices[loop[0]] - origin, b = hull.vertices[loop[k]] - origin,
                       c = hull.vertices[loop[k + 1]] - origin;
            const double d = dot(a, cross(b, c)), v = d / 6;
            const Vec3 s = a + b + c;
            volume += v;
            moment += s * (v / 4);
            // Over the tetrahedron (0, a, b, c): int x_i x_j = d / 120 (s_i s_j + sum of p_i p_j).
            const double f = d / 120;
            const auto second = [&](int i, int j) {
                return f * (s[i] * s[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]);
            };
            xx += second(0, 0);
            yy += second(1, 1);
            zz += second(2, 2);
            xy += second(0, 1);
            yz += second(1, 2);
            zx += second(2, 0);
        }
    }
    if (!(volume > 0)) return {};
    const Vec3 c = moment / volume;
    xx -= volume * c.x * c.x;
    yy -= volume * c.y * c.y;
    zz -= volume * c.z * c.z;
    xy -= volume * c.x * c.y;
    yz -= volume * c.y * c.z;
    zx -= volume * c.z * c.x;
    return {volume, origin + c,
            Mat3{{yy + zz, -xy, -zx}, {-xy, xx + zz, -yz}, {-zx, -yz, xx + yy}}};
}

}  // namespace jostle::physics
