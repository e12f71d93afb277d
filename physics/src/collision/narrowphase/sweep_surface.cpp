// SPDX-License-Identifier: MIT
//
// For a direction n from the triangle to the shape, the gap along n closes by -m.n per unit of the
// fraction. The shape does not touch before the gap is closed. This bound costs one support point.
// The sweep first tests three directions: the sides of the triangle's box, its normal, and the
// direction from its nearest point to the shape's centre. If the deepest point along the normal
// lands inside the triangle, the bound is the exact result. The remaining triangles are searched by
// conservative advancement: Newton's method on a distance that is convex in the fraction.
#include "physics/src/collision/narrowphase/sweep_surface.h"

#include <algorithm>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide_surface.h"
#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/collision/narrowphase/sweep_cup.h"
#include "physics/src/collision/narrowphase/sweep_lanes.h"
#include "physics/src/collision/narrowphase/triangle.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/grid_lanes.h"
#include "physics/src/geometry/ray.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/geometry/surface.h"

namespace jostle::physics {
namespace {

constexpr double beyond_reach = 2;

// Triangles are queried in boxes around parts of the motion, because the box of a whole diagonal
// motion could contain a hillside. part_length: length of a part in multiples of the shape's size.
// parts_max: maximum number of parts.
constexpr double part_length = 6;
constexpr double parts_max = 256;

struct Candidate {
    double enters;  // the fraction before which it is not touched
    std::uint32_t triangle;
};

class SurfaceSweep {
public:
    SurfaceSweep(const TransformedShape& surface, const TransformedShape& convex, Vec3 motion,
                 double gap)
        : surface_(surface),
          // In the surface's frame, relative to the shape's start position.
          origin_(transposed_times(surface.axes, convex.position - surface.position)),
          motion_(transposed_times(surface.axes, motion)),
          local_{convex.geometry, {}, transpose(surface.axes) * convex.axes},
          shape_(convex_of(local_, {})),
          box_(grow(bounds_of(local_), 2 * gap)),
          middle_(middle_of(shape_)),
          gap_(gap),
          lanes_(shape_, middle_ + origin_, {box_.low + origin_, box_.high + origin_}, motion_,
                 2 * gap) {}

    std::optional<SurfaceTouch> first() {
        const double size = maximum(0.5 * length(box_.high - box_.low), 1e-300);
        const double sweep_distance = length(motion_);
        double parts = 1, part = 0;
        ASSERT(!(gap_ <= 0));
        if (sweep_distance > part_length * size) {
            const double begin = enters_surface();
            if (begin > 1) return std::nullopt;
            parts = minimum(std::ceil(sweep_distance / (part_length * size)), parts_max);
            ASSERT(parts >= 1 && begin >= 0);
            part = std::floor(minimum(begin * parts, parts - 1));
        }
        for (; part < parts && best_.fraction > part / parts; part++)
            sweep_part(part / parts, (part + 1) / parts);
        if (best_.fraction > 1) return std::nullopt;
        if (!best_.settled) find_normal();
        if (best_.settled) {
            best_.point = surface_.position + surface_.axes * (best_.point + origin_);
            best_.normal = surface_.axes * best_.normal;
        }
        return best_;
    }

private:
    // The fraction at which the box of the shape reaches the box of the surface; more than 1 if it
    // does not.
    double enters_surface() const {
        const auto* mesh = std::get_if<Mesh>(surface_.geometry);
        const Aabb& all = mesh != nullptr ? mesh->data->bounds
                                          : std::get<HeightField>(*surface_.geometry).data->bounds;
        const Vec3 reach = (box_.high - box_.low) * 0.5, center = (box_.low + box_.high) * 0.5;
        return ray_enters({all.low - reach, all.high + reach}, origin_ + center, motion_, 1);
    }

