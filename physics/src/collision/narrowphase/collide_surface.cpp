// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_surface.h"

#include <algorithm>
#include <optional>
#include <span>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/collision/narrowphase/face_clip.h"
#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/collision/narrowphase/sat.h"
#include "physics/src/collision/narrowphase/seams.h"
#include "physics/src/collision/narrowphase/shape_motion.h"
#include "physics/src/collision/narrowphase/surface_patches.h"
#include "physics/src/collision/narrowphase/triangle.h"
#include "physics/src/collision/narrowphase/triangle_edges.h"
#include "physics/src/collision/narrowphase/triangle_lanes.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/hull_lanes.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// A triangle seen from the side of the shape.
struct TriangleSide {
    const SurfaceTriangle& triangle;
    Vec3 corner[3];  // relative to the shape's position
    double side;     // 1: from the front, -1: from the back
    Vec3 face;       // unit normal on that side
    // In the plane, perpendicular to edge k, with its length.
    Vec3 outward[3];
    SurfaceFolds folds;
    double ridge[3];  // see ridge_of()
};

// A triangle that is closer to the shape than its contact points show: its seam does not allow the
// contact, and its face is further away. Normally a neighbouring triangle pushes instead.
struct HeldTriangle {
    Vec3 corner[3];  // relative to the shape's position
    Witness witness;
    Vec3 nearest;  // on the triangle; the witness of flat features need not lie on
                   // both
    std::uint32_t triangle = 0;
    bool through = false;  // the shortest exit is to the other side: used only if
                           // no other triangle pushes
    bool covered = false;
};

class SurfacePair {
public:
    SurfacePair(const TransformedShape& surface, const TransformedShape& convex, double margin,
                const SurfaceMotion* motion = nullptr)
        : surface_(surface), convex_(convex), margin_(margin) {
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
        clip_.emplace(shape_, margin);
        ASSERT(!(margin_ < 0) && !(shape_.radius < 0));
        size_ = size_of(shape_);
        patches_ = SurfacePatches(size_);
        if (const auto* mesh = std::get_if<Mesh>(surface.geometry))
            crack_ = minimum(mesh->data->weld_gap, tuning::even_ground * size_);
        edge_slack_ += crack_ / (shape_.radius > 0 ? shape_.radius : size_);
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

    void add_neighbours(const std::vector<TransformedShape>& neighbours) {
        for (const TransformedShape& neighbour : neighbours)
            if (neighbour.geometry != surface_.geometry || neighbour.position != surface_.position)
                add_neighbour(neighbour);
    }

    void add_neighbour(const TransformedShape& neighbour) {
        if (!seams_) seams_.emplace(convex_, surface_.axes);
        seams_->add(neighbour);
    }

    // Returns whether a neighbour covers a contact.
    bool collide(std::vector<Manifold>& out) {
        TriangleFilter filter(shape_, shape_.radius + margin_);
        if (motion_) filter.limit(motion_->limit(), shape_);
        const auto add_near = [&](const SurfaceTriangle& t) { add(t); };
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& t) {
            filter.put(t, origin_);
            if (filter.full()) filter.flush(add_near);
        });
        filter.flush(add_near);
        add_uncovered_triangles();
        patches_.write(surface_, origin_, out);
        return covered_;
    }

