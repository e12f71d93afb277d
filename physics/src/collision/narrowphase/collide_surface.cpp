// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_surface.h"

#include <algorithm>
#include <optional>

#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/collision/narrowphase/nearest_on_triangle.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/bounds.h"
#include "physics/src/geometry/hull_lanes.h"

namespace jostle::physics {
namespace {

// Points of one triangle.
struct Patch {
    Vec3 normal;  // from the triangle to the shape
    double deepest = 1e300;
    std::uint32_t triangle = 0;
    ContactPoints points;
    Vec3 corner[3];  // from the shape's position
};

// A triangle that comes nearer than what may push there: a seam forbids its own contact, and its
// face does not reach as far. Normally its neighbour pushes instead.
struct HeldTriangle {
    Vec3 corner[3];  // from the shape's position
    Witness witness;
    Vec3 nearest;  // on the triangle; the witness of flat features need not lie on both
    std::uint32_t triangle = 0;
    bool through = false;  // the shortest way out is to the other side: only if nothing else pushes
    bool covered = false;
};

// Whether an edge lets a contact push along n. `outward` lies in the triangle's plane, `face` is
// its normal on the shape's side.
bool edge_allows(const SurfaceEdge& edge, Vec3 face, double side, Vec3 outward, Vec3 n) {
    const double up = dot(n, face), out = dot(n, outward);
    if (out < -tuning::edge_slack) return false;  // leans inward: the face itself pushes
    if (edge.border) return up > -tuning::edge_slack;
    if (edge.fold * side > -1e-4 * edge.reach) return out < tuning::edge_slack;  // flat or hollow
    // A ridge: anything between the two faces' normals.
    const Vec3 other = edge.normal * side;
    const double other_up = dot(other, face), other_out = dot(other, outward);
    return out * other_up - up * other_out <
           tuning::edge_slack;  // sine of the angle beyond the other normal
}

// Whether the normal that a pair found may act, given where on the triangle it acts.
bool may_act(const Geometry& surface, const SurfaceTriangle& t, Vec3 face, double side, Vec3 at,
             Vec3 n) {
    if (dot(n, face) > 0.99995) return true;
    bool on_edge = false;
    for (int k = 0; k < 3; k++) {
        const Vec3 from = t.corner[k], along = t.corner[(k + 1) % 3] - from;
        const Vec3 outward = normalized(cross(along, face * side));
        const double height = length(cross(along, t.corner[(k + 2) % 3] - from)) / length(along);
        if (dot(at - from, outward) < -1e-4 * height) continue;
        on_edge = true;
        if (!edge_allows(edge_of(surface, t, k), face, side, outward, n)) return false;
    }
    return on_edge;
}

// What a shape may come near to on its way, in the surface's frame with the shape's position as the
// origin.
class ShapeMotion {
public:
    ShapeMotion(const SurfaceMotion& motion, const TransformedShape& surface,
                const TransformedShape& convex, const Convex& shape)
        : ends_{transposed_times(surface.axes, motion.to_start),
                transposed_times(surface.axes, motion.to_end)},
          turn_(transposed_times(surface.axes, motion.turn)),
          center_(transposed_times(surface.axes, motion.center - convex.position)),
          near_(motion.near) {
        furthest_ = shape.core == Core::hull
                        ? length(middle_of(shape) - center_) + shape.hull->lanes->outer_radius
                        : length(center_) + size_of(shape);
    }

    // All of it, within its box at the look.
    Aabb reach(const Aabb& now) const {
        const Aabb ball{center_ - Vec3{furthest_, furthest_, furthest_},
                        center_ + Vec3{furthest_, furthest_, furthest_}};
        const Aabb turned = grow(now, length(turn_) * furthest_);
        const Vec3 low = max(turned.low, ball.low), high = min(turned.high, ball.high);
        const Vec3 back = min(Vec3{}, min(ends_[0], ends_[1])),
                   on = max(Vec3{}, max(ends_[0], ends_[1]));
        return grow({low + back, high + on}, near_);
    }
    // Whether it stays further off than what is near from something that is `distance` away
    // against n, unit.
    bool exceeds_reach(double distance, Vec3 n, const Convex& shape) const {
        const double left =
            distance + minimum(0, minimum(dot(ends_[0], n), dot(ends_[1], n))) - near_;
        if (left <= 0) return false;
        // Turning lets no point come nearer than those that are furthest from the centre.
        const double extent = dot(support(shape, -n) - center_, -n) + shape.radius;
        return left > minimum(length(cross(turn_, n)) * furthest_, furthest_ - extent);
    }

private:
    Vec3 ends_[2], turn_, center_;
    double near_, furthest_;  // m; the second: of the shape's points from the centre
};

class SurfacePair {
public:
    SurfacePair(const TransformedShape& surface, const TransformedShape& convex, double margin,
                const SurfaceMotion* motion = nullptr)
        : surface_(surface), margin_(margin) {
        // In the surface's frame, with the shape's position as the origin.
        origin_ = transposed_times(surface.axes, convex.position - surface.position);
        const Mat3 axes = transpose(surface.axes) * convex.axes;
        const TransformedShape local{convex.geometry, {}, axes};
        shape_ = convex_of(local, {});
        const Aabb now = bounds_of(local);
        box_ = grow(now, margin);
        if (motion != nullptr) {
            motion_.emplace(*motion, surface, convex, shape_);
            const Aabb reach = motion_->reach(now);
            box_ = {max(box_.low, reach.low), min(box_.high, reach.high)};
        }
        box_ = {box_.low + origin_, box_.high + origin_};
        size_ = size_of(shape_);
        middle_ = middle_of(shape_);
    }

