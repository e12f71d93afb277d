// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/time_of_impact.h"

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/collision/narrowphase/segments.h"
#include "physics/src/collision/narrowphase/triangle.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/geometry/surface.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// The advanced quantity: a distance and its direction as a function of time.
struct Gap {
    double distance;  // m
    Vec3 normal;      // from a to b
    Vec3 point;       // m, world, between the surfaces
    Vec3 turn;  // per step: estimated rotation of the normal with the feature that it belongs to
};

// Upper bound of the closing speed of any two points along any direction, m per step. Shapes that
// are further apart than this allows in the remaining time need no better direction.
double closing_at_most(const SweptShape& a, const SweptShape& b) {
    return length(a.sweep.translation - b.sweep.translation) +
           length(a.sweep.rotation_vector) * a.radius + length(b.sweep.rotation_vector) * b.radius;
}

// Upper bound of the closing speed of any two points along a direction, m per step.
double closing(const Sweep& a, double radius_a, const Sweep& b, double radius_b, Vec3 normal) {
    return dot(a.translation - b.translation, normal) +
           length(cross(normal, a.rotation_vector)) * radius_a +
           length(cross(normal, b.rotation_vector)) * radius_b;
}

// The part of the motion to test.
struct SweepInterval {
    double from, until;  // fractions of the step
    double gap;          // m
};

// Returns whether the bounding balls around the two bodies' centres never touch in the interval.
bool balls_pass_by(const SweptShape& a, const SweptShape& b, const SweepInterval& interval) {
    const Vec3 apart = center_at(b.sweep, interval.from) - center_at(a.sweep, interval.from);
    const Vec3 motion = b.sweep.translation - a.sweep.translation;
    const double speed2 = length_squared(motion);
    const double nearest =
        speed2 > 0 ? clamp(-dot(apart, motion) / speed2, 0, interval.until - interval.from) : 0;
    const double reach = a.radius + b.radius + 2 * interval.gap;
    ASSERT(a.radius >= 0 && b.radius >= 0 && !(interval.from > interval.until));
    return length_squared(apart + motion * nearest) > reach * reach;
}

// A lower bound of the time from fraction t during which the shapes stay separated, as a fraction
// of the step: at least `least`, which is already known. Beyond the end of `interval` if they do
// not touch in it.
//
// Second-order bound along a direction m = n + d n' that rotates as time d passes. The extent along
// m of a body that rotates by w in that time equals its initial extent along
//   m + d m x w + (at most d^2 w^2 |m| / 2) = n + d (n' + n x w) + (at most d^2 bend / radius).
// With the support functions h of the shapes about their bodies' centres, the gap times |m| is at
// least
//   m . (difference of centres) - ha(n + d (n' + n x wa)) - hb(-n - d (n' + n x wb)) - d^2 bend.
// Support functions are convex, so this bound is concave in d: if it is positive at both ends of an
// interval it is positive in between, and its chords lie below it. A direction that stays
// perpendicular to its face or edges loses nothing to their tilting: an impact takes 3 gap
// evaluations instead of 10.
template <class ExtentA, class ExtentB>
double safe_step(const SweptShape& a, const SweptShape& b, const Gap& now, double t,
                 const SweepInterval& interval, double least, ExtentA&& extent_a,
                 ExtentB&& extent_b) {
    const Vec3 n = now.normal, apart = center_at(b.sweep, t) - center_at(a.sweep, t);
    ASSERT(is_unit(n, 1e-4) && t >= interval.from && t <= interval.until);
    const Vec3 motion = b.sweep.translation - a.sweep.translation;
    const Vec3 across_a = cross(n, a.sweep.rotation_vector),
               across_b = cross(n, b.sweep.rotation_vector);
    const double high = interval.until - t;
    const double spin_a = length(a.sweep.rotation_vector), spin_b = length(b.sweep.rotation_vector);
    const auto bend = [&](double turn) {
        const double size = 1 + turn * high;
        return spin_a * (0.5 * spin_a * size + turn) * a.radius +
               spin_b * (0.5 * spin_b * size + turn) * b.radius;
    };
    const auto left_at = [&](Vec3 turn, double bent, double d) {
        const Vec3 m = n + turn * d;
        return dot(n, apart + motion * d) + d * dot(turn, apart) +
               d * d * (minimum(dot(turn, motion), 0) - bent) - extent_a(m + across_a * d) -
               extent_b(-(m + across_b * d)) - interval.gap * length(m);
    };
    const double fixed_bend = bend(0), fixed_left = left_at({}, fixed_bend, high);
    if (fixed_left > 0) return 2;
    const double turn_bend = bend(length(now.turn));
    const double turn_left = now.turn == Vec3{} ? fixed_left : left_at(now.turn, turn_bend, high);
    if (turn_left > 0) return 2;
    const bool turns = turn_left > fixed_left;
    const Vec3 turn = turns ? now.turn : Vec3{};
    const double bent = turns ? turn_bend : fixed_bend;
    double low = turns ? 0 : least, at_low = left_at(turn, bent, low), to = high,
           at_to = turns ? turn_left : fixed_left;
    for (int k = 0; k < 8 && at_low > 0.5 * interval.gap; k++) {
        const double chord = low + (to - low) * at_low / (at_low - at_to);
        const double at_chord = left_at(turn, bent, chord);
        if (at_chord <= 0) break;  // rounding
        low = chord;
        at_low = at_chord;
        const double middle = 0.5 * (low + to), at_middle = left_at(turn, bent, middle);
        (at_middle > 0 ? low : to) = middle;
        (at_middle > 0 ? at_low : at_to) = at_middle;
    }
    return maximum(low, least);
}

