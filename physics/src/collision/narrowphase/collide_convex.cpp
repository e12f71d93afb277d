// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_convex.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/collision/narrowphase/penetration.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

Witness flipped(const Witness& w) {
    return {-w.normal, w.distance, w.on_b, w.on_a};
}

Witness from(const Separation& s) {
    return {s.normal, s.distance, s.on_a, s.on_b};
}
Witness from(const GjkResult& g) {
    return {g.normal, g.distance, g.on_a, g.on_b};
}

// Two intersecting segments separate along their common perpendicular. Parallel segments overlap
// and separate in any perpendicular direction.
Witness cross_segments(const Convex& a, const Convex& b) {
    const Vec3 n = normalized(cross(a.axes.y, b.axes.y), a.axes.x);
    const GjkResult at = gjk(a, b, {});
    ASSERT(at.simplex.count >= 0 && at.simplex.count <= 4);
    const SimplexPoint& p = at.simplex.point[0];
    Vec3 on_a, on_b;
    for (int k = 0; k < at.simplex.count; k++) {
        on_a += at.simplex.point[k].a * at.simplex.weight[k];
        on_b += at.simplex.point[k].b * at.simplex.weight[k];
    }
    if (at.simplex.count == 0) on_a = p.a, on_b = p.b;
    const Vec3 toward = dot(middle_of(b) - middle_of(a), n) < 0 ? -n : n;
    return {toward, 0, on_a, on_b};
}

// Normals of the flat ends of a shape. Snapping to one of them keeps the normal of a resting
// contact exactly constant.
int own_normals(const Convex& shape, Vec3 toward, Vec3 out[1]) {
    if (shape.core == Core::point || shape.core == Core::segment) return 0;
    out[0] = feature_along(shape, toward).normal;
    return 1;
}

Witness snapped(const Convex& a, const Convex& b, const Witness& w) {
    const double tie = 1e-6 * minimum(size_of(a), size_of(b));
    ASSERT(is_unit(w.normal));
    Witness best = w;
    const auto consider = [&](Vec3 n) {
        if (dot(n, w.normal) < 1 - 1e-6) return false;
        const Vec3 pa = support(a, n), pb = support(b, -n);
        const double distance = dot(pb - pa, n);
        if (distance < w.distance - tie) return false;
        // Slide the witness onto the axis. Its distance is the distance of the support points.
        best = {n, distance, w.on_a, w.on_b};
        return true;
    };
    Vec3 own[1];
    if (own_normals(a, w.normal, own) > 0 && consider(own[0])) return best;
    if (own_normals(b, -w.normal, own) > 0 && consider(-own[0])) return best;
    return best;
}

Witness round_witness(const Convex& a, const Convex& b, double enough, PairCache& cache) {
    const GjkResult g = gjk(a, b, cache.direction, {.beyond = enough});
    const double size = minimum(size_of(a), size_of(b));
    if (g.distance > 1e-9 * size) {
        cache.direction = g.normal;
        return g.distance > enough ? from(g) : snapped(a, b, from(g));
    }
    const Penetration p = penetration(a, b, g.simplex);
    ASSERT(!(p.depth < 0));
    cache.direction = p.normal;
    return snapped(a, b, {p.normal, -p.depth, p.on_a, p.on_b});
}

// Tolerance in metres within which two axes of two polyhedra are equal.
double tie_of(const Convex& a, const Convex& b) {
    return 2e-5 * minimum(size_of(a), size_of(b));
}

// The witness of two polyhedra that an axis separates. If corners are the closest features, the
// separation along the axis is less than the distance. Returns nullopt if the shapes touch.
std::optional<Witness> apart_witness(const Convex& a, const Convex& b, Vec3 normal, double distance,
                                     double enough, PairCache& cache) {
    const Vec3 hint = length_squared(cache.direction) > 0 ? cache.direction : normal;
    const GjkResult g = gjk(a, b, hint, {.beyond = enough});
    if (g.distance == 0) return std::nullopt;
    if (g.distance <= distance + tie_of(a, b)) {
        cache.direction = normal;
        return Witness{normal, distance, g.on_a, g.on_b};
    }
    cache.direction = g.normal;
    return from(g);
}

// The witness of two polyhedra that the axis of the previous step still separates. The axis remains
// the best one if its separation is the distance; a face axis is the best one if its separation is
// the distance. Otherwise corners or edges are the closest features and no axis search is needed.
// Returns nullopt if the shapes touch.
std::optional<Witness> still_apart_witness(const Convex& a, const Convex& b, const Separation& last,
                                           double enough, PairCache& cache) {
    const auto w = apart_witness(a, b, last.normal, last.distance, enough, cache);
    if (!w || w->normal == last.normal || w->distance > enough) return w;
    const Separation face = separate_by_face(a, b, w->normal);
    if (w->distance > face.distance + tie_of(a, b)) return w;
    cache.axis = face.code;
    return Witness{face.normal, face.distance, w->on_a, w->on_b};
}

Witness polyhedra_witness(const Convex& a, const Convex& b, const Separation& last, double enough,
                          PairCache& cache) {
    ASSERT(is_polyhedron(a) && is_polyhedron(b));
    if (last.distance > enough) return from(last);
    if (last.distance > 0)
        if (const auto apart = still_apart_witness(a, b, last, enough, cache)) return *apart;
    const Separation s = separate(a, b, cache.axis, enough);
    cache.axis = s.code;
    if (s.distance <= 0 || s.distance > enough) return from(s);
    const auto apart = apart_witness(a, b, s.normal, s.distance, enough, cache);
    return apart ? *apart : from(s);
}

