// SPDX-License-Identifier: MIT
#include "collision/narrowphase/gjk.h"

namespace jostle::physics {
namespace {

// Cuts the simplex down to the points that carry the closest point to the origin, with their
// weights.
void keep(Simplex& s, const int* which, const double* weights, int count) {
    Simplex out;
    for (int k = 0; k < count; k++) {
        out.point[k] = s.point[which[k]];
        out.weight[k] = weights[k];
    }
    out.count = count;
    s = out;
}

void closest_on_segment(Simplex& s, int i, int j) {
    const Vec3 a = s.point[i].w, ab = s.point[j].w - a;
    const double l2 = length_squared(ab), t = -dot(a, ab);
    if (t <= 0 || l2 == 0) {
        const double one = 1;
        keep(s, &i, &one, 1);
    } else if (t >= l2) {
        const double one = 1;
        keep(s, &j, &one, 1);
    } else {
        const int which[2] = {i, j};
        const double weights[2] = {1 - t / l2, t / l2};
        keep(s, which, weights, 2);
    }
}

Vec3 point_of(const Simplex& s) {
    Vec3 v;
    for (int k = 0; k < s.count; k++) v += s.point[k].w * s.weight[k];
    return v;
}

void closest_on_triangle(Simplex& s, int i, int j, int k) {
    const Vec3 a = s.point[i].w, b = s.point[j].w, c = s.point[k].w;
    const Vec3 ab = b - a, ac = c - a, n = cross(ab, ac);
    const double n2 = length_squared(n);
    const double longest = maximum(length_squared(ab), length_squared(ac));
    if (n2 > 1e-30 * longest * longest) {
        // Barycentric coordinates of the origin's projection.
        const double u = dot(cross(b, c), n) / n2, v = dot(cross(c, a), n) / n2, w = 1 - u - v;
        if (u >= 0 && v >= 0 && w >= 0) {
            const int which[3] = {i, j, k};
            const double weights[3] = {u, v, w};
            keep(s, which, weights, 3);
            return;
        }
    }
    // Outside: the nearest of the three edges.
    Simplex best;
    double nearest = 1e300;
    const int ends[3][2] = {{i, j}, {j, k}, {k, i}};
    for (const auto& e : ends) {
        Simplex edge = s;
        closest_on_segment(edge, e[0], e[1]);
        const double d2 = length_squared(point_of(edge));
        if (d2 < nearest) {
            nearest = d2;
            best = edge;
        }
    }
    s = best;
}

// True when the origin is inside.
bool closest_on_tetrahedron(Simplex& s) {
    static constexpr int face[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    Simplex best = s;
    double nearest = 1e300;
    bool inside = true;
    for (const auto& f : face) {
        const Vec3 a = s.point[f[0]].w, b = s.point[f[1]].w, c = s.point[f[2]].w;
        const Vec3 n = cross(b - a, c - a);
        const double origin = -dot(n, a), other = dot(n, s.point[f[3]].w - a);
        // Behind this face, as seen from outside. A face whose plane the fourth point all but lies
        // in cannot tell: flat tetrahedra, as round shapes make them, hold nothing.
        const double reach = length(n) * length(s.point[f[3]].w - a);
        if (origin * other > 0 && absolute(other) > 1e-9 * reach) continue;
        inside = false;
        Simplex part = s;
        closest_on_triangle(part, f[0], f[1], f[2]);
        const double d2 = length_squared(point_of(part));
        if (d2 < nearest) {
            nearest = d2;
            best = part;
        }
    }
    if (inside) return true;
    s = best;
    return false;
}

}  // namespace

GjkResult gjk(const Convex& a, const Convex& b, Vec3 hint) {
    constexpr int rounds_max = 128;
    const double size = size_of(a) + size_of(b);
    const double overlap2 = 1e-26 * size * size;
    GjkResult result;
    Simplex s;
    const auto add = [&](Vec3 toward) {
        SimplexPoint p{.a = support(a, toward), .b = support(b, -toward), .w = {}};
        p.w = p.a - p.b;
        s.point[s.count] = p;
        s.weight[s.count] = 0;
        s.count++;
        return p.w;
    };
    const Vec3 centers = middle_of(b) - middle_of(a);
    add(length_squared(hint) > 0 ? hint : (length_squared(centers) > 0 ? centers : Vec3{1, 0, 0}));
    s.weight[0] = 1;
    Vec3 v = s.point[0].w;
    for (result.rounds = 1; result.rounds < rounds_max; result.rounds++) {
        const double v2 = length_squared(v);
        if (v2 <= overlap2) {
            result.simplex = s;
            return result;
        }
        const Simplex before = s;
        const Vec3 w = add(-v);
        // No point of the difference lies much nearer than v: the gap between the upper and the
        // lower bound of the distance.
        bool done = v2 - dot(v, w) <= 1e-12 * v2;
        for (int k = 0; k + 1 < s.count && !done; k++) done = s.point[k].w == w;
        if (done) {
            s = before;
            break;
        }
        if (s.count == 2)
            closest_on_segment(s, 0, 1);
        else if (s.count == 3)
            closest_on_triangle(s, 0, 1, 2);
        else if (closest_on_tetrahedron(s)) {
            result.simplex = s;
            return result;
        }
        const Vec3 next = point_of(s);
        if (length_squared(next) >= v2) {  // rounding: no progress any more
            s = before;
            break;
        }
        v = next;
    }
    for (int k = 0; k < s.count; k++) {
        result.on_a += s.point[k].a * s.weight[k];
        result.on_b += s.point[k].b * s.weight[k];
    }
    result.simplex = s;
    result.distance = length(v);
    if (result.distance > 0) result.normal = v * (-1 / result.distance);
    return result;
}

}  // namespace jostle::physics