// The rotation of a normal n with the edges that it is perpendicular to, at u . n = 0 and v . n =
// 0. Either edge may be zero, which means none.
Vec3 turn_with_edges(Vec3 n, Vec3 u, Vec3 wu, Vec3 v, Vec3 wv) {
    // n' = x u + y v with u . n' = -(wu x u) . n and v . n' = -(wv x v) . n.
    const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), ru = -dot(cross(wu, u), n),
                 rv = -dot(cross(wv, v), n), det = uu * vv - uv * uv;
    if (det > 1e-6 * uu * vv)
        return (u * (ru * vv - rv * uv) + v * (rv * uu - ru * uv)) * (1 / det);
    if (uu > 0) return u * (ru / uu);
    return vv > 0 ? v * (rv / vv) : Vec3{};
}

// The feature of a shape that a normal belongs to, from the points that carry a gap: up to one
// point, two points of an edge, or three of a face.
struct ContactFeature {
    int points = 0;
    Vec3 first, edge;

    void add(Vec3 p) {
        if (points == 0) {
            first = p;
            points = 1;
        } else if (p != first && (points == 1 || p - first != edge)) {
            edge = p - first;
            points++;
        }
    }
};

// gap_at(t, exact): if not exact, it may return less than the distance. step_from(normal, t,
// least): safe_step() from the last gap.
template <class GapAt, class StepFrom>
Impact advance(const SweptShape& a, const SweptShape& b, const SweepInterval& interval,
               GapAt&& gap_at, StepFrom&& step_from) {
    constexpr int rounds_max = 400;
    double t = interval.from;
    for (int round = 0; round < rounds_max; round++) {
        const Gap now = gap_at(t, false);
        if (now.distance <= 2 * interval.gap) {
            if (round == 0) return {.at_start = true};
            break;
        }
        const double speed = closing(a.sweep, a.radius, b.sweep, b.radius, now.normal);
        // All points move apart along a separating direction: the shapes never touch.
        if (speed <= 0) return {};
        const double step = (now.distance - interval.gap) / speed;
        if (t + step > interval.until) return {};
        t += step_from(now, t, step);
        if (t > interval.until) return {};
    }
    // The shapes touch, or approach so slowly that the remaining step is shorter than rounding
    // resolves.
    const Gap there = gap_at(t, true);
    ASSERT(!(t < interval.from) && !(t > interval.until));
    return {.fraction = t, .normal = there.normal, .point = there.point};
}