    bool overlaps() const {
        bool any = false;
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& t) {
            if (any) return;
            const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                    t.corner[2] - origin_};
            if (is_apart(t, corner)) return;
            any = gjk(triangle_convex(corner, {}, {}), shape_, {}).distance <= shape_.radius;
        });
        return any;
    }

    void collide(std::vector<Manifold>& out) {
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& t) { add(t); });
        add_uncovered_triangles();
        // Deepest first: the normal of a piece is that of its deepest triangle.
        std::sort(patches_.begin(), patches_.end(), [](const Patch& x, const Patch& y) {
            return x.deepest < y.deepest || (x.deepest == y.deepest && x.triangle < y.triangle);
        });
        std::vector<bool> used(patches_.size(), false);
        for (std::size_t i = 0; i < patches_.size(); i++) {
            if (used[i]) continue;
            const Vec3 ground = on_ground(patches_[i], 0);
            ContactPoints sum = patches_[i].points;
            for (std::size_t j = i + 1; j < patches_.size(); j++) {
                if (used[j] || !continues(patches_[i].normal, ground, patches_[j])) continue;
                used[j] = true;
                for (int k = 0; k < patches_[j].points.count; k++)
                    merge(sum, patches_[j].points.point[k], patches_[j].points.gap[k]);
            }
            Manifold m = manifold_of(sum, patches_[i].normal, size_);
            m.normal = surface_.axes * m.normal;
            for (int k = 0; k < m.count; k++)
                m.point[k] = surface_.position + surface_.axes * (m.point[k] + origin_);
            out.push_back(m);
        }
    }

