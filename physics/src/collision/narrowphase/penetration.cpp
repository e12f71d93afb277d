// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/penetration.h"

#include "jostle/base/check.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

constexpr int max_points = 96;
constexpr int max_facets = 2 * max_points;

struct Facet {
    int corner[3];
    Vec3 normal;      // unit, outward
    double distance;  // of its plane from the origin
    bool alive;
    bool spent = false;  // cannot be refined further
};

class Polytope {
public:
    Polytope(const Convex& a, const Convex& b)
        : a_(a), b_(b), size_(size_of(a) + size_of(b)), fine_(minimum(size_of(a), size_of(b))) {}

    Penetration expand(const Simplex& start) {
        for (int k = 0; k < start.count; k++) points_[count_++] = start.point[k];
        ASSERT(count_ <= 4);
        if (!make_tetrahedron()) return descend();
        const double tolerance = 1e-7 * fine_;
        // A facet bounds the depth from below; the support along its normal bounds it from above.
        Facet best = facets_[0];
        double upper = 1e300;
        while (count_ < max_points) {
            const int at = nearest();
            if (at < 0 || facets_[at].distance >= upper - tolerance) break;
            const Facet f = facets_[at];
            ASSERT(f.alive && is_unit(f.normal));
            const SimplexPoint p = support_along(f.normal);
            const double h = dot(p.w, f.normal);
            if (h < upper) {
                upper = h;
                best = f;
            }
            if (h - f.distance <= tolerance) break;
            if (known(p.w) || !add_point(p)) facets_[nearest()].spent = true;
        }
        if (upper - best.distance <= 1e-6 * fine_ && !spent_below(upper - 1e-6 * fine_))
            return result_of(best);
        // For deeply overlapping round shapes the two bounds would need thousands of facets to
        // converge, and rounding may have stopped the expansion. A descent then finishes the
        // search.
        return descend();
    }

private:
    SimplexPoint support_along(Vec3 d) const {
        SimplexPoint p{.a = support(a_, d), .b = support(b_, -d), .w = {}};
        p.w = p.a - p.b;
        return p;
    }
    // The extent of the difference along a unit vector: an upper bound of the depth.
    double height(Vec3 n) const { return dot(support(a_, n) - support(b_, -n), n); }

    bool spent_below(double distance) const {
        for (int k = 0; k < facet_count_; k++)
            if (facets_[k].alive && facets_[k].spent && facets_[k].distance < distance) return true;
        return false;
    }

    // Descends from the facets with the least depth, and from the axes of the shapes, to the
    // direction of least depth near them.
    Penetration descend() {
        Vec3 n;
        double least = 1e300;
        const auto consider = [&](Vec3 direction) {
            const double h = height(direction);
            if (h >= least) return;
            least = h;
            n = direction;
        };
        for (const Convex* shape : {&a_, &b_})
            for (const Vec3 axis : {shape->axes.x, shape->axes.y, shape->axes.z})
                for (const double sign : {1.0, -1.0}) consider(axis * sign);
        for (int k = 0; k < facet_count_; k++)
            if (facets_[k].alive) consider(facets_[k].normal);
        least = walk_down(n, least);
        constexpr int starts = 40;
        for (int k = 0; k < facet_count_; k++) facets_[k].spent = false;
        for (int start = 0; start < starts; start++) {
            const int at = nearest();
            if (at < 0 || facets_[at].distance >= least - 1e-6 * fine_) break;
            facets_[at].spent = true;
            Vec3 other = facets_[at].normal;
            const double h = walk_down(other, height(other));
            if (h >= least) continue;
            least = h;
            n = other;
        }
        return parted(n, maximum(0, least));
    }

    // Moves b out along n. The closest points of the separated shapes are the deepest points.
    Penetration parted(Vec3 n, double depth) const {
        ASSERT(depth >= 0 && is_unit(n));
        Convex moved = b_;
        const Vec3 out = n * (depth + 1e-3 * size_);
        moved.position += out;
        const GjkResult g = gjk(a_, moved, n);
        return {depth, n, g.on_a, g.on_b - out};
    }

