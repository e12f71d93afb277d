// SPDX-License-Identifier: MIT
#include "collision/narrowphase/time_of_impact.h"

#include <vector>

#include "collision/narrowphase/collide_composite.h"
#include "collision/narrowphase/gjk.h"
#include "collision/narrowphase/shape_distance.h"
#include "geometry/bounds.h"
#include "geometry/bvh.h"
#include "geometry/surface.h"
#include "jostle/physics/compound.h"

namespace jostle::physics {
namespace {

// What is advanced: a distance and its direction as a function of time.
struct Gap {
    double distance;  // m
    Vec3 normal;      // from a to b
};

// Gaps need not be exact to advance safely: a direction that separates by nearly as much will do.
constexpr double loose = 0.1;

// Fastest closing of any two points along any direction, m per step: what is further apart than
// they can come in the time that is left needs no better direction.
double closing_at_most(const SweptShape& a, const SweptShape& b) {
    return length(a.sweep.motion - b.sweep.motion) + length(a.sweep.turn) * a.radius +
           length(b.sweep.turn) * b.radius;
}

// Fastest closing of any two points along a direction, m per step.
double closing(const Sweep& a, double radius_a, const Sweep& b, double radius_b, Vec3 normal) {
    return dot(a.motion - b.motion, normal) + length(cross(normal, a.turn)) * radius_a +
           length(cross(normal, b.turn)) * radius_b;
}

// Whether the balls around the two bodies' centres never touch on the way.
bool pass_by(const SweptShape& a, const SweptShape& b, double from, double gap) {
    const Vec3 apart = center_at(b.sweep, from) - center_at(a.sweep, from);
    const Vec3 motion = b.sweep.motion - a.sweep.motion;
    const double speed2 = length_squared(motion);
    const double nearest = speed2 > 0 ? clamp(-dot(apart, motion) / speed2, 0, 1 - from) : 0;
    const double reach = a.radius + b.radius + 2 * gap;
    return length_squared(apart + motion * nearest) > reach * reach;
}

template <class GapAt>
std::optional<Impact> advance(const SweptShape& a, const SweptShape& b, double from, double gap,
                              GapAt&& gap_at) {
    constexpr int rounds_max = 400;
    double t = from;
    for (int round = 0; round < rounds_max; round++) {
        const Gap now = gap_at(t);
        if (now.distance <= 2 * gap) return Impact{t, round == 0};
        const double speed = closing(a.sweep, a.radius, b.sweep, b.radius, now.normal);
        // All points move apart along a direction that separates: they never meet.
        if (speed <= 0) return std::nullopt;
        t += (now.distance - gap) / speed;
        if (t > 1) return std::nullopt;
    }
    // Creeping towards each other: what is left of the step is shorter than rounding can tell.
    return Impact{t, false};
}

std::optional<Impact> simple_impact(const SweptShape& a, const SweptShape& b, double from,
                                    double gap) {
    PairCache cache;
    const double most = closing_at_most(a, b);
    return advance(a, b, from, gap, [&](double t) {
        const Placed pa = placed_at(a, t), pb = placed_at(b, t);
        if (kind_of(*a.geometry) == ShapeKind::plane || kind_of(*b.geometry) == ShapeKind::plane) {
            const SignedDistance d = signed_distance(pa, pb, cache);
            return Gap{d.distance, d.normal};
        }
        const Convex ca = convex_of(pa, pa.position), cb = convex_of(pb, pa.position);
        const double radii = ca.radius + cb.radius;
        const GjkResult g =
            gjk(ca, cb, cache.direction,
                {.beyond = radii + gap + most * (1 - t), .loose = loose, .radii = radii});
        cache.direction = g.normal;
        return Gap{g.distance - radii, g.normal};
    });
}

// The convex shape's whole way in the other's frame at rest is not a box; both ways are taken in
// the world and the box is turned into the frame of `frame` as it stands at `from` and at the end.
Aabb way_in(const SweptShape& frame, const SweptShape& shape, double from) {
    const Aabb box = swept_bounds(shape, from);
    const Vec3 middle = (box.low + box.high) * 0.5, half = (box.high - box.low) * 0.5;
    // How far the frame itself moves meanwhile.
    const double own = (length(frame.sweep.motion) +
                        length(frame.sweep.turn) *
                            (length(half) + length(middle - center_at(frame.sweep, from)))) *
                       (1 - from);
    const Placed p = placed_at(frame, from);
    const Vec3 center = transposed_times(p.axes, middle - p.position);
    const Mat3 back = transpose(p.axes);
    const Vec3 reach = abs(back.x) * half.x + abs(back.y) * half.y + abs(back.z) * half.z;
    return grow({center - reach, center + reach}, own);
}

// Of several parts: the first that is met on the way, for what touches at the start does not end
// it; that they touch at the start when nothing is met.
void keep_first(std::optional<Impact>& best, const std::optional<Impact>& next) {
    if (!next) return;
    if (!best || (best->at_start && !next->at_start) ||
        (best->at_start == next->at_start && next->fraction < best->fraction))
        best = next;
}

std::optional<Impact> surface_impact(const SweptShape& surface, const SweptShape& shape,
                                     double from, double gap) {
    std::optional<Impact> best;
    const double most = closing_at_most(surface, shape);
    for_each_triangle(*surface.geometry, grow(way_in(surface, shape, from), 2 * gap),
                      [&](const SurfaceTriangle& t) {
                          PairCache cache;
                          const auto hit = advance(surface, shape, from, gap, [&](double at) {
                              const Placed ps = placed_at(surface, at), pc = placed_at(shape, at);
                              const Convex triangle =
                                  triangle_convex(t.corner, ps.position - pc.position, ps.axes);
                              const Convex c = convex_of(pc, pc.position);
                              const GjkResult g = gjk(triangle, c, cache.direction,
                                                      {.beyond = c.radius + gap + most * (1 - at),
                                                       .loose = loose,
                                                       .radii = c.radius});
                              cache.direction = g.normal;
                              return Gap{g.distance - c.radius, g.normal};
                          });
                          keep_first(best, hit);
                      });
    return best;
}

SweptShape child_of(const SweptShape& compound, const CompoundChild& child) {
    SweptShape s = compound;
    s.geometry = &child.geometry;
    s.offset = compound.offset + compound.axes * child.pose.position;
    s.axes = compound.axes * to_matrix(child.pose.rotation);
    return s;
}

}  // namespace

Vec3 center_at(const Sweep& s, double fraction) {
    return s.center + s.motion * (fraction - s.from);
}
Quat rotation_at(const Sweep& s, double fraction) {
    if (s.turn == Vec3{}) return s.rotation;
    return normalized(from_rotation_vector(s.turn * (fraction - s.from)) * s.rotation);
}

Placed placed_at(const SweptShape& shape, double fraction) {
    const Mat3 axes = to_matrix(rotation_at(shape.sweep, fraction));
    return {shape.geometry, center_at(shape.sweep, fraction) + axes * shape.offset,
            axes * shape.axes};
}

Aabb swept_bounds(const SweptShape& shape, double from) {
    const Aabb start = bounds_of(placed_at(shape, from)), end = bounds_of(placed_at(shape, 1));
    const Aabb both = unite(start, end);
    if (shape.sweep.turn == Vec3{}) return both;
    // On its way round a point stays within the chord of its arc: r (1 - cos(angle / 2)).
    const double angle = length(shape.sweep.turn) * (1 - from);
    const double bulge =
        angle < pi ? shape.radius * (1 - sin_cos(0.5 * angle).cos) : 2 * shape.radius;
    return grow(both, bulge);
}

std::optional<Impact> time_of_impact(const SweptShape& a, const SweptShape& b, double from,
                                     double gap) {
    const ShapeKind ka = kind_of(*a.geometry), kb = kind_of(*b.geometry);
    if (ka != ShapeKind::plane && kb != ShapeKind::plane && pass_by(a, b, from, gap))
        return std::nullopt;
    if (ka == ShapeKind::compound || kb == ShapeKind::compound) {
        const bool first = ka == ShapeKind::compound;
        const SweptShape &compound = first ? a : b, &other = first ? b : a;
        const CompoundShape& data = *std::get<Compound>(*compound.geometry).data;
        std::optional<Impact> best;
        const auto consider = [&](std::uint32_t k) {
            keep_first(best,
                       time_of_impact(child_of(compound, data.children[k]), other, from, gap));
        };
        const ShapeKind kind = first ? kb : ka;
        if (kind == ShapeKind::plane) {
            for (std::uint32_t k = 0; k < data.children.size(); k++) consider(k);
        } else {
            data.tree->query(grow(way_in(compound, other, from), 2 * gap), consider);
        }
        return best;
    }
    const auto is_surface = [](ShapeKind k) {
        return k == ShapeKind::mesh || k == ShapeKind::height_field;
    };
    if (is_surface(ka)) return is_convex(kb) ? surface_impact(a, b, from, gap) : std::nullopt;
    if (is_surface(kb)) return is_convex(ka) ? surface_impact(b, a, from, gap) : std::nullopt;
    return simple_impact(a, b, from, gap);
}

}  // namespace jostle::physics
