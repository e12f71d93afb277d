// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_pairs.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/segments.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// Two balls. `fallback` is the normal of concentric balls.
Manifold collide_balls(Vec3 a, double radius_a, Vec3 b, double radius_b, double margin,
                       Vec3 fallback = {0, 1, 0}) {
    const Vec3 d = b - a;
    const double l = length(d), gap = l - radius_a - radius_b;
    ASSERT(radius_a >= 0 && radius_b >= 0);
    Manifold m{.normal = l > 1e-12 ? d * (1 / l) : fallback, .distance = gap};
    if (gap > margin) return m;
    m.count = 1;
    m.gap[0] = gap;
    m.point[0] = a + m.normal * (radius_a + 0.5 * gap);
    return m;
}

// ---- box against segment, in the box's frame ----

struct BoxSegment {
    double t;          // parameter on the segment, -half..half
    double distance2;  // from the box; 0 if the point is inside or touches
};

double outside(double x, double h) {
    return x - minimum(maximum(x, -h), h);
}

// Closest point of the segment p + t d, |t| <= half, to the box. The squared distance is convex and
// piecewise quadratic in t, with breaks where a coordinate crosses a face. Walks the at most seven
// pieces to the one in which the slope changes sign.
BoxSegment closest_on_segment_to_box(Vec3 p, Vec3 d, double half, Vec3 h) {
    const auto slope = [&](double t) {
        double sum = 0;
        for (int k = 0; k < 3; k++) sum += d[k] * outside(p[k] + t * d[k], h[k]);
        return sum;
    };
    const auto distance2 = [&](double t) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            const double o = outside(p[k] + t * d[k], h[k]);
            sum += o * o;
        }
        return sum;
    };
    if (slope(-half) >= 0) return {-half, distance2(-half)};
    if (slope(half) <= 0) return {half, distance2(half)};
    // The breaks in ascending order, by insertion. There are at most six between the ends.
    double breaks[8];
    int count = 0;
    breaks[count++] = -half;
    for (int k = 0; k < 3; k++) {
        if (absolute(d[k]) < 1e-12) continue;
        for (const double side : {-h[k], h[k]}) {
            const double t = (side - p[k]) / d[k];
            if (!(-half < t && t < half)) continue;
            int at = count++;
            for (; breaks[at - 1] > t; at--) breaks[at] = breaks[at - 1];
            breaks[at] = t;
        }
    }
    breaks[count++] = half;
    ASSERT(count >= 2 && count <= 8);
    for (int k = 1; k < count; k++) {
        const double right = slope(breaks[k]);
        if (right < 0) continue;
        const double left = slope(breaks[k - 1]);
        const double width = breaks[k] - breaks[k - 1];
        const double t = right == left ? breaks[k] : breaks[k - 1] - left * width / (right - left);
        return {t, distance2(t)};
    }
    return {half, distance2(half)};
}

struct Span {
    double low, high;
};

// Clips a span of the segment to the slab between the two faces of one axis of the box.
Span between_faces(Span s, Vec3 p, Vec3 d, Vec3 h, int axis) {
    if (absolute(d[axis]) < 1e-12) return absolute(p[axis]) > h[axis] ? Span{1, -1} : s;
    const double t1 = (-h[axis] - p[axis]) / d[axis], t2 = (h[axis] - p[axis]) / d[axis];
    return {maximum(s.low, minimum(t1, t2)), minimum(s.high, maximum(t1, t2))};
}

// The part of the segment directly above the face `axis` of the box, where it can rest on that
// face.
Span over_face(Vec3 p, Vec3 d, double half, Vec3 h, int axis) {
    Span s{-half, half};
    for (int k = 0; k < 3; k++)
        if (k != axis) s = between_faces(s, p, d, h, k);
    return s;
}

Vec3 outside(Vec3 q, Vec3 h) {
    return {outside(q.x, h.x), outside(q.y, h.y), outside(q.z, h.z)};
}

}  // namespace

Manifold collide_spheres(const TransformedShape& a, const TransformedShape& b, double margin) {
    return collide_balls(a.position, std::get<Sphere>(*a.geometry).radius, b.position,
                         std::get<Sphere>(*b.geometry).radius, margin);
}

Manifold collide_sphere_capsule(const TransformedShape& a, const TransformedShape& b,
                                double margin) {
    const Capsule& capsule = std::get<Capsule>(*b.geometry);
    const double t =
        clamp(dot(a.position - b.position, b.axes.y), -capsule.half_length, capsule.half_length);
    return collide_balls(a.position, std::get<Sphere>(*a.geometry).radius,
                         b.position + b.axes.y * t, capsule.radius, margin, b.axes.x);
}