    void sweep_part(double from, double until) {
        candidates_.clear();
        from_ = from;
        ASSERT(from < until && until <= 1 + 1e-12);
        const Vec3 there = origin_ + motion_ * from, on = motion_ * (until - from);
        const Aabb box{box_.low + there + min(on, Vec3{}), box_.high + there + max(on, Vec3{})};
        lanes_.set_interval(from, minimum(until, best_.fraction));
        const auto test_triangle = [&](const SurfaceTriangle& t) {
            const Aabb own{min(t.corner[0], min(t.corner[1], t.corner[2])),
                           max(t.corner[0], max(t.corner[1], t.corner[2]))};
            if (!overlap(own, box)) return;
            const double old_fraction = best_.fraction;
            test_fast(t, until);
            // Later touches are irrelevant.
            if (best_.fraction < old_fraction)
                lanes_.set_interval(from, minimum(until, best_.fraction));
        };
        if (const auto* mesh = std::get_if<Mesh>(surface_.geometry))
            mesh->data->tree->nearest_first(lanes_, [&](std::uint32_t index) {
                test_triangle(triangle_of(*mesh->data, index));
            });
        else
            nearest_cell_first(*std::get<HeightField>(*surface_.geometry).data, box,
                               origin_ + middle_ + motion_ * until, lanes_, test_triangle);
        std::sort(
            candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
                return a.enters < b.enters || (a.enters == b.enters && a.triangle < b.triangle);
            });
        for (const Candidate& next : candidates_) {
            if (next.enters >= best_.fraction) return;
            touch(triangle_of(*surface_.geometry, next.triangle), next.enters,
                  minimum(until, best_.fraction));
        }
    }

    // The fraction before which a gap along the unit vector n at the start is not closed. Half a
    // gap allows for rounding: a triangle in the plane of a touched face is not touched earlier.
    double enters_along(double apart, Vec3 n) const {
        if (apart <= 2 * gap_) return 0;
        const double speed = -dot(motion_, n);
        return speed > 0 ? (apart - 0.5 * gap_) / speed : beyond_reach;
    }

    // Tests a triangle by its plane and its box.
    void test_fast(const SurfaceTriangle& t, double until) {
        const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                t.corner[2] - origin_};
        if (cup_.hides(corner)) return;
        const double last = minimum(until, best_.fraction);
        const Vec3 front = normal_of(t);
        const double height = dot(middle_ - corner[0], front);
        const Vec3 n = height >= 0 ? front : -front;
        const double apart = absolute(height) - extent_along(n);
        const double by_plane = enters_along(apart, n);
        if (by_plane >= last) return;
        if (apart > 2 * gap_ && lands_inside(t, corner, n, apart, last)) return;
        const double by_box = enters_box(corner);
        if (by_box >= last) return;
        candidates_.push_back({maximum(maximum(by_box, by_plane), from_), t.index});
    }
    // Extent from the centre against the unit vector n.
    double extent_along(Vec3 n) const {
        const double along = absolute(dot(n, shape_.axes.y));
        if (shape_.core == Core::cylinder)
            return shape_.size.x * square_root(maximum(1 - along * along, 0)) +
                   shape_.size.y * along;
        if (shape_.core == Core::segment) return shape_.size.y * along + shape_.radius;
        if (shape_.core == Core::point) return shape_.radius;
        return dot(middle_ - support(shape_, -n), n) + shape_.radius;
    }
    double enters_box(const Vec3 corner[3]) const {
        const Vec3 low = min(corner[0], min(corner[1], corner[2])),
                   high = max(corner[0], max(corner[1], corner[2]));
        double enters = 0;
        for (int k = 0; k < 3; k++) {
            // The box of the shape is two gaps larger than the shape.
            const double apart = maximum(box_.low[k] - high[k], low[k] - box_.high[k]);
            if (apart <= 0) continue;
            const double speed = box_.low[k] > high[k] ? -motion_[k] : motion_[k];
            if (speed <= 0) return beyond_reach;
            enters = maximum(enters, apart / speed);
        }
        return enters;
    }
    // Returns whether the point that is deepest along the triangle's normal lands inside the
    // triangle. Then nothing touches the triangle earlier.
    bool lands_inside(const SurfaceTriangle& t, const Vec3 corner[3], Vec3 n, double apart,
                      double last) {
        const double fraction = (apart - gap_) / -dot(motion_, n);
        ASSERT(apart > gap_ && dot(motion_, n) < 0);
        const Vec3 there = support(shape_, -n) - n * shape_.radius + motion_ * fraction;
        const Vec3 front = cross(corner[1] - corner[0], corner[2] - corner[0]);
        for (int k = 0; k < 3; k++)
            if (dot(cross(front, corner[(k + 1) % 3] - corner[k]), there - corner[k]) < 0)
                return false;
        if (fraction >= last) return true;
        best_ = {fraction, true, there - n * gap_, n};
        touched_ = t.index;
        cup_.put(shape_, middle_, motion_, best_.point, n, 4 * gap_);
        return true;
    }