private:
    // Quick: whether the shape is beyond the plane of the triangle, or beside it along the way from
    // the point of it that is nearest to the middle.
    bool is_apart(const SurfaceTriangle& t, const Vec3 corner[3]) const {
        const Vec3 front = normal_of(t);
        const Vec3 up = dot(middle_ - corner[0], front) < 0 ? -front : front;
        if (dot(support(shape_, -up) - corner[0], up) > shape_.radius) return true;
        const Vec3 to = middle_ - nearest_on_triangle(corner, middle_);
        const double motion = length(to);
        if (motion <= 0) return false;
        const Vec3 n = to * (1 / motion);
        return dot(support(shape_, -n) - middle_, n) + motion > shape_.radius;
    }

    // Where a contact point is on its triangle.
    static Vec3 on_ground(const Patch& patch, int k) {
        return patch.points.point[k] - patch.normal * (0.5 * patch.points.gap[k]);
    }
    // Only what goes on as a plane makes one manifold: on a curved ground four points of many
    // cannot stand for the others, and which four are best changes with every step.
    bool continues(Vec3 normal, Vec3 ground, const Patch& next) const {
        if (dot(normal, next.normal) < tuning::same_piece) return false;
        for (int k = 0; k < next.points.count; k++)
            if (absolute(dot(on_ground(next, k) - ground, normal)) > tuning::even_ground * size_)
                return false;
        return true;
    }

    // Points that two triangles share count once.
    void merge(ContactPoints& sum, Vec3 point, double gap) const {
        const double near = 1e-4 * size_;
        for (int k = 0; k < sum.count; k++)
            if (length_squared(sum.point[k] - point) < near * near) {
                sum.gap[k] = minimum(sum.gap[k], gap);
                return;
            }
        if (sum.count == ContactPoints::capacity) {
            // Full: the points that do not matter go first.
            sum.count = reduce(sum);
        }
        sum.point[sum.count] = point;
        sum.gap[sum.count] = gap;
        sum.count++;
    }
    int reduce(ContactPoints& sum) const {
        Vec3 normal = cross(sum.point[1] - sum.point[0], sum.point[2] - sum.point[0]);
        const Manifold best = manifold_of(sum, normalized(normal), size_);
        for (int k = 0; k < best.count; k++) {
            sum.point[k] = best.point[k];
            sum.gap[k] = best.gap[k];
        }
        return best.count;
    }

    void add(const SurfaceTriangle& t) {
        const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                t.corner[2] - origin_};
        const Vec3 front = normal_of(t);
        // Quick: the shape does not reach the plane.
        const double reach = shape_.radius + margin_;
        const Vec3 low = support(shape_, -front), high = support(shape_, front);
        const double above = dot(low - corner[0], front), below = dot(corner[0] - high, front);
        if (above > reach || below > reach) return;
        if (exceeds_reach(above, front) || exceeds_reach(below, -front)) return;
        // ... or lies beside it: along the way from the point of it that is nearest to the middle.
        const Vec3 beside = nearest_on_triangle(corner, middle_);
        if (const double motion = length(middle_ - beside); motion > 0) {
            const Vec3 n = (middle_ - beside) * (1 / motion);
            const double apart = dot(support(shape_, -n) - beside, n);
            if (apart > reach || exceeds_reach(apart, n)) return;
        }
        const Convex triangle = triangle_convex(corner, {}, {});
        // Mostly the face decides: its front is the first, its back the second.
        PairCache cache{.axis = axis_of_face(dot(middle_ - corner[0], front) < 0 ? 1 : 0),
                        .direction = {}};
        const Witness w = find_witness(triangle, shape_, reach, cache);
        if (w.distance > reach || exceeds_reach(w.distance, w.normal)) return;
        const double side = is_behind(t, corner, w) ? -1 : 1;
        const Vec3 face = front * side;
        Patch patch{.normal = w.normal, .triangle = t.index, .points = {}};
        if (may_act(*surface_.geometry, t, face, side, w.on_a + origin_, w.normal)) {
            patch.points = contact_points(triangle, shape_, w, margin_);
        } else {
            patch.normal = face;
            patch.points = points_over_face(triangle, shape_, face, margin_);
            drop_outside(patch.points, face);
            double nearest = 1e300;
            for (int k = 0; k < patch.points.count; k++)
                nearest = minimum(nearest, patch.points.gap[k]);
            if (nearest > gap_of(w) + slack())
                held_.push_back({{corner[0], corner[1], corner[2]},
                                 w,
                                 nearest_on_triangle(corner, w.on_a),
                                 t.index,
                                 dot(w.normal, face) <= 0});
        }
        if (patch.points.count > 0) take(patch, corner);
    }

    // Whether the shape does not come near on its way to what its core is apart from along n.
    bool exceeds_reach(double distance, Vec3 n) const {
        return motion_ && distance > shape_.radius &&
               motion_->exceeds_reach(distance - shape_.radius, n, shape_);
    }

    // On which side of a triangle the shape is. Apart from it, where the shortest way between them
    // says; over it, where the middle of the shape is. What is over another slope of a ridge is
    // above this one too, though below its plane: there all that faces the way of the triangle
    // nearest to the middle is met from its front, and at sharper edges both slopes count.
    bool is_behind(const SurfaceTriangle& t, const Vec3 corner[3], const Witness& w) {
        const Vec3 front = normal_of(t);
        const double up = dot(front, w.normal);
        if (gap_of(w) > -tuning::even_ground * size_ && absolute(up) > 0.5) return up < 0;
        const Vec3 nearest = nearest_on_triangle(corner, middle_);
        const bool below = dot(middle_ - corner[0], front) < 0;
        bool behind = below, beside = false;
        for (int k = 0; k < 3; k++) {
            const Vec3 along = corner[(k + 1) % 3] - corner[k];
            const Vec3 beyond = cross(along, front);
            const double reach = dot(corner[(k + 2) % 3] - corner[k], beyond);
            if (dot(nearest - corner[k], beyond) < 1e-6 * reach) continue;
            beside = true;
            const SurfaceEdge edge = edge_of(*surface_.geometry, t, k);
            if (edge.border) continue;
            const bool behind_that = dot(middle_ - corner[k], edge.normal) < 0;
            behind = edge.fold < 0 ? behind && behind_that : behind || behind_that;
        }
        if (beside && dot(front, exit_direction()) > 0) return false;
        return behind;
    }

    // The normal, on the shape's side, of the triangle nearest to its middle.
    Vec3 exit_direction() {
        if (exit_direction_ != Vec3{}) return exit_direction_;
        double least = 1e300, upright = 0;
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& t) {
            const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                    t.corner[2] - origin_};
            const Vec3 to = middle_ - nearest_on_triangle(corner, middle_);
            const Vec3 front = normal_of(t);
            const double distance = length(to), up = dot(to, front);
            // Of those that share the nearest point the one that faces it most.
            const double near = 1e-6 * size_;
            if (distance > least + near || (distance > least - near && absolute(up) <= upright))
                return;
            least = minimum(least, distance);
            upright = absolute(up);
            exit_direction_ = up < 0 ? -front : front;
        });
        return exit_direction_;
    }

    double gap_of(const Witness& w) const { return w.distance - shape_.radius; }
    double slack() const { return tuning::even_ground * size_; }

    // A shape that is below the face without reaching up to it, as a plank under the edge of a
    // table, is not in it.
    void drop_outside(ContactPoints& points, Vec3 face) const {
        int retained = 0;
        for (int k = 0; k < points.count; k++) {
            // Half way between the surfaces; the face's is half the gap up.
            const Convex above{.core = Core::point,
                               .position = points.point[k] - face * (0.5 * points.gap[k]),
                               .size = {}};
            if (points.gap[k] < -0.02 * size_ &&
                gjk(above, shape_, face).distance > shape_.radius + slack())
                continue;
            points.point[retained] = points.point[k];
            points.gap[retained++] = points.gap[k];
        }
        points.count = retained;
    }

    void take(Patch& patch, const Vec3 corner[3]) {
        std::copy(corner, corner + 3, patch.corner);
        for (int k = 0; k < patch.points.count; k++)
            patch.deepest = minimum(patch.deepest, patch.points.gap[k]);
        patches_.push_back(patch);
    }

    // A neighbour pushes in its stead where it is nearest to the shape, and as far out.
    void cover(const Vec3 corner[3], double gap) {
        for (HeldTriangle& w : held_)
            if (!w.covered && gap <= gap_of(w.witness) + slack() && holds(corner, w.nearest)) {
                w.covered = true;
                cover(w.corner, gap);
            }
    }
    bool holds(const Vec3 corner[3], Vec3 p) const {
        const Vec3 n = normalized(cross(corner[1] - corner[0], corner[2] - corner[0]));
        const double near = 1e-5 * (size_ + length(corner[1] - corner[0]));
        if (absolute(dot(p - corner[0], n)) > near) return false;
        for (int k = 0; k < 3; k++) {
            const Vec3 outward = normalized(cross(corner[(k + 1) % 3] - corner[k], n));
            if (dot(p - corner[k], outward) > near) return false;
        }
        return true;
    }

    bool any_overlaps() const {
        return std::any_of(patches_.begin(), patches_.end(),
                           [](const Patch& p) { return p.deepest < 0; });
    }

    // Where no neighbour pushes, as at the sharp folds of a crumpled surface, a seam is an edge
    // like any other. The nearest first; those that it covers need nothing more.
    void add_uncovered_triangles() {
        for (std::size_t k = 0; k < patches_.size() && !held_.empty(); k++)
            cover(patches_[k].corner, patches_[k].deepest);
        for (;;) {
            HeldTriangle* next = nullptr;
            for (HeldTriangle& w : held_)
                if (!w.covered && !(w.through && any_overlaps()) &&
                    (next == nullptr || w.witness.distance < next->witness.distance))
                    next = &w;
            if (next == nullptr) return;
            next->covered = true;
            Patch patch{.normal = next->witness.normal, .triangle = next->triangle, .points = {}};
            patch.points = contact_points(triangle_convex(next->corner, {}, {}), shape_,
                                          next->witness, margin_);
            if (patch.points.count == 0) continue;
            take(patch, next->corner);
            cover(next->corner, patches_.back().deepest);
        }
    }

    const TransformedShape& surface_;
    double margin_;
    Vec3 origin_;
    Convex shape_;
    Aabb box_;
    double size_ = 0;
    Vec3 middle_;
    Vec3 exit_direction_;  // zero: not known yet
    std::optional<ShapeMotion> motion_;
    std::vector<Patch> patches_;
    std::vector<HeldTriangle> held_;
};

}  // namespace

void collide_surface(const TransformedShape& surface, const TransformedShape& convex, double margin,
                     const SurfaceMotion* motion, std::vector<Manifold>& out) {
    SurfacePair(surface, convex, margin, motion).collide(out);
}

Vec3 acting_normal(const Geometry& surface, const SurfaceTriangle& triangle, Vec3 at, Vec3 n) {
    const Vec3 front = normal_of(triangle);
    const double up = dot(n, front), side = up < 0 ? -1 : 1;
    // Along the face it is a border or a ridge, seen from either side.
    if (absolute(up) < 0.5) return n;
    return may_act(surface, triangle, front * side, side, at, n) ? n : front * side;
}

bool overlaps_surface(const TransformedShape& surface, const TransformedShape& convex) {
    return SurfacePair(surface, convex, 0).overlaps();
}

}  // namespace jostle::physics
