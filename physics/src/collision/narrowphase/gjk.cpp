// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/gjk.h"

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

// The points of a simplex that carry its closest point to the origin, and their weights.
struct SimplexCarrier {
    int count = 0;
    int which[3] = {};
    double weight[3] = {};
    Vec3 closest{};
    double distance2 = 1e300;  // m2, squared distance of that point from the origin
};

SimplexCarrier measured(const Simplex& s, SimplexCarrier c) {
    ASSERT(c.count >= 1 && c.count <= 3);
    for (int k = 0; k < c.count; k++) c.closest += s.point[c.which[k]].w * c.weight[k];
    c.distance2 = length_squared(c.closest);
    return c;
}

void reduce(Simplex& s, const SimplexCarrier& c) {
    ASSERT(c.count >= 1 && c.count <= 3 && c.count <= s.count);
    UninitializedArray<SimplexPoint, 3> point;
    for (int k = 0; k < c.count; k++) point[k] = s.point[c.which[k]];
    for (int k = 0; k < c.count; k++) {
        s.point[k] = point[k];
        s.weight[k] = c.weight[k];
    }
    s.count = c.count;
}

SimplexCarrier closest_on_segment(const Simplex& s, int i, int j) {
    ASSERT(i < s.count && j < s.count && i != j);
    const Vec3 a = s.point[i].w, ab = s.point[j].w - a;
    const double l2 = length_squared(ab), t = -dot(a, ab);
    if (t <= 0 || l2 == 0) return measured(s, {1, {i}, {1}});
    if (t >= l2) return measured(s, {1, {j}, {1}});
    return measured(s, {2, {i, j}, {1 - t / l2, t / l2}});
}

SimplexCarrier closest_on_triangle(const Simplex& s, int i, int j, int k) {
    const Vec3 a = s.point[i].w, b = s.point[j].w, c = s.point[k].w;
    const Vec3 ab = b - a, ac = c - a, n = cross(ab, ac);
    const double n2 = length_squared(n);
    const double longest = maximum(length_squared(ab), length_squared(ac));
    // In a sliver, which points on a rim can form, rounding decides. An edge is equally close.
    if (n2 > 1e-14 * longest * longest) {
        // Barycentric coordinates of the projected origin.
        const double u = dot(cross(b, c), n) / n2, v = dot(cross(c, a), n) / n2, w = 1 - u - v;
        if (u >= 0 && v >= 0 && w >= 0) return measured(s, {3, {i, j, k}, {u, v, w}});
    }
    // The projection is outside the triangle: use the closest of the three edges.
    SimplexCarrier best;
    const int ends[3][2] = {{i, j}, {j, k}, {k, i}};
    for (const auto& e : ends) {
        const SimplexCarrier edge = closest_on_segment(s, e[0], e[1]);
        if (edge.distance2 < best.distance2) best = edge;
    }
    return best;
}

// The result is empty if the origin is inside. A flat tetrahedron, which round shapes can form, has
// no inside: rounding decides on which side of its faces a point lies.
SimplexCarrier closest_on_tetrahedron(const Simplex& s) {
    static constexpr int face[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    double longest2 = 0;
    ASSERT(s.count == 4);
    for (int k = 1; k < 4; k++)
        longest2 = maximum(longest2, length_squared(s.point[k].w - s.point[0].w));
    SimplexCarrier best;
    for (const auto& f : face) {
        const Vec3 a = s.point[f[0]].w, b = s.point[f[1]].w, c = s.point[f[2]].w;
        const Vec3 n = cross(b - a, c - a);
        // Six times the volume, and the signed distance behind this face, seen from outside.
        const double other = dot(n, s.point[f[3]].w - a), origin = -dot(n, a);
        const bool thin = other * other <= 1e-22 * longest2 * longest2 * longest2;
        if (!thin && origin * other > 0) continue;
        const SimplexCarrier part = closest_on_triangle(s, f[0], f[1], f[2]);
        if (best.count == 0 || part.distance2 < best.distance2) best = part;
    }
    return best;
}

}  // namespace

GjkResult gjk(const Convex& a, const Convex& b, Vec3 hint, const GjkGoal& goal) {
    constexpr int rounds_max = 128;
    const double size = size_of(a) + size_of(b);
    const double overlap2 = 1e-26 * size * size;
    GjkResult result;
    Simplex& s = result.simplex;
    const auto add = [&](Vec3 toward) {
        SimplexPoint p{.a = support(a, toward), .b = support(b, -toward), .w = {}};
        p.w = p.a - p.b;
        s.point[s.count] = p;
        ASSERT(s.count < 4);
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
        if (v2 <= overlap2) return result;
        const Vec3 w = add(-v);
        // No point of the difference lies nearer than `along` in the direction of v. `along` is a
        // lower bound of the distance; |v| is an upper bound.
        const double along = dot(v, w);
        const double stays = along - maximum(0, dot(goal.motion, v));
        const bool far = stays > 0 && stays * stays > goal.beyond * goal.beyond * v2;
        double missing = 1e-12 * v2;
        if (goal.loose > 0)
            missing = maximum(missing, goal.loose * (v2 - goal.radii * square_root(v2)));
        bool done = far || v2 - along <= missing;
        if (done) result.distance = along / square_root(v2);
        for (int k = 0; k + 1 < s.count && !done; k++) done = s.point[k].w == w;
        if (done) {
            s.count--;
            break;
        }
        SimplexCarrier carrier;
        if (s.count == 2)
            carrier = closest_on_segment(s, 0, 1);
        else if (s.count == 3)
            carrier = closest_on_triangle(s, 0, 1, 2);
        else
            carrier = closest_on_tetrahedron(s);
        if (carrier.count == 0) return result;
        if (carrier.distance2 >= v2) {  // rounding prevents further progress
            s.count--;
            break;
        }
        reduce(s, carrier);
        v = carrier.closest;
    }
    for (int k = 0; k < s.count; k++) {
        result.on_a += s.point[k].a * s.weight[k];
        result.on_b += s.point[k].b * s.weight[k];
    }
    const double size_of_v = length(v);
    if (result.distance == 0) result.distance = size_of_v;
    ASSERT(result.distance >= 0 || goal.loose > 0 || goal.beyond < 1e300);
    if (size_of_v > 0) result.normal = v * (-1 / size_of_v);
    return result;
}

}  // namespace jostle::physics