    void touch(const SurfaceTriangle& t, double at, double last) {
        const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                t.corner[2] - origin_};
        if (cup_.hides(corner)) return;
        Vec3 n;
        // At the end of the interval most triangles are still separated.
        for (const double then : {last, at}) {
            const Vec3 nearest = nearest_on_triangle(corner, middle_ + motion_ * then);
            const Vec3 core = nearest_of_core(nearest, then);
            const Vec3 to =
                core + motion_ * then - nearest_on_triangle(corner, core + motion_ * then);
            const double sweep_distance = length(to);
            if (sweep_distance <= 0) break;
            n = to * (1 / sweep_distance);
            const double apart =
                sweep_distance - dot(motion_, n) * then - dot(core - middle_, n) - extent_along(n);
            const double enters = enters_along(apart, n);
            if (enters >= last) return;
            at = maximum(at, enters);
        }
        if (shape_.core == Core::cylinder &&
            passes_cylinder(shape_, middle_ + motion_ * last, motion_, corner, 4 * gap_))
            return;
        advance(t, corner, n, at, last);
    }
    // The point on a long shape's axis that is approximately nearest to a point at that fraction,
    // expressed at the shape's start pose. For other shapes, their centre.
    Vec3 nearest_of_core(Vec3 point, double at) const {
        if (shape_.core != Core::cylinder && shape_.core != Core::segment) return middle_;
        const double along = dot(point - middle_ - motion_ * at, shape_.axes.y);
        return middle_ + shape_.axes.y * clamp(along, -shape_.size.y, shape_.size.y);
    }

    void advance(const SurfaceTriangle& t, const Vec3 corner[3], Vec3 hint, double at,
                 double last) {
        constexpr int rounds_max = 100;
        const Convex triangle = triangle_convex(corner, {}, {});
        for (int round = 0; round < rounds_max; round++) {
            Convex there = shape_;
            there.position += motion_ * at;
            const GjkResult g = gjk(triangle, there, hint,
                                    {.beyond = shape_.radius + 2 * gap_,
                                     .loose = tuning::loose_gap,
                                     .radii = shape_.radius,
                                     .motion = motion_ * (last - at)});
            const double apart = g.distance - shape_.radius;
            if (apart <= 2 * gap_) break;
            hint = g.normal;
            const double speed = -dot(motion_, g.normal);
            if (speed <= 0) return;
            const double next = at + (apart - gap_) / speed;
            if (next >= last) return;
            // The step is shorter than rounding resolves.
            if (next <= at) break;
            at = next;
        }
        best_ = {at, false, {}, {}};
        ASSERT(!(at < 0) && !(at > 1));
        touched_ = t.index;
        hint_ = hint;
    }

    // The normal at a touched edge or corner, or at a face that the shape did not land on. A shape
    // that overlaps at the start has no normal.
    void find_normal() {
        const SurfaceTriangle t = triangle_of(*surface_.geometry, touched_);
        const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                t.corner[2] - origin_};
        Convex there = shape_;
        there.position += motion_ * best_.fraction;
        const GjkResult g = gjk(triangle_convex(corner, {}, {}), there, hint_);
        if (g.distance <= shape_.radius) return;
        best_.settled = true;
        best_.point = g.on_a;
        best_.normal = acting_normal(*surface_.geometry, t, g.on_a + origin_, g.normal);
    }

    const TransformedShape& surface_;
    Vec3 origin_, motion_;
    TransformedShape local_;
    Convex shape_;
    Aabb box_;
    Vec3 middle_;
    double gap_, from_ = 0;
    SweepLanes lanes_;
    SweepCup cup_;  // below the face that the shape landed on
    SurfaceTouch best_{beyond_reach, false, {}, {}};
    std::uint32_t touched_ = 0;
    Vec3 hint_;
    std::vector<Candidate> candidates_;
};

}  // namespace

std::optional<SurfaceTouch> sweep_to_surface(const TransformedShape& surface,
                                             const TransformedShape& convex, Vec3 motion,
                                             double gap) {
    return SurfaceSweep(surface, convex, motion, gap).first();
}

}  // namespace jostle::physics