Gap gap_of(const GjkResult& g, const SweptShape& a, const SweptShape& b, double radius_a,
           double radius_b, Vec3 origin) {
    ContactFeature fa, fb;
    for (int k = 0; k < g.simplex.count; k++) {
        fa.add(g.simplex.point[k].a);
        fb.add(g.simplex.point[k].b);
    }
    const Vec3 n = g.normal;
    Vec3 turn;
    if (fa.points > 2)
        turn = cross(a.sweep.rotation_vector, n);
    else if (fb.points > 2)
        turn = cross(b.sweep.rotation_vector, n);
    else
        turn = turn_with_edges(n, fa.edge - n * dot(fa.edge, n), a.sweep.rotation_vector,
                               fb.edge - n * dot(fb.edge, n), b.sweep.rotation_vector);
    return {g.distance - radius_a - radius_b, n,
            origin + (g.on_a + n * radius_a + g.on_b - n * radius_b) * 0.5, turn};
}

Convex convex_at(const SweptShape& shape, const TransformedShape& transformed, Vec3 origin) {
    Convex c = convex_of(transformed, origin);
    if (shape.scale == 1) return c;
    ASSERT(shape.scale > 0 && shape.scale < 1);
    const Vec3 middle = middle_of(c);
    c.position = middle + (c.position - middle) * shape.scale;
    c.axes = {c.axes.x * shape.scale, c.axes.y * shape.scale, c.axes.z * shape.scale};
    c.radius *= shape.scale;
    return c;
}

// The support function of a shape at an offset of `arm` from its body's centre.
auto extent_of(const Convex& c, Vec3 arm) {
    return [&c, arm](Vec3 direction) {
        return dot(support(c, direction) + arm, direction) + c.radius * length(direction);
    };
}

Impact plane_impact(const SweptShape& plane, const SweptShape& shape,
                    const SweepInterval& interval) {
    const auto gap_at = [&](double t, bool) {
        const TransformedShape pp = transformed_shape_at(plane, t),
                               ps = transformed_shape_at(shape, t);
        const Vec3 n = pp.axes * std::get<Plane>(*plane.geometry).normal;
        const Convex c = convex_at(shape, ps, pp.position);
        const Vec3 lowest = support(c, -n) - n * c.radius;
        const double distance = dot(lowest, n);
        return Gap{distance, n, pp.position + lowest - n * (0.5 * distance), {}};
    };
    return advance(plane, shape, interval, gap_at,
                   [](const Gap&, double, double least) { return least; });
}

Impact convex_impact(const SweptShape& a, const SweptShape& b, const SweepInterval& interval) {
    Vec3 hint, origin;
    Convex ca, cb;
    const double most = closing_at_most(a, b);
    const auto gap_at = [&](double t, bool exact) {
        const TransformedShape pa = transformed_shape_at(a, t), pb = transformed_shape_at(b, t);
        origin = pa.position;
        ca = convex_at(a, pa, origin);
        cb = convex_at(b, pb, origin);
        const double radii = ca.radius + cb.radius;
        const GjkGoal early{.beyond = radii + interval.gap + most * (interval.until - t),
                            .loose = tuning::loose_gap,
                            .radii = radii};
        const GjkResult g = gjk(ca, cb, hint, exact ? GjkGoal{} : early);
        hint = g.normal;
        return gap_of(g, a, b, ca.radius, cb.radius, origin);
    };
    return advance(a, b, interval, gap_at, [&](const Gap& now, double t, double least) {
        return safe_step(a, b, now, t, interval, least,
                         extent_of(ca, origin - center_at(a.sweep, t)),
                         extent_of(cb, origin - center_at(b.sweep, t)));
    });
}

// ---- spheres and capsules: balls around a segment, with a closed-form distance ----