// A point or a segment against a polyhedron.
Witness core_witness(const Convex& polyhedron, const Convex& core, double enough,
                     PairCache& cache) {
    const GjkResult g = gjk(polyhedron, core, cache.direction, {.beyond = enough});
    ASSERT(is_polyhedron(polyhedron) && !is_polyhedron(core));
    const double size = minimum(size_of(polyhedron), size_of(core));
    if (g.distance > 1e-9 * size) {
        cache.direction = g.normal;
        return g.distance > enough ? from(g) : snapped(polyhedron, core, from(g));
    }
    return from(separate_segment(polyhedron, core));
}

}  // namespace

Witness find_witness(const Convex& a, const Convex& b, double enough, PairCache& cache) {
    if (is_polyhedron(a) && is_polyhedron(b))
        return polyhedra_witness(a, b, separate_again(a, b, cache.axis), enough, cache);
    const auto is_line = [](const Convex& c) {
        return c.core == Core::point || c.core == Core::segment;
    };
    if (is_polyhedron(a) && is_line(b)) return core_witness(a, b, enough, cache);
    if (is_line(a) && is_polyhedron(b)) {
        PairCache turned{cache.axis, -cache.direction};
        const Witness w = flipped(core_witness(b, a, enough, turned));
        cache = {turned.axis, -turned.direction};
        return w;
    }
    if (is_line(a) && is_line(b)) {
        const GjkResult g = gjk(a, b, cache.direction, {.beyond = enough});
        const double size = minimum(size_of(a), size_of(b));
        if (g.distance > 1e-12 * size) {
            cache.direction = g.normal;
            return from(g);
        }
        return cross_segments(a, b);
    }
    return round_witness(a, b, enough, cache);
}

namespace {

// The manifold along an axis, if the two shapes have points at the separation of the axis. Then no
// other axis separates them by more; and if they overlap along this axis by little, all axes do, up
// to that overlap. So neither the closest points nor the other axes need a search.
std::optional<Manifold> collide_along(const Convex& a, const Convex& b, const Witness& w,
                                      bool between_edges, double margin) {
    if (w.distance - a.radius - b.radius > margin) return std::nullopt;
    // The closest points of two lines may lie outside the edges.
    if (between_edges && length(w.on_b - w.on_a) > absolute(w.distance) + tie_of(a, b))
        return std::nullopt;
    const ContactPoints points = contact_points(a, b, w, margin);
    if (points.count == 0 || (points.witness_added && !between_edges)) return std::nullopt;
    return manifold_of(points, w.normal, minimum(size_of(a), size_of(b)));
}

// Returns whether the cached axis is worth a test. It is not if other features were closest last
// time.
bool may_be_exact(const Convex& a, const Convex& b, const Separation& last, double enough,
                  const PairCache& cache) {
    const double overlap = tuning::trusted_overlap * minimum(size_of(a), size_of(b));
    if (last.distance < -overlap || last.distance > enough) return false;
    return last.distance <= 0 || cache.direction == Vec3{} ||
           dot(cache.direction, last.normal) > 1 - 1e-3;
}

Manifold collide_polyhedra(const Convex& a, const Convex& b, double margin, PairCache& cache) {
    const double radii = a.radius + b.radius, enough = margin + radii;
    const Separation last = separate_again(a, b, cache.axis);
    if (may_be_exact(a, b, last, enough, cache))
        if (const auto m = collide_along(a, b, from(last), is_edge_pair(last.code), margin)) {
            cache.direction = last.normal;
            return *m;
        }
    const Witness w = polyhedra_witness(a, b, last, enough, cache);
    const double gap = w.distance - radii;
    if (gap > margin) return {.normal = w.normal, .distance = gap};
    return manifold_of(contact_points(a, b, w, margin), w.normal, minimum(size_of(a), size_of(b)));
}

}  // namespace

std::optional<Manifold> collide_apart(const Convex& a, const Convex& b, Vec3 normal,
                                      double distance, double margin) {
    const auto along = collide_along(a, b, {normal, distance, {}, {}}, false, margin);
    if (along) return along;
    PairCache none_yet;
    const auto w = apart_witness(a, b, normal, distance, margin, none_yet);
    if (!w) return std::nullopt;
    if (w->distance > margin) return Manifold{.normal = w->normal, .distance = w->distance};
    return manifold_of(contact_points(a, b, *w, margin), w->normal,
                       minimum(size_of(a), size_of(b)));
}

Manifold collide_convex(const Convex& a, const Convex& b, double margin, PairCache& cache) {
    if (is_polyhedron(a) && is_polyhedron(b)) return collide_polyhedra(a, b, margin, cache);
    const Witness w = find_witness(a, b, margin + a.radius + b.radius, cache);
    const double gap = w.distance - a.radius - b.radius;
    if (gap > margin) return {.normal = w.normal, .distance = gap};
    return manifold_of(contact_points(a, b, w, margin), w.normal, minimum(size_of(a), size_of(b)));
}

}  // namespace jostle::physics