private:
    // Fast rejection: returns whether the shape is beyond the plane of the triangle, or is
    // separated along the direction from the closest point of the triangle to the shape's centre.
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

    void add(const SurfaceTriangle& t) {
        const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                t.corner[2] - origin_};
        if (shape_.core == Core::point && add_below_point(t, corner)) return;
        const Vec3 front = normal_of(t);
        const double height = dot(middle_ - corner[0], front);
        const Vec3 face = height < 0 ? -front : front;
        const Vec3 low = support(shape_, -face);
        const double gap = dot(low - corner[0], face);
        if (gap > shape_.radius + margin_ || exceeds_reach(gap, face)) return;
        if (motion_ && exceeds_reach_of_middle(corner)) return;
        TriangleSide side{t,
                          {corner[0], corner[1], corner[2]},
                          height < 0 ? -1.0 : 1.0,
                          face,
                          {},
                          folds_of(*surface_.geometry, t, front),
                          {}};
        for (int k = 0; k < 3; k++) {
            side.outward[k] = cross(corner[(k + 1) % 3] - corner[k], front);
            side.ridge[k] = ridge_of(side.folds, k, side.side);
        }
        if (add_over_face(side, low, gap, absolute(height))) return;
        if (belongs_to_neighbours(side, low, gap)) {
            add_face_points(side, false);
            return;
        }
        add_by_witness(t, corner, side, low);
    }

    // Returns whether the motion of the shape keeps it out of reach of a triangle in the direction
    // from the closest point to its centre.
    bool exceeds_reach_of_middle(const Vec3 corner[3]) const {
        const Vec3 to = middle_ - nearest_on_triangle(corner, middle_);
        const double distance = length(to);
        if (distance <= 0) return false;
        const Vec3 n = to * (1 / distance);
        return exceeds_reach(dot(support(shape_, -n) - middle_, n) + distance, n);
    }

    // A ridge that turns by less than this is a gentle one: 20 degrees.
    static constexpr double gentle_ridge = 0.1763;

    // A shape that lies above a triangle, or overlaps it by little, where the face normal is the
    // only one that the triangle allows. `low` is the point of its core nearest to the plane, `gap`
    // its distance, `height` that of the shape's centre. Returns false if the normal is not
    // evident.
    bool add_over_face(const TriangleSide& t, Vec3 low, double gap, double height) {
        const bool polyhedron = is_polyhedron(shape_);
        double inset = 0;
        if (gap <= 0) {
            if (!polyhedron || gap < -0.05 * size_ || height < -2 * gap) return false;
            inset = -4 * gap;
        }
        bool inside = true, beyond_ridge = false;
        for (int k = 0; k < 3; k++) {
            const double beyond = dot(low - t.corner[k], t.outward[k]);
            if (beyond <= 0 &&
                (inset == 0 || beyond * beyond >= inset * inset * length_squared(t.outward[k])))
                continue;
            inside = false;
            beyond_ridge = beyond_ridge || t.ridge[k] >= flat_ridge;
        }
        if (inside) {
            add_face_points(t, true, low, gap);
            return true;
        }
        if (beyond_ridge || gap < -slack() || seams_) return false;
        add_face_points(t, false);
        return true;
    }

    // Returns whether no normal that the triangle allows is the direction of the shortest distance.
    // The allowed ones form a cone: a neighbour across a gentle ridge allows those that are nearer
    // to its normal. A lower bound s of the distance is the separation along any direction. For a
    // point v of the shape, a point t of the triangle and a unit vector q, the separation along a
    // unit vector d is at most d . (v - t). If d . (v - t - s q) < 0 for the rays of the cone, it
    // is less than s for all d in the cone.
    bool belongs_to_neighbours(const TriangleSide& t, Vec3 low, double gap) const {
        if (seams_) return false;
        Vec3 limit[3];
        double furthest = 0;
        int edge = -1;  // beyond which the nearest point is furthest
        for (int k = 0; k < 3; k++) {
            if (!(absolute(t.ridge[k]) <= gentle_ridge)) return false;
            const double width = length(t.outward[k]);
            const double beyond = dot(low - t.corner[k], t.outward[k]);
            if (beyond > furthest * width) furthest = beyond / width, edge = k;
            limit[k] = t.outward[k];
            if (t.ridge[k] > 0) limit[k] -= t.face * (width * t.ridge[k]);
        }
        Vec3 ray[3];
        for (int k = 0; k < 3; k++) ray[k] = cross(limit[k], limit[(k + 1) % 3]) * t.side;
        const auto is_below = [&](Vec3 off) {
            return dot(ray[0], off) < 0 && dot(ray[1], off) < 0 && dot(ray[2], off) < 0;
        };
        // Without a lower bound of the distance, the shape may overlap the triangle next to its
        // deepest point. Then the points over the face describe the contact of a polyhedron.
        if (edge < 0) return false;
        if (gap < 0 && is_polyhedron(shape_) && is_below(low - nearest_on_triangle(t.corner, low)))
            return true;
        if (t.ridge[edge] < flat_ridge) return false;
        // The separation along the normal of the neighbour.
        const Vec3 half =
            normalized(t.face + t.outward[edge] * (t.ridge[edge] / length(t.outward[edge])));
        const Vec3 n = half * (2 * dot(half, t.face)) - t.face;
        const Vec3 lowest = support(shape_, -n);
        const double distance = dot(lowest - t.corner[edge], n);
        return distance > 0 &&
               is_below(lowest - nearest_on_triangle(t.corner, lowest) - half * distance);
    }

    // Adds the points of the shape over the face. If the shape's nearest point is among them, it is
    // `low`, at the distance `gap` of its core.
    void add_face_points(const TriangleSide& t, bool over_low, Vec3 low = {}, double gap = 0) {
        patches_.begin();
        patches_.put(clip_->over(t.corner, t.face, t.outward));
        if (over_low) {
            // Round features may lack the nearest point.
            const double lost = 5e-5 * minimum(size_, length(t.corner[1] - t.corner[0]));
            const double nearest = gap - shape_.radius;
            if (patches_.smallest_gap() > nearest + lost * (1 + 1e-6) && nearest <= margin_)
                patches_.put(GapPoint{low - t.face * (0.5 * (gap + shape_.radius)), nearest});
        } else {
            drop_outside(t.face);
        }
        patches_.close(t.face, t.triangle.index, t.corner);
    }

    void add_by_witness(const SurfaceTriangle& t, const Vec3 corner[3], const TriangleSide& seen,
                        Vec3 low) {
        const double reach = shape_.radius + margin_;
        const Convex triangle = triangle_convex(corner, {}, {});
        const Witness w = witness_of(triangle, seen, low, reach);
        ASSERT(is_unit(w.normal, 1e-5));
        if (w.distance > reach || exceeds_reach(w.distance, w.normal)) return;
        const double side = is_behind(t, corner, w) ? -1 : 1;
        const Vec3 face = seen.face * (seen.side * side);
        Vec3 normal = w.normal;
        patches_.begin();
        const bool allowed =
            may_act(t, seen.folds, face, side, w.on_a + origin_, w.normal, edge_slack_);
        const std::optional<Vec3> cover =
            covering_normal(t, seen.folds, triangle, w.on_a, w.normal, gap_of(w), face);
        if (cover) {
            covered_ = true;
            if (dot(*cover, face) < tuning::same_piece) return;
            normal = face;
            patches_.put(clip_->over(corner, face, seen.outward));
        } else if (allowed) {
            patches_.put(contact_points(triangle, shape_, w, margin_));
        } else {
            normal = face;
            patches_.put(clip_->over(corner, face, seen.outward));
            drop_outside(face);
            const double nearest = patches_.smallest_gap();
            if (nearest > gap_of(w) + slack() && w.distance > 0) {
                // Cores are apart: the point acts if no other triangle is nearer, as on a peak.
                if (is_nearest(t, nearest_on_triangle(corner, w.on_a), w.normal)) {
                    normal = w.normal;
                    patches_.begin();
                    patches_.put(contact_points(triangle, shape_, w, margin_));
                }
            } else if (nearest > gap_of(w) + slack()) {
                held_.push_back({{corner[0], corner[1], corner[2]},
                                 w,
                                 nearest_on_triangle(corner, w.on_a),
                                 t.index,
                                 dot(w.normal, face) <= 0});
            }
        }
        patches_.close(normal, t.index, corner);
    }

    // Closest points first: most triangles are apart. The axes matter only for the overlapping
    // ones.
    Witness witness_of(const Convex& triangle, const TriangleSide& seen, Vec3 low,
                       double reach) const {
        if (!is_polyhedron(shape_)) {
            PairCache cache{.axis = 0, .direction = seen.face};
            return find_witness(triangle, shape_, reach, cache);
        }
        const double tie = 2e-5 * minimum(size_of(triangle), size_);
        const Vec3 at = nearest_on_triangle(triangle.corner, low), to = low - at;
        const double upper = length(to);
        if (upper > tie) {
            const Vec3 n = to * (1 / upper);
            const double lower =
                dot(support(shape_, -n), n) -
                maximum(dot(triangle.corner[0], n),
                        maximum(dot(triangle.corner[1], n), dot(triangle.corner[2], n)));
            if (lower > reach) return {n, lower, at, low};
            if (lower >= upper * (1 - 1e-9)) return {n, upper, at, low};
        }
        const GjkResult g = gjk(triangle, shape_, to, {.beyond = reach});
        if (g.distance > reach) return {g.normal, g.distance, g.on_a, g.on_b};
        if (g.distance > 0) {
            const Separation flat = separate_by_face(triangle, shape_, g.normal);
            if (g.distance > flat.distance + tie) return {g.normal, g.distance, g.on_a, g.on_b};
            return {flat.normal, flat.distance, g.on_a, g.on_b};
        }
        const Separation s = separate(triangle, shape_, axis_of_face(seen.side < 0 ? 1 : 0), reach);
        return {s.normal, s.distance, s.on_a, s.on_b};
    }

    // The normal of a neighbour that covers the contact with a triangle at a point of its edge: of
    // another shape, or of another triangle if the edge has no neighbour that could tell.
    std::optional<Vec3> covering_normal(const SurfaceTriangle& t, const SurfaceFolds& folds,
                                        const Convex& triangle, Vec3 at, Vec3 n, double gap,
                                        Vec3 face) {
        if (dot(n, face) > facing_normal) return std::nullopt;
        if (seams_)
            if (const auto cover = seams_->covering_normal(triangle, n, gap)) return cover;
        if (!is_on_border(t, folds, at + origin_)) return std::nullopt;
        if (seam_tests_ > tuning::max_seam_tests) return std::nullopt;
        SeamContact contact(shape_, triangle, n, gap);
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& other) {
            if (other.index == t.index || seam_tests_++ > tuning::max_seam_tests) return;
            const Vec3 corner[3] = {other.corner[0] - origin_, other.corner[1] - origin_,
                                    other.corner[2] - origin_};
            contact.test(triangle_convex(corner, {}, {}));
        });
        return contact.covering_normal();
    }

    // A ball touches a triangle where its centre is nearest, if no other triangle is nearer there.
    // Returns false if the centre lies on the triangle.
    bool add_below_point(const SurfaceTriangle& t, const Vec3 corner[3]) {
        const Vec3 at = nearest_on_triangle(corner, middle_), to = middle_ - at;
        const double reach = shape_.radius + margin_, square = length_squared(to);
        if (square > reach * reach) return true;
        const double distance = square_root(square);
        if (distance <= 1e-9 * size_) return false;
        Vec3 n = to * (1 / distance);
        if (exceeds_reach(distance, n)) return true;
        const Vec3 front = normal_of(t), face = dot(n, front) < 0 ? -front : front;
        if (dot(n, face) > facing_normal) {
            n = face;
        } else {
            if (!is_nearest(t, at, n)) return true;
            if (covering_normal(t, folds_of(*surface_.geometry, t, front),
                                triangle_convex(corner, {}, {}), at, n, distance - shape_.radius,
                                face)) {
                covered_ = true;
                return true;
            }
        }
        patches_.begin();
        patches_.put(GapPoint{(at + middle_ - n * shape_.radius) * 0.5, distance - shape_.radius});
        patches_.close(n, t.index, corner);
        return true;
    }

    // Returns whether the motion of the shape keeps its core, which is `distance` away along n, out
    // of reach.
    bool exceeds_reach(double distance, Vec3 n) const {
        return motion_ && distance > shape_.radius &&
               motion_->exceeds_reach(distance - shape_.radius, n, shape_);
    }

    // Returns whether the shape is behind the triangle. For a separated shape the direction of the
    // shortest distance decides; for an overlapping shape the position of its centre decides. A
    // shape above another slope of a ridge is in front of this triangle too, although it is below
    // its plane. Near an edge, triangles that face the same way as the triangle nearest to the
    // centre are touched from the front. Otherwise the planes of both slopes decide.
    bool is_behind(const SurfaceTriangle& t, const Vec3 corner[3], const Witness& w) {
        const Vec3 front = normal_of(t);
        const double up = dot(front, w.normal);
        if (gap_of(w) > -tuning::even_ground * size_ && absolute(up) > 0.5) return up < 0;
        const Vec3 nearest = nearest_on_triangle(corner, middle_);
        const bool below = dot(middle_ - corner[0], front) < 0;
        bool behind = below, near_edge = false;
        for (int k = 0; k < 3; k++) {
            const Vec3 along = corner[(k + 1) % 3] - corner[k];
            const Vec3 beyond = cross(along, front);
            const double reach = dot(corner[(k + 2) % 3] - corner[k], beyond);
            if (dot(nearest - corner[k], beyond) < 1e-6 * reach) continue;
            near_edge = true;
            const SurfaceEdge edge = edge_of(*surface_.geometry, t, k);
            if (edge.border) continue;
            const bool behind_that = dot(middle_ - corner[k], edge.normal) < 0;
            behind = edge.fold < 0 ? behind && behind_that : behind || behind_that;
        }
        if (near_edge && dot(front, exit_direction()) > 0) return false;
        return behind;
    }

    // The normal, on the shape's side, of the triangle nearest to the shape's centre.
    Vec3 exit_direction() {
        if (exit_direction_ != Vec3{}) return exit_direction_;
        double least = 1e300, upright = 0;
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& t) {
            const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                    t.corner[2] - origin_};
            const Vec3 to = middle_ - nearest_on_triangle(corner, middle_);
            const Vec3 front = normal_of(t);
            const double distance = length(to), up = dot(to, front);
            // Among triangles that share the nearest point, choose the one that faces it most.
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

    // Drops points of a shape that is below the face without reaching up to it, for example a plank
    // under the edge of a table. Such a shape does not penetrate the face.
    void drop_outside(Vec3 face) {
        patches_.drop_if([&](const GapPoint& p) {
            // Contact points are midway between the surfaces. The point on the face is half the gap
            // away.
            const Convex above{
                .core = Core::point, .position = p.point - face * (0.5 * p.gap), .size = {}};
            return p.gap < -0.02 * size_ &&
                   gjk(above, shape_, face).distance > shape_.radius + slack();
        });
    }

    // Marks held triangles that a neighbour covers: the neighbour contains their nearest point and
    // pushes at least as far out.
    void cover(const Vec3 corner[3], double gap) {
        for (HeldTriangle& w : held_)
            if (!w.covered && gap <= gap_of(w.witness) + slack() && contains(corner, w.nearest)) {
                w.covered = true;
                cover(w.corner, gap);
            }
    }
    bool contains(const Vec3 corner[3], Vec3 p) const {
        const Vec3 n = normalized(cross(corner[1] - corner[0], corner[2] - corner[0]));
        const double near = 1e-5 * (size_ + length(corner[1] - corner[0])) + crack_;
        if (absolute(dot(p - corner[0], n)) > near) return false;
        for (int k = 0; k < 3; k++) {
            const Vec3 outward = normalized(cross(corner[(k + 1) % 3] - corner[k], n));
            if (dot(p - corner[k], outward) > near) return false;
        }
        return true;
    }

    // Returns whether a triangle with a corner at or near a point is nearer than that point to a
    // separated shape in the direction n.
    static bool rises(const Vec3 corner[3], Vec3 at, Vec3 n, double slack) {
        for (int k = 0; k < 3; k++)
            if (dot(n, corner[k] - at) > tuning::edge_slack * length(corner[k] - at) + slack)
                return true;
        return false;
    }

    // Returns whether a point on an edge of a triangle is nearer than all other points around it to
    // a separated shape in the direction n.
    bool is_nearest(const SurfaceTriangle& t, Vec3 at, Vec3 n) const {
        int edges = 0;
        const bool below = for_each_edge_at(t, normal_of(t), at + origin_, [&](int k, Vec3) {
            edges++;
            const std::uint32_t other = neighbour_of(*surface_.geometry, t.index, k);
            if (other == no_triangle) return true;
            // Its corner opposite the edge decides. The other two may be up to the welding distance
            // away from those of this triangle.
            const SurfaceTriangle next = triangle_of(*surface_.geometry, other);
            const Vec3 to =
                opposite_corner(next, t.corner[k], t.corner[(k + 1) % 3]) - origin_ - at;
            return dot(n, to) <= edge_slack_ * length(to);
        });
        return below && (edges < 2 || is_nearest_of_all(at, n));
    }
    bool is_nearest_of_all(Vec3 at, Vec3 n) const {
        bool nearest = true;
        const double near = maximum(crack_, 1e-9 * size_);
        const Vec3 point = at + origin_;
        for_each_triangle(*surface_.geometry, grow({point, point}, near),
                          [&](const SurfaceTriangle& t) {
                              const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                                      t.corner[2] - origin_};
                              if (length(nearest_on_triangle(corner, at) - at) > near) return;
                              if (rises(corner, at, n, near)) nearest = false;
                          });
        return nearest;
    }

    // If no neighbour pushes, for example at the sharp folds of a crumpled surface, a seam acts
    // like any other edge. The nearest held triangle is added first; the triangles that it covers
    // are skipped.
    void add_uncovered_triangles() {
        if (held_.empty()) return;
        for (const SurfacePatch& patch : patches_.all()) cover(patch.corner, patch.deepest);
        for (;;) {
            HeldTriangle* next = nullptr;
            for (HeldTriangle& w : held_)
                if (!w.covered && !(w.through && patches_.any_overlaps()) &&
                    (next == nullptr || w.witness.distance < next->witness.distance))
                    next = &w;
            if (next == nullptr) return;
            next->covered = true;
            patches_.begin();
            patches_.put(contact_points(triangle_convex(next->corner, {}, {}), shape_,
                                        next->witness, margin_));
            if (patches_.close(next->witness.normal, next->triangle, next->corner))
                cover(next->corner, patches_.all().back().deepest);
        }
    }

    const TransformedShape &surface_, &convex_;
    double margin_;
    Vec3 origin_;
    Convex shape_;
    Aabb box_;
    double size_ = 0;
    double crack_ = 0;  // m: width of a gap between two triangles that count as neighbours
    double edge_slack_ = tuning::edge_slack;  // rad; a round shape leans over a crack
    Vec3 middle_;
    std::optional<Seams> seams_;  // of the neighbours, if there are any
    bool covered_ = false;        // a neighbour covers a contact
    int seam_tests_ = 0;          // of triangles that may cover a contact at an open edge
    Vec3 exit_direction_;         // zero until computed
    std::optional<ShapeMotion> motion_;
    std::optional<FaceClip> clip_;
    SurfacePatches patches_{0};
    std::vector<HeldTriangle> held_;
};

}  // namespace

bool collide_surface(const TransformedShape& surface, const TransformedShape& convex, double margin,
                     const SurfaceMotion* motion, const std::vector<TransformedShape>& neighbours,
                     std::vector<Manifold>& out) {
    SurfacePair pair(surface, convex, margin, motion);
    pair.add_neighbours(neighbours);
    return pair.collide(out);
}

Vec3 acting_normal(const Geometry& surface, const SurfaceTriangle& triangle, Vec3 at, Vec3 n) {
    const Vec3 front = normal_of(triangle);
    const double up = dot(n, front), side = up < 0 ? -1 : 1;
    // A contact along the face is at a border or a ridge, from either side.
    if (absolute(up) < 0.5) return n;
    const SurfaceFolds folds = folds_of(surface, triangle, front);
    return may_act(triangle, folds, front * side, side, at, n, tuning::edge_slack) ? n
                                                                                   : front * side;
}

bool overlaps_surface(const TransformedShape& surface, const TransformedShape& convex) {
    return SurfacePair(surface, convex, 0).overlaps();
}

}  // namespace jostle::physics