bool is_rod(ShapeKind kind) {
    return kind == ShapeKind::sphere || kind == ShapeKind::capsule;
}

struct Rod {
    Vec3 middle, direction;  // m, world; unit
    double half, radius;     // m
};

Gap gap_of(const Rod& a, const Rod& b, Vec3 turn_a, Vec3 turn_b) {
    const SegmentPair at =
        closest_on_segments(a.middle, a.direction, a.half, b.middle, b.direction, b.half);
    const Vec3 on_a = a.middle + a.direction * at.s, on_b = b.middle + b.direction * at.t;
    const double apart = length(on_b - on_a);
    const Vec3 normal = normalized(on_b - on_a);
    const Vec3 edge_a = absolute(at.s) < a.half ? a.direction : Vec3{},
               edge_b = absolute(at.t) < b.half ? b.direction : Vec3{};
    return {apart - a.radius - b.radius, normal,
            (on_a + normal * a.radius + on_b - normal * b.radius) * 0.5,
            turn_with_edges(normal, edge_a, turn_a, edge_b, turn_b)};
}

Rod rod_at(const SweptShape& shape, double t) {
    const Vec3 center = center_at(shape.sweep, t);
    if (const auto* sphere = std::get_if<Sphere>(shape.geometry)) {
        const bool central = shape.offset == Vec3{};
        const Vec3 arm = central ? Vec3{} : rotate(rotation_at(shape.sweep, t), shape.offset);
        return {center + arm, {0, 1, 0}, 0, sphere->radius * shape.scale};
    }
    const auto& capsule = std::get<Capsule>(*shape.geometry);
    ASSERT(shape.scale > 0 && shape.scale <= 1);
    const Quat rotation = rotation_at(shape.sweep, t);
    return {center + rotate(rotation, shape.offset), rotate(rotation, shape.axes.y),
            capsule.half_length * shape.scale, capsule.radius * shape.scale};
}

auto extent_of(const Rod& rod, Vec3 center) {
    return [&rod, arm = rod.middle - center](Vec3 direction) {
        return dot(arm, direction) + rod.half * absolute(dot(rod.direction, direction)) +
               rod.radius * length(direction);
    };
}

Impact rod_impact(const SweptShape& a, const SweptShape& b, const SweepInterval& interval) {
    Rod ra, rb;
    const auto gap_at = [&](double t, bool) {
        ra = rod_at(a, t);
        rb = rod_at(b, t);
        return gap_of(ra, rb, a.sweep.rotation_vector, b.sweep.rotation_vector);
    };
    return advance(a, b, interval, gap_at, [&](const Gap& now, double t, double least) {
        return safe_step(a, b, now, t, interval, least, extent_of(ra, center_at(a.sweep, t)),
                         extent_of(rb, center_at(b.sweep, t)));
    });
}

// In the shape's own axes. Convex kinds only.
Aabb box_around(const Geometry& geometry) {
    if (const auto* box = std::get_if<Box>(&geometry))
        return {-box->half_extents, box->half_extents};
    if (const auto* hull = std::get_if<Hull>(&geometry)) return hull->data->bounds;
    return bounds_of({&geometry, {}, diagonal({1, 1, 1})});
}

// A bounding rod of any convex shape, along the longest side of its box.
Rod rod_around(const SweptShape& shape, double t) {
    if (is_rod(kind_of(*shape.geometry))) return rod_at(shape, t);
    const Aabb box = box_around(*shape.geometry);
    const Vec3 middle = (box.low + box.high) * 0.5, half = (box.high - box.low) * 0.5;
    const int i = half.x >= half.y ? (half.x >= half.z ? 0 : 2) : (half.y >= half.z ? 1 : 2);
    const double u = half[(i + 1) % 3], v = half[(i + 2) % 3];
    const Quat rotation = rotation_at(shape.sweep, t);
    const Vec3 center = center_at(shape.sweep, t);
    return {center + rotate(rotation, shape.offset + shape.axes * middle),
            rotate(rotation, i == 0 ? shape.axes.x : (i == 1 ? shape.axes.y : shape.axes.z)),
            half[i], square_root(u * u + v * v)};
}

