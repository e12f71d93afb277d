// SPDX-License-Identifier: MIT
#include "collision/narrowphase/collide_surface.h"

#include <algorithm>

#include "collision/narrowphase/collide_convex.h"
#include "collision/narrowphase/gjk.h"
#include "geometry/bounds.h"
#include "geometry/surface.h"

namespace jostle::physics {
namespace {

constexpr double same_piece = 0.9962;  // cosine of 5 degrees: normals of one manifold
constexpr std::size_t pieces_max = 8;  // manifolds of one pair

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
struct Waiting {
    Vec3 corner[3];  // from the shape's position
    Witness witness;
    Vec3 nearest;  // on the triangle; the witness of flat features need not lie on both
    std::uint32_t triangle = 0;
    bool covered = false;
};

// Whether an edge lets a contact push along n. `outward` lies in the triangle's plane, `face` is
// its normal on the shape's side.
bool edge_allows(const SurfaceEdge& edge, Vec3 face, double side, Vec3 outward, Vec3 n) {
    const double up = dot(n, face), out = dot(n, outward);
    constexpr double slack = 0.01;   // rad
    if (out < -slack) return false;  // leans inward: the face itself pushes
    if (edge.border) return up > -slack;
    if (edge.fold * side > -1e-4 * edge.reach) return out < slack;  // flat or hollow
    // A ridge: anything between the two faces' normals.
    const Vec3 other = edge.normal * side;
    const double other_up = dot(other, face), other_out = dot(other, outward);
    return out * other_up - up * other_out < slack;  // sine of the angle beyond the other normal
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

class SurfacePair {
public:
    SurfacePair(const Placed& surface, const Placed& convex, double margin)
        : surface_(surface), margin_(margin) {
        // In the surface's frame, with the shape's position as the origin.
        origin_ = transposed_times(surface.axes, convex.position - surface.position);
        const Mat3 axes = transpose(surface.axes) * convex.axes;
        const Placed local{convex.geometry, {}, axes};
        shape_ = convex_of(local, {});
        box_ = grow(bounds_of(local), margin);
        box_ = {box_.low + origin_, box_.high + origin_};
        size_ = size_of(shape_);
    }

    bool overlaps() const {
        bool any = false;
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& t) {
            if (any) return;
            const Vec3 corner[3] = {t.corner[0] - origin_, t.corner[1] - origin_,
                                    t.corner[2] - origin_};
            any = gjk(triangle_convex(corner, {}, {}), shape_, {}).distance <= shape_.radius;
        });
        return any;
    }

    void collide(std::vector<Manifold>& out) {
        for_each_triangle(*surface_.geometry, box_, [&](const SurfaceTriangle& t) { add(t); });
        take_the_uncovered();
        // Deepest first: the normal of a piece is that of its deepest triangle.
        std::sort(patches_.begin(), patches_.end(), [](const Patch& x, const Patch& y) {
            return x.deepest < y.deepest || (x.deepest == y.deepest && x.triangle < y.triangle);
        });
        std::vector<bool> used(patches_.size(), false);
        std::size_t pieces = 0;
        for (std::size_t i = 0; i < patches_.size() && pieces < pieces_max; i++) {
            if (used[i]) continue;
            ContactPoints& sum = patches_[i].points;
            for (std::size_t j = i + 1; j < patches_.size(); j++) {
                if (used[j] || dot(patches_[i].normal, patches_[j].normal) < same_piece) continue;
                used[j] = true;
                for (int k = 0; k < patches_[j].points.count; k++)
                    merge(sum, patches_[j].points.point[k], patches_[j].points.gap[k]);
            }
            pieces++;
            Manifold m = manifold_of(sum, patches_[i].normal);
            m.normal = surface_.axes * m.normal;
            for (int k = 0; k < m.count; k++)
                m.point[k] = surface_.position + surface_.axes * (m.point[k] + origin_);
            out.push_back(m);
        }
    }

private:
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
    static int reduce(ContactPoints& sum) {
        Vec3 normal = cross(sum.point[1] - sum.point[0], sum.point[2] - sum.point[0]);
        const Manifold best = manifold_of(sum, normalized(normal));
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
        const double side = dot(front, middle_of(shape_) - corner[0]) < 0 ? -1 : 1;
        const Vec3 face = front * side;
        // Quick: the shape does not reach the plane.
        const double above = dot(support(shape_, -face) - corner[0], face) - shape_.radius;
        if (above > margin_) return;
        const Convex triangle = triangle_convex(corner, {}, {});
        PairCache cache;
        const Witness w = find_witness(triangle, shape_, margin_ + shape_.radius, cache);
        if (w.distance - shape_.radius > margin_) return;
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
                waiting_.push_back(
                    {{corner[0], corner[1], corner[2]}, w, nearest_on(triangle, w.on_a), t.index});
        }
        if (patch.points.count > 0) take(patch, corner);
    }

    static Vec3 nearest_on(const Convex& triangle, Vec3 p) {
        const Convex point{.core = Core::point, .position = p, .size = {}};
        const GjkResult g = gjk(triangle, point, {});
        return g.distance > 0 ? g.on_a : p;
    }
    double gap_of(const Witness& w) const { return w.distance - shape_.radius; }
    double slack() const { return 1e-3 * size_; }

    // A shape that is below the face without reaching up to it, as a plank under the edge of a
    // table, is not in it.
    void drop_outside(ContactPoints& points, Vec3 face) const {
        int kept = 0;
        for (int k = 0; k < points.count; k++) {
            // Half way between the surfaces; the face's is half the gap up.
            const Convex above{.core = Core::point,
                               .position = points.point[k] - face * (0.5 * points.gap[k]),
                               .size = {}};
            if (points.gap[k] < -0.02 * size_ &&
                gjk(above, shape_, face).distance > shape_.radius + slack())
                continue;
            points.point[kept] = points.point[k];
            points.gap[kept++] = points.gap[k];
        }
        points.count = kept;
    }

    void take(Patch& patch, const Vec3 corner[3]) {
        std::copy(corner, corner + 3, patch.corner);
        for (int k = 0; k < patch.points.count; k++)
            patch.deepest = minimum(patch.deepest, patch.points.gap[k]);
        patches_.push_back(patch);
    }

    // A neighbour pushes in its stead where it is nearest to the shape, and as far out.
    void cover(const Vec3 corner[3], double gap) {
        for (Waiting& w : waiting_)
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

    // Where no neighbour pushes, as at the sharp folds of a crumpled surface, a seam is an edge
    // like any other. The nearest first; those that it covers need nothing more.
    void take_the_uncovered() {
        for (std::size_t k = 0; k < patches_.size() && !waiting_.empty(); k++)
            cover(patches_[k].corner, patches_[k].deepest);
        for (;;) {
            Waiting* next = nullptr;
            for (Waiting& w : waiting_)
                if (!w.covered && (next == nullptr || w.witness.distance < next->witness.distance))
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

    const Placed& surface_;
    double margin_;
    Vec3 origin_;
    Convex shape_;
    Aabb box_;
    double size_ = 0;
    std::vector<Patch> patches_;
    std::vector<Waiting> waiting_;
};

}  // namespace

void collide_surface(const Placed& surface, const Placed& convex, double margin,
                     std::vector<Manifold>& out) {
    SurfacePair(surface, convex, margin).collide(out);
}

bool overlaps_surface(const Placed& surface, const Placed& convex) {
    return SurfacePair(surface, convex, 0).overlaps();
}

}  // namespace jostle::physics
