// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_pairs.h"

#include "jostle/base/check.h"
#include "physics/src/geometry/outline.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

constexpr AxisCode side_of_a = 1u << 16, side_of_b = 2u << 16;

int sides_of(const Outline& o) {
    return o.count == 1 ? 0 : o.count;
}
Vec3 end_of(const Outline& o, int side) {
    ASSERT(side >= 0 && side < o.count);
    return o.corner[(side + 1) % o.count];
}
// Outward normal: to the right of a side, because sides run counter-clockwise.
Vec3 normal_of(const Outline& o, int side) {
    const Vec3 d = end_of(o, side) - o.corner[side];
    return normalized(Vec3{d.y, -d.x, 0});
}

struct Axis {
    double separation = -1e300;  // of the cores
    Vec3 normal;                 // out of the outline that owns the side
    int side = -1;
};

Axis along_side(const Outline& of, const Outline& other, int side) {
    const Vec3 n = normal_of(of, side);
    ASSERT(other.count > 0);
    double lowest = 1e300;
    for (int k = 0; k < other.count; k++)
        lowest = minimum(lowest, dot(n, other.corner[k] - of.corner[side]));
    return {lowest, n, side};
}

Axis best_side(const Outline& of, const Outline& other, int cached, double tie) {
    Axis best;
    for (int k = 0; k < sides_of(of); k++) {
        const Axis axis = along_side(of, other, k);
        if (axis.separation > best.separation) best = axis;
    }
    if (cached >= 0 && cached < sides_of(of)) {
        const Axis old = along_side(of, other, cached);
        if (old.separation > best.separation - tie) best = old;
    }
    return best;
}

struct NearestFeatures {
    double distance2 = 1e300;
    Vec3 on_a, on_b;
};

void consider(NearestFeatures& best, Vec3 corner, Vec3 from, Vec3 to, bool corner_is_a) {
    const Vec3 d = to - from;
    const double l2 = length_squared(d), t = l2 > 0 ? clamp(dot(corner - from, d) / l2, 0, 1) : 0;
    const Vec3 q = from + d * t;
    const double d2 = length_squared(corner - q);
    if (d2 >= best.distance2) return;
    best.distance2 = d2;
    best.on_a = corner_is_a ? corner : q;
    best.on_b = corner_is_a ? q : corner;
}

// Closest points of two separated outlines: a corner of one and a side of the other.
NearestFeatures nearest(const Outline& a, const Outline& b) {
    NearestFeatures best;
    ASSERT(a.count > 0 && b.count > 0);
    for (int k = 0; k < a.count; k++)
        for (int s = 0; s < b.count; s++)
            consider(best, a.corner[k], b.corner[s], end_of(b, s), true);
    for (int k = 0; k < b.count; k++)
        for (int s = 0; s < a.count; s++)
            consider(best, b.corner[k], a.corner[s], end_of(a, s), false);
    return best;
}

// The side whose normal is most antiparallel to n.
int facing_side(const Outline& o, Vec3 n) {
    int best = 0;
    double most = 1e300;
    for (int k = 0; k < sides_of(o); k++) {
        const double along = dot(normal_of(o, k), n);
        if (along < most - 1e-9) {
            most = along;
            best = k;
        }
    }
    return best;
}

// n points out of the reference outline.
Manifold cut_side(const Outline& reference, const Outline& other, const Axis& axis, double margin,
                  bool reference_is_a) {
    const Vec3 n = axis.normal, from = reference.corner[axis.side];
    ASSERT(axis.side >= 0 && axis.side < reference.count && is_unit(n));
    const Vec3 along = normalized(end_of(reference, axis.side) - from);
    const double width = dot(end_of(reference, axis.side) - from, along);
    Manifold m{.normal = reference_is_a ? n : -n};
    Vec3 p = other.corner[0], q = p;
    if (other.count > 1) {
        const int side = facing_side(other, n);
        p = other.corner[side];
        q = end_of(other, side);
        // Clip to the width of the reference side. Rounding may move a clipped point off the side.
        const double sp = dot(p - from, along), sq = dot(q - from, along);
        const auto at = [&](double s) { return p + (q - p) * ((s - sp) / (sq - sp)); };
        if (sp != sq) {
            const Vec3 first = p, last = q;
            if (sp < 0) p = at(minimum(0, maximum(sp, sq)));
            if (sp > width) p = at(maximum(width, minimum(sp, sq)));
            if (sq < 0)
                q = first + (last - first) * ((minimum(0, maximum(sp, sq)) - sp) / (sq - sp));
            if (sq > width)
                q = first + (last - first) * ((maximum(width, minimum(sp, sq)) - sp) / (sq - sp));
        }
    }
    const auto add = [&](Vec3 on_other) {
        const double core = dot(on_other - from, n);
        const double gap = core - reference.radius - other.radius;
        m.distance = m.count == 0 ? gap : minimum(m.distance, gap);
        if (gap > margin) return;
        m.gap[m.count] = gap;
        ASSERT(m.count < 2);
        // Midway between the two surfaces.
        m.point[m.count] = on_other - n * (other.radius + 0.5 * gap);
        m.count++;
    };
    add(p);
    if (length_squared(q - p) > 1e-18) add(q);
    return m;
}