// Returns whether the bounding rods of two shapes prove that they do not touch. This rejects most
// pairs of long thin shapes that rotate fast past each other, for which bounding balls are too
// coarse. Cheaper than the direction of their exact gap.
bool rods_pass_by(const SweptShape& a, const SweptShape& b, const SweepInterval& interval) {
    const Rod ra = rod_around(a, interval.from), rb = rod_around(b, interval.from);
    if (maximum(ra.half - 2 * ra.radius, rb.half - 2 * rb.radius) < 0) return false;
    // A gap clearly larger than any distance that counts as a touch, regardless of the measurement
    // error.
    const SweepInterval wider{interval.from, interval.until, 3 * interval.gap};
    const Gap now = gap_of(ra, rb, a.sweep.rotation_vector, b.sweep.rotation_vector);
    if (now.distance <= wider.gap) return false;
    const double speed = closing(a.sweep, a.radius, b.sweep, b.radius, now.normal);
    const double left = interval.until - interval.from;
    if (speed * left < now.distance - wider.gap) return true;
    return safe_step(a, b, now, interval.from, wider, (now.distance - wider.gap) / speed,
                     extent_of(ra, center_at(a.sweep, interval.from)),
                     extent_of(rb, center_at(b.sweep, interval.from))) > left;
}

// A ball around a convex shape in linear motion, and the additional deviation of the shape due to
// the rotation of its body.
struct SweptBall {
    Vec3 center, motion;  // m, at interval.from; m per step
    double reach;         // m
};
SweptBall swept_ball(const SweptShape& shape, const SweepInterval& interval) {
    const Aabb box = box_around(*shape.geometry);
    const Mat3 axes = to_matrix(rotation_at(shape.sweep, interval.from));
    const Vec3 arm = axes * (shape.offset + shape.axes * ((box.low + box.high) * 0.5));
    const Vec3 turn = shape.sweep.rotation_vector;
    const double left = interval.until - interval.from;
    return {
        center_at(shape.sweep, interval.from) + arm, shape.sweep.translation + cross(turn, arm),
        0.5 * length(box.high - box.low) + 0.5 * left * left * length_squared(turn) * length(arm)};
}

// Returns whether the bounding balls of two convex shapes never touch. For children of bodies they
// are tighter than the balls around the bodies.
bool children_pass_by(const SweptShape& a, const SweptShape& b, const SweepInterval& interval) {
    if (a.offset == Vec3{} && b.offset == Vec3{}) return false;
    const SweptBall ba = swept_ball(a, interval), bb = swept_ball(b, interval);
    const Vec3 apart = bb.center - ba.center, motion = bb.motion - ba.motion;
    const double speed2 = length_squared(motion);
    const double nearest =
        speed2 > 0 ? clamp(-dot(apart, motion) / speed2, 0, interval.until - interval.from) : 0;
    const double reach = ba.reach + bb.reach + 2 * interval.gap;
    return length_squared(apart + motion * nearest) > reach * reach;
}

// The swept box of the convex shape in `frame`. The relative motion does not sweep a box, so both
// motions are bounded in the world, and the box is transformed into the frame at the start of the
// interval.
Aabb swept_aabb_in(const SweptShape& frame, const SweptShape& shape,
                   const SweepInterval& interval) {
    const Aabb box = swept_bounds(shape, interval.from, interval.until);
    const Vec3 middle = (box.low + box.high) * 0.5, half = (box.high - box.low) * 0.5;
    // The motion of the frame itself during the interval.
    const double own =
        (length(frame.sweep.translation) +
         length(frame.sweep.rotation_vector) *
             (length(half) + length(middle - center_at(frame.sweep, interval.from)))) *
        (interval.until - interval.from);
    const TransformedShape p = transformed_shape_at(frame, interval.from);
    const Vec3 center = transposed_times(p.axes, middle - p.position);
    const Mat3 back = transpose(p.axes);
    const Vec3 reach = abs(back.x) * half.x + abs(back.y) * half.y + abs(back.z) * half.z;
    return grow({center - reach, center + reach}, own);
}