Manifold collide_capsules(const TransformedShape& a, const TransformedShape& b, double margin) {
    const Capsule& ca = std::get<Capsule>(*a.geometry);
    const Capsule& cb = std::get<Capsule>(*b.geometry);
    const Vec3 u = a.axes.y, v = b.axes.y;
    const SegmentPair at =
        closest_on_segments(a.position, u, ca.half_length, b.position, v, cb.half_length);
    const Vec3 across = normalized(cross(u, v), a.axes.x);
    Manifold m = collide_balls(a.position + u * at.s, ca.radius, b.position + v * at.t, cb.radius,
                               margin, across);
    // Nearly parallel capsules: the ends of their overlap with their own distances, and two points
    // around the closest point if the capsules cross. On that point alone they would rock.
    const double c = dot(u, v);
    if (m.count == 0 || c * c < 0.75 || absolute(dot(m.normal, u)) > 0.1) return m;
    const double r = dot(b.position - a.position, u), reach = cb.half_length * absolute(c);
    const double low = maximum(-ca.half_length, r - reach);
    const double high = minimum(ca.half_length, r + reach);
    const double thin = minimum(ca.radius, cb.radius);
    if (high - low < 0.1 * thin) return m;
    Manifold line{.normal = m.normal, .distance = m.distance};
    double nearer = margin;
    const auto add = [&](const Manifold& balls) {
        if (balls.count == 0) return;
        nearer = minimum(nearer, balls.gap[0]);
        line.gap[line.count] = balls.gap[0];
        ASSERT(line.count < 4);
        line.point[line.count++] = balls.point[0];
    };
    const auto add_at = [&](double s) {
        const Vec3 pa = a.position + u * s;
        const double t = clamp(dot(pa - b.position, v), -cb.half_length, cb.half_length);
        add(collide_balls(pa, ca.radius, b.position + v * t, cb.radius, margin, across));
    };
    add_at(low);
    add_at(high);
    if (line.count > 0 && m.distance >= nearer - tuning::same_gap * thin) return line;
    const double aside = half_of_crossing(ca.radius + cb.radius, thin, c);
    for (const double s : {at.s - aside, at.s + aside})
        if (low < s && s < high) add_at(s);
    if (line.count == 0) add(m);
    return line;
}

Manifold collide_box_sphere(const TransformedShape& a, const TransformedShape& b, double margin) {
    const Vec3 h = std::get<Box>(*a.geometry).half_extents;
    const double r = std::get<Sphere>(*b.geometry).radius;
    const Vec3 l = transposed_times(a.axes, b.position - a.position);
    const Vec3 out = outside(l, h);
    const double out2 = length_squared(out);
    Vec3 n;
    double distance;
    if (out2 > 1e-20) {
        distance = square_root(out2);
        n = out * (1 / distance);
    } else {
        // The centre is inside the box: separate through the nearest face.
        int face = 0;
        for (int k = 1; k < 3; k++)
            if (absolute(l[k]) - h[k] > absolute(l[face]) - h[face]) face = k;
        distance = absolute(l[face]) - h[face];
        n[face] = l[face] < 0 ? -1 : 1;
    }
    Manifold m{.normal = a.axes * n, .distance = distance - r};
    ASSERT(is_unit(m.normal));
    if (m.distance > margin) return m;
    m.count = 1;
    m.gap[0] = m.distance;
    m.point[0] = b.position - m.normal * (r + 0.5 * m.distance);
    return m;
}

std::optional<Manifold> collide_box_capsule(const TransformedShape& a, const TransformedShape& b,
                                            double margin) {
    const Vec3 h = std::get<Box>(*a.geometry).half_extents;
    const Capsule& capsule = std::get<Capsule>(*b.geometry);
    const double r = capsule.radius, half = capsule.half_length;
    const Vec3 p = transposed_times(a.axes, b.position - a.position);
    const Vec3 d = transposed_times(a.axes, b.axes.y);

    const BoxSegment near = closest_on_segment_to_box(p, d, half, h);
    if (near.distance2 <= 1e-20) return std::nullopt;
    const Vec3 out = outside(p + d * near.t, h);
    const double distance = square_root(near.distance2), gap = distance - r;
    const Vec3 n = out * (1 / distance);
    Manifold m{.normal = a.axes * n, .distance = gap};
    ASSERT(is_unit(m.normal));
    if (gap > margin) return m;

    const auto add = [&](double at, double point_gap) {
        m.gap[m.count] = point_gap;
        ASSERT(m.count < 4);
        m.point[m.count] = b.position + b.axes.y * at - m.normal * (r + 0.5 * point_gap);
        m.count++;
    };
    // The capsule lies along an edge, on either side of it: two points at the ends of the overlap,
    // with their own distances from the box, and two around the closest point if they cross. On
    // that point alone the capsule would rock from end to end.
    for (int k = 0; k < 3; k++) {
        if (absolute(d[k]) < 0.995 || absolute(n[k]) > 0.1) continue;
        const Span along = between_faces({-half, half}, p, d, h, k);
        if (along.high - along.low < 0.1 * r) break;
        double nearer = margin;
        const auto add_at = [&](double at) {
            const double point_gap = length(outside(p + d * at, h)) - r;
            nearer = minimum(nearer, point_gap);
            if (point_gap <= margin) add(at, point_gap);
        };
        add_at(along.low);
        add_at(along.high);
        if (m.count > 0 && gap >= nearer - tuning::same_gap * r) return m;
        const double aside = half_of_crossing(r, r, d[k]);
        for (const double at : {near.t - aside, near.t + aside})
            if (along.low < at && at < along.high) add_at(at);
        if (m.count == 0) add(near.t, gap);
        return m;
    }
    // The capsule lies on a face: two points at the ends of the part above the face. Above the rim
    // of the face the normal tilts, and heights above the face are not gaps.
    for (int k = 0; k < 3; k++) {
        if (absolute(n[k]) < 0.99 || absolute(d[k]) > 0.2) continue;
        if (absolute(n[k]) < 1 - 1e-9) return std::nullopt;
        const Span over = over_face(p, d, half, h, k);
        if (over.high - over.low < 0.1 * r) break;
        const double sign = n[k] < 0 ? -1 : 1;
        for (const double at : {over.low, over.high}) {
            const double point_gap = sign * (p[k] + at * d[k]) - h[k] - r;
            if (point_gap <= margin) add(at, point_gap);
        }
        if (m.count > 0) return m;
    }
    add(near.t, gap);
    return m;
}

}  // namespace jostle::physics