Manifold collide_outlines(const Outline& a, const Outline& b, double margin, PairCache& cache) {
    // The size of the smaller outline determines the tolerance.
    const auto size_of = [](const Outline& o) {
        return o.radius + length(o.corner[o.count / 2] - o.corner[0]);
    };
    const double tie = 2e-5 * minimum(size_of(a), size_of(b));
    const auto cached = [&](AxisCode of) {
        return (cache.axis & (3u << 16)) == of ? static_cast<int>(cache.axis & 0xffff) : -1;
    };
    const Axis on_a = best_side(a, b, cached(side_of_a), tie);
    const Axis on_b = best_side(b, a, cached(side_of_b), tie);
    const double radii = a.radius + b.radius;
    ASSERT(radii >= 0);
    const double core = maximum(on_a.separation, on_b.separation);
    if (core - radii > margin)
        return {.normal = on_a.separation >= on_b.separation ? on_a.normal : -on_b.normal,
                .distance = core - radii};
    if (core > 0 || core < -1e299) {
        // Separated outlines: corners may be closer to each other than any side axis shows.
        const NearestFeatures near = nearest(a, b);
        const double d = square_root(near.distance2);
        if (d - radii > margin)
            return {.normal = (near.on_b - near.on_a) / d, .distance = d - radii};
        if (d > core + tie || core < -1e299) {
            Manifold m{.count = 1, .distance = d - radii};
            m.normal = d > 1e-12 ? (near.on_b - near.on_a) / d : Vec3{0, 1, 0};
            m.gap[0] = m.distance;
            m.point[0] = near.on_a + m.normal * (a.radius + 0.5 * m.distance);
            cache.axis = 0;
            return m;
        }
    }
    const bool a_is_reference =
        on_a.separation >= on_b.separation - (cached(side_of_a) >= 0 ? tie : -tie);
    if (a_is_reference) {
        cache.axis = side_of_a | static_cast<AxisCode>(on_a.side);
        return cut_side(a, b, on_a, margin, true);
    }
    cache.axis = side_of_b | static_cast<AxisCode>(on_b.side);
    return cut_side(b, a, on_b, margin, false);
}

// The two lowest corners above a half plane.
Manifold over_plane(const TransformedShape& plane, const TransformedShape& shape, double margin) {
    const Vec3 n = plane.axes * std::get<Plane>(*plane.geometry).normal;
    const Outline o = outline_of(shape, shape.position);
    const double height = dot(shape.position - plane.position, n) - o.radius;
    int low[2] = {-1, -1};
    const auto gap_of = [&](int k) { return height + dot(o.corner[k], n); };
    for (int k = 0; k < o.count; k++) {
        if (low[0] < 0 || gap_of(k) < gap_of(low[0]) - 1e-12) {
            low[1] = low[0];
            low[0] = k;
        } else if (low[1] < 0 || gap_of(k) < gap_of(low[1]) - 1e-12) {
            low[1] = k;
        }
    }
    Manifold m{.normal = n, .distance = gap_of(low[0])};
    ASSERT(low[0] >= 0 && is_unit(n));
    for (const int k : low) {
        if (k < 0 || gap_of(k) > margin) continue;
        m.gap[m.count] = gap_of(k);
        m.point[m.count] = shape.position + o.corner[k] - n * (o.radius + 0.5 * gap_of(k));
        m.count++;
    }
    return m;
}

}  // namespace

Manifold collide_planar(const TransformedShape& a, const TransformedShape& b, double margin,
                        PairCache& cache) {
    if (kind_of(*a.geometry) == ShapeKind::plane) return over_plane(a, b, margin);
    if (kind_of(*b.geometry) == ShapeKind::plane) return flipped(over_plane(b, a, margin));
    Manifold m =
        collide_outlines(outline_of(a, a.position), outline_of(b, a.position), margin, cache);
    for (int k = 0; k < m.count; k++) m.point[k] += a.position;
    return m;
}

}  // namespace jostle::physics