// Keeps the earlier impact of two parts.
void keep_first(Impact& best, const Impact& next) {
    const bool at_start = best.at_start || next.at_start;
    if (next.fraction < best.fraction) best = next;
    best.at_start = at_start;
}

Impact turned_round(Impact impact) {
    impact.normal = -impact.normal;
    return impact;
}

// Returns whether a shape stays on one side of a triangle, or of the plane that separates their
// nearest points, further away than a touch. Most triangles in the box around a motion are such,
// and the test needs no search. `triangle` and `shape`: poses at interval.from, relative to
// `origin`.
bool stays_separated(const SweptShape& surface, const SweptShape& moving, const Convex& triangle,
                     const Convex& shape, Vec3 origin, const SweepInterval& interval) {
    const SweepInterval wider{interval.from, interval.until, 3 * interval.gap};
    Vec3 corner[3];
    for (int k = 0; k < 3; k++) corner[k] = triangle.position + triangle.axes * triangle.corner[k];
    const Vec3 out = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double area2 = length_squared(out);
    if (area2 == 0) return false;
    const auto separates = [&](const Gap& now) {
        return now.distance > wider.gap &&
               safe_step(surface, moving, now, interval.from, wider, 0,
                         extent_of(triangle, origin - center_at(surface.sweep, interval.from)),
                         extent_of(shape, origin - center_at(moving.sweep, interval.from))) >
                   interval.until - interval.from;
    };
    const auto distance_along = [&](Vec3 n, Vec3 at) {
        return dot(support(shape, -n) - at, n) - shape.radius;
    };
    const Vec3 front = out * (1 / square_root(area2));
    const double in_front = distance_along(front, corner[0]),
                 behind = distance_along(-front, corner[0]);
    if (separates({maximum(in_front, behind), in_front > behind ? front : -front, {}, {}}))
        return true;
    // From the point of the triangle nearest to the centre of the shape to the centre.
    const Vec3 middle = middle_of(shape), at = nearest_on_triangle(corner, middle);
    const double distance = length(middle - at);
    if (distance <= 0) return false;
    const Vec3 n = (middle - at) * (1 / distance);
    return separates({distance_along(n, at), n, {}, {}});
}