    // Tests a ring of directions around n. The ring rotates, and shrinks if no direction is better.
    double walk_down(Vec3& n, double least) const {
        double turn = 0;
        for (double step = 0.1; step > 1e-7;) {
            const Vec3 u =
                normalized(cross(n, absolute(n.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
            const Vec3 v = cross(n, u);
            Vec3 best = n;
            double record = least;
            for (int k = 0; k < 8; k++) {
                const SinCos at = sin_cos(turn + k * (pi / 4));
                const Vec3 trial = normalized(n + (u * at.cos + v * at.sin) * step);
                const double h = height(trial);
                if (h < record) {
                    record = h;
                    best = trial;
                }
            }
            turn += 0.7;
            if (record < least) {
                least = record;
                n = best;
            } else {
                step *= 0.5;
            }
        }
        return least;
    }

    bool known(Vec3 w) const {
        for (int k = 0; k < count_; k++)
            if (length_squared(points_[k].w - w) <= 1e-26 * size_ * size_) return true;
        return false;
    }

    // Expands a simplex of fewer points, which contains the origin, with support points outside it.
    bool make_tetrahedron() {
        if (count_ == 0) points_[count_++] = support_along({1, 0, 0});
        static constexpr Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const double least = 1e-7 * size_;
        if (count_ == 1)
            for (const Vec3 axis : axes)
                for (const double sign : {1.0, -1.0})
                    if (count_ == 1)
                        try_point(axis * sign,
                                  [&](Vec3 w) { return length(w - points_[0].w) > least; });
        if (count_ == 2) {
            const Vec3 u = normalized(points_[1].w - points_[0].w);
            for (const Vec3 axis : axes)
                for (const double sign : {1.0, -1.0})
                    if (count_ == 2)
                        try_point(cross(u, axis) * sign, [&](Vec3 w) {
                            return length(cross(w - points_[0].w, u)) > least;
                        });
        }
        if (count_ == 3) {
            const Vec3 n =
                normalized(cross(points_[1].w - points_[0].w, points_[2].w - points_[0].w));
            for (const double sign : {1.0, -1.0})
                if (count_ == 3)
                    try_point(n * sign,
                              [&](Vec3 w) { return absolute(dot(w - points_[0].w, n)) > least; });
        }
        if (count_ < 4) return false;
        ASSERT(count_ == 4 && facet_count_ == 0);
        const Vec3 n = cross(points_[1].w - points_[0].w, points_[2].w - points_[0].w);
        if (dot(n, points_[3].w - points_[0].w) > 0) std::swap(points_[1], points_[2]);
        return add_facet(0, 1, 2) && add_facet(0, 3, 1) && add_facet(1, 3, 2) && add_facet(2, 3, 0);
    }
    template <class Accept>
    void try_point(Vec3 d, Accept&& accept) {
        if (length_squared(d) == 0) return;
        const SimplexPoint p = support_along(d);
        if (accept(p.w)) points_[count_++] = p;
    }

    bool add_facet(int i, int j, int k) {
        if (facet_count_ == max_facets) compact();
        if (facet_count_ == max_facets) return false;
        const Vec3 n = cross(points_[j].w - points_[i].w, points_[k].w - points_[i].w);
        const double l = length(n);
        const double longest2 = maximum(length_squared(points_[j].w - points_[i].w),
                                        maximum(length_squared(points_[k].w - points_[j].w),
                                                length_squared(points_[i].w - points_[k].w)));
        // If the corners are nearly collinear, the normal is noise.
        if (l * l <= 1e-20 * size_ * size_ * longest2) return false;
        const double distance = dot(n, points_[i].w) / l;
        ASSERT(i != j && j != k && k != i);
        if (distance < -1e-9 * size_) return false;  // the origin is inside
        facets_[facet_count_++] = {{i, j, k}, n * (1 / l), distance, true};
        return true;
    }
    void compact() {
        int retained = 0;
        for (int k = 0; k < facet_count_; k++)
            if (facets_[k].alive) facets_[retained++] = facets_[k];
        facet_count_ = retained;
        ASSERT(facet_count_ <= max_facets);
    }

    int nearest() const {
        int best = -1;
        for (int k = 0; k < facet_count_; k++)
            if (facets_[k].alive && !facets_[k].spent &&
                (best < 0 || facets_[k].distance < facets_[best].distance))
                best = k;
        return best;
    }

    // Replaces the facets that face the new point with a fan to their rim. Returns false if
    // rounding produced a facet of zero area; the polytope is then unchanged.
    bool add_point(const SimplexPoint& point) {
        compact();
        const int index = count_;
        ASSERT(count_ < max_points);
        points_[count_++] = point;
        const Vec3 w = point.w;
        int edges[max_facets][2];
        int edge_count = 0;
        const auto add_edge = [&](int i, int j) {
            for (int k = 0; k < edge_count; k++)
                if (edges[k][0] == j && edges[k][1] == i) {
                    edges[k][0] = edges[edge_count - 1][0];
                    edges[k][1] = edges[edge_count - 1][1];
                    edge_count--;
                    return true;
                }
            if (edge_count == max_facets) return false;
            edges[edge_count][0] = i;
            edges[edge_count][1] = j;
            edge_count++;
            return true;
        };
        const int old_count = facet_count_;
        ASSERT(old_count > 0);
        for (int k = 0; k < old_count; k++) {
            Facet& f = facets_[k];
            if (dot(f.normal, w) - f.distance <= 1e-13 * size_) continue;
            f.alive = false;
            for (int e = 0; e < 3; e++)
                if (!add_edge(f.corner[e], f.corner[(e + 1) % 3])) return revive(old_count);
        }
        if (edge_count == 0) return revive(old_count);
        for (int k = 0; k < edge_count; k++)
            if (!add_facet_at_end(edges[k][0], edges[k][1], index)) return revive(old_count);
        return true;
    }
    // Same as add_facet(), but never moves the other facets.
    bool add_facet_at_end(int i, int j, int k) {
        return facet_count_ < max_facets && add_facet(i, j, k);
    }
    bool revive(int old_count) {
        count_--;
        ASSERT(count_ > 0 && old_count <= facet_count_);
        facet_count_ = old_count;
        for (int k = 0; k < old_count; k++) facets_[k].alive = true;
        return false;
    }

    // Among coplanar facets, uses the one that contains the projection of the origin.
    Penetration result_of(const Facet& nearest) const {
        const Facet* facet = nullptr;
        double most = -1e-6, weight[3] = {};
        for (int k = 0; k < facet_count_; k++) {
            const Facet& f = facets_[k];
            if (!f.alive || f.distance > nearest.distance + 1e-6 * fine_ ||
                dot(f.normal, nearest.normal) < 1 - 1e-9)
                continue;
            const Vec3 p = points_[f.corner[0]].w, q = points_[f.corner[1]].w,
                       r = points_[f.corner[2]].w;
            const Vec3 n = cross(q - p, r - p), o = f.normal * f.distance;
            const double n2 = length_squared(n);
            const double u = dot(cross(q - o, r - o), n) / n2, v = dot(cross(r - o, p - o), n) / n2,
                         t = 1 - u - v;
            const double inside = minimum(u, minimum(v, t));
            if (inside <= most) continue;
            most = inside;
            facet = &f;
            weight[0] = u;
            weight[1] = v;
            weight[2] = t;
        }
        if (facet == nullptr) return parted(nearest.normal, maximum(0, nearest.distance));
        Penetration result{maximum(0, nearest.distance), nearest.normal, {}, {}};
        for (int k = 0; k < 3; k++) {
            result.on_a += points_[facet->corner[k]].a * weight[k];
            result.on_b += points_[facet->corner[k]].b * weight[k];
        }
        return result;
    }

    const Convex &a_, &b_;
    double size_, fine_;  // m: of both shapes together, and of the smaller one
    SimplexPoint points_[max_points];
    int count_ = 0;
    Facet facets_[max_facets];
    int facet_count_ = 0;
};

}  // namespace

Penetration penetration(const Convex& a, const Convex& b, const Simplex& start) {
    return Polytope(a, b).expand(start);
}

}  // namespace jostle::physics