Impact surface_impact(const SweptShape& surface, const SweptShape& shape,
                      const SweepInterval& interval) {
    Impact best;
    const double most = closing_at_most(surface, shape);
    const TransformedShape surface_now = transformed_shape_at(surface, interval.from),
                           shape_now = transformed_shape_at(shape, interval.from);
    const Convex convex_now = convex_at(shape, shape_now, shape_now.position);
    for_each_triangle(
        *surface.geometry, grow(swept_aabb_in(surface, shape, interval), 2 * interval.gap),
        [&](const SurfaceTriangle& t) {
            // Later touches are irrelevant.
            const SweepInterval left{interval.from, minimum(interval.until, best.fraction),
                                     interval.gap};
            Vec3 hint, origin = shape_now.position;
            Convex triangle =
                       triangle_convex(t.corner, surface_now.position - origin, surface_now.axes),
                   c;
            if (stays_separated(surface, shape, triangle, convex_now, origin, left)) return;
            const auto gap_at = [&](double at, bool exact) {
                const TransformedShape ps = transformed_shape_at(surface, at),
                                       pc = transformed_shape_at(shape, at);
                origin = pc.position;
                triangle = triangle_convex(t.corner, ps.position - origin, ps.axes);
                c = convex_at(shape, pc, origin);
                const GjkGoal early{.beyond = c.radius + left.gap + most * (left.until - at),
                                    .loose = tuning::loose_gap,
                                    .radii = c.radius};
                const GjkResult g = gjk(triangle, c, hint, exact ? GjkGoal{} : early);
                hint = g.normal;
                return gap_of(g, surface, shape, 0, c.radius, origin);
            };
            const auto step_from = [&](const Gap& now, double at, double least) {
                return safe_step(surface, shape, now, at, left, least,
                                 extent_of(triangle, origin - center_at(surface.sweep, at)),
                                 extent_of(c, origin - center_at(shape.sweep, at)));
            };
            keep_first(best, advance(surface, shape, left, gap_at, step_from));
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
    return s.center + s.translation * (fraction - s.from);
}
Quat rotation_at(const Sweep& s, double fraction) {
    if (s.rotation_vector == Vec3{} || fraction == s.from) return s.rotation;
    return from_rotation_vector(s.rotation_vector * (fraction - s.from)) *
           s.rotation;  // unit length up to rounding
}

TransformedShape transformed_shape_at(const SweptShape& shape, double fraction) {
    const Mat3 axes = to_matrix(rotation_at(shape.sweep, fraction));
    return {shape.geometry, center_at(shape.sweep, fraction) + axes * shape.offset,
            axes * shape.axes};
}

Aabb swept_bounds(const SweptShape& shape, double from, double until) {
    const Aabb start = bounds_of(transformed_shape_at(shape, from)),
               end = bounds_of(transformed_shape_at(shape, until));
    const Aabb both = unite(start, end);
    if (shape.sweep.rotation_vector == Vec3{}) return both;
    // On a circular path a point stays within the sagitta of its arc: r (1 - cos(angle / 2)).
    const double angle = length(shape.sweep.rotation_vector) * (until - from);
    ASSERT(!(until < from));
    const double bulge =
        angle < pi ? shape.radius * (1 - sin_cos(0.5 * angle).cos) : 2 * shape.radius;
    return grow(both, bulge);
}

Impact time_of_impact(const SweptShape& a, const SweptShape& b, double from, double gap,
                      double until) {
    const ShapeKind ka = kind_of(*a.geometry), kb = kind_of(*b.geometry);
    const SweepInterval interval{from, minimum(until, minimum(a.sweep.until, b.sweep.until)), gap};
    if (from > interval.until) return {};
    ASSERT(!(gap <= 0) && !(from < 0) && !(interval.until > 1));
    if (ka != ShapeKind::plane && kb != ShapeKind::plane && balls_pass_by(a, b, interval))
        return {};
    if (ka == ShapeKind::compound || kb == ShapeKind::compound) {
        const bool first = ka == ShapeKind::compound;
        const SweptShape &compound = first ? a : b, &other = first ? b : a;
        const CompoundShape& data = *std::get<Compound>(*compound.geometry).data;
        Impact best;
        const auto consider = [&](std::uint32_t k) {
            const SweptShape child = child_of(compound, data.children[k]);
            keep_first(best, time_of_impact(child, other, from, gap, interval.until));
        };
        const ShapeKind kind = first ? kb : ka;
        if (kind == ShapeKind::plane) {
            for (std::uint32_t k = 0; k < data.children.size(); k++) consider(k);
        } else {
            data.tree->query(grow(swept_aabb_in(compound, other, interval), 2 * gap), consider);
        }
        return first ? best : turned_round(best);
    }
    if (is_convex(ka) && is_convex(kb) && children_pass_by(a, b, interval)) return {};
    if (is_rod(ka) && is_rod(kb)) return rod_impact(a, b, interval);
    if (is_convex(ka) && is_convex(kb))
        return rods_pass_by(a, b, interval) ? Impact{} : convex_impact(a, b, interval);
    // Planes and surfaces do not collide with each other.
    if (is_convex(ka) == is_convex(kb)) return {};
    if (is_convex(ka)) return turned_round(time_of_impact(b, a, from, gap, interval.until));
    if (ka == ShapeKind::plane) return plane_impact(a, b, interval);
    return surface_impact(a, b, interval);
}

}  // namespace jostle::physics
