// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/sat.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/box_lanes.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

constexpr AxisCode face_of_a = 1u << 28, face_of_b = 2u << 28, edge_pair = 3u << 28;

constexpr AxisCode kind_of(AxisCode code) {
    return code & (3u << 28);
}
constexpr std::uint32_t first_edge(AxisCode code) {
    return code >> 14 & 0x3fff;
}
constexpr std::uint32_t second_edge(AxisCode code) {
    return code & 0x3fff;
}

// Both shapes in a's frame.
struct Pair {
    Polyhedron a, b;
    Vec3 middle_b;
    Vec3 position;  // of b's frame in a's
    Mat3 axes;      // b's axes in a's
    double size;    // m

    Vec3 normal_b(std::uint32_t face) const { return axes * b.faces[face].normal; }
    Vec3 vertex_b(std::size_t k) const { return position + axes * b.vertices[k]; }
};

struct Best {
    double distance = -1e300;
    Vec3 normal;  // from a to b
    AxisCode code = 0;
    Vec3 on_a, on_b;
};

// The last point inside the face on the segment from its centre to a point in its plane.
Vec3 last_on_face(const Polyhedron& shape, std::uint32_t face, Vec3 point) {
    const auto corners = shape.vertices_of(shape.faces[face]);
    const Vec3 normal = shape.faces[face].normal;
    ASSERT(corners.size() >= 2);
    Vec3 middle;
    for (const std::uint16_t k : corners) middle += shape.vertices[k];
    middle = middle * (1.0 / static_cast<double>(corners.size()));
    double part = 1;
    for (std::size_t k = 0; k < corners.size(); k++) {
        const Vec3 from = shape.vertices[corners[k]],
                   to = shape.vertices[corners[(k + 1) % corners.size()]];
        const Vec3 out = cross(to - from, normal);
        const double inside = dot(out, from - middle), beyond = dot(out, point - middle);
        if (beyond > inside) part = minimum(part, inside / beyond);
    }
    return middle + (point - middle) * maximum(part, 0);
}

// Points of the two shapes, in a's frame, near the separation of an axis. The point projected onto
// a face plane may lie outside the face.
Vec3 point_of_a(const Pair& p, const Best& axis) {
    return kind_of(axis.code) == face_of_a ? last_on_face(p.a, first_edge(axis.code), axis.on_a)
                                           : axis.on_a;
}
Vec3 point_of_b(const Pair& p, const Best& axis) {
    if (kind_of(axis.code) != face_of_b) return axis.on_b;
    const Vec3 in_b = transposed_times(p.axes, axis.on_b - p.position);
    return p.position + p.axes * last_on_face(p.b, first_edge(axis.code), in_b);
}

// Rejects axes that cannot be the best, which is most of them once one axis is known. Balls inside
// the shapes bound the separation along an axis, and along all axes of an edge's normal arc.
class AxisFilter {
public:
    AxisFilter(const Pair& p, const Best& old) : axes_(p.axes), slack_(1e-4 * p.size) {
        add(p.a.middle, p.a.inner_radius, p.middle_b, p.b.inner_radius);
        if (old.code == 0) return;
        // Points where the shapes were nearest. For long shapes the ball at the centre is a weak
        // bound.
        add(point_of_a(p, old), 0, p.middle_b, p.b.inner_radius);
        add(p.a.middle, p.a.inner_radius, point_of_b(p, old), 0);
        raise_bound(old.distance);
    }
    // Raises the bound to a known separation. Axes that are lower by more than the tie tolerance
    // are rejected.
    void raise_bound(double distance) { known_ = maximum(known_, distance - slack_); }
    bool has_bound() const { return known_ > -1e299; }
    // `most`: upper bound of the separation along an axis, m.
    bool may_be_best(float most) const { return double{most} >= known_; }
    double least() const { return known_; }

    std::span<const InnerBalls> in_a() const { return {in_a_, count_}; }
    std::span<const InnerBalls> in_b() const { return {in_b_, count_}; }

private:
    void add(Vec3 in_a, double radius_a, Vec3 in_b, double radius_b) {
        in_a_[count_] = {in_b - in_a, radius_a + radius_b};
        ASSERT(count_ < 3 && radius_a >= 0 && radius_b >= 0);
        in_b_[count_] = {transposed_times(axes_, in_a_[count_].apart), radius_a + radius_b};
        count_++;
    }

    const Mat3& axes_;
    double slack_, known_ = -1e300;
    std::size_t count_ = 0;
    InnerBalls in_a_[3], in_b_[3];
};

// The separation of b's deepest vertex from a face of a.
Best face_axis_a(const Pair& p, std::uint32_t face) {
    const HullFace& f = p.a.faces[face];
    ASSERT(is_unit(f.normal));
    const Vec3 deepest = p.vertex_b(furthest_vertex(p.b, -transposed_times(p.axes, f.normal)));
    const double s = dot(f.normal, deepest) - f.offset;
    return {s, f.normal, face_of_a | face << 14, deepest - f.normal * s, deepest};
}

Best face_axis_b(const Pair& p, std::uint32_t face) {
    const Vec3 n = p.normal_b(face);
    ASSERT(is_unit(n));
    const double offset = p.b.faces[face].offset + dot(n, p.position);
    const Vec3 deepest = p.a.vertices[furthest_vertex(p.a, -n)];
    const double s = dot(n, deepest) - offset;
    return {s, -n, face_of_b | face << 14, deepest, deepest - n * s};
}

// The best face axis of a shape, or the first one with a separation above `enough`. `most`: upper
// bounds of the separations; `axis`: computes the separation.
template <class Axis>
Best best_face(std::size_t count, const float* most, double enough, AxisFilter& filter,
               const Axis& axis) {
    Best best;
    if (!filter.has_bound()) {
        const auto first = static_cast<std::uint32_t>(std::max_element(most, most + count) - most);
        ASSERT(first < count);
        const Best promising = axis(first);
        if (promising.distance > enough) return promising;
        filter.raise_bound(promising.distance);
    }
    for (std::uint32_t f = 0; f < count; f++) {
        if (!filter.may_be_best(most[f])) continue;
        const Best candidate = axis(f);
        if (candidate.distance > enough) return candidate;
        if (candidate.distance > best.distance) best = candidate;
        filter.raise_bound(candidate.distance);
    }
    return best;
}

// Returns whether the arcs (na1, na2) and (nb1, nb2) on the unit sphere intersect. nb are b's
// negated normals. along_a = na2 x na1 and the corresponding along_b are the edge directions.
bool arcs_cross(Vec3 na1, Vec3 na2, Vec3 along_a, Vec3 nb1, Vec3 nb2, Vec3 along_b) {
    const double cba = dot(nb1, along_a), dba = dot(nb2, along_a);
    const double adc = dot(na1, along_b), bdc = dot(na2, along_b);
    return cba * dba < 0 && adc * bdc < 0 && cba * bdc > 0;
}

// Closest points of s u, 0 <= s <= 1, and r + t v, least <= t <= 1 (Ericson, "Real-Time Collision
// Detection", 5.1.9). Nearly parallel edges use a point of their overlap.
struct Nearest {
    double s, t;
};
Nearest nearest_on_edges(Vec3 r, Vec3 u, Vec3 v, double least) {
    const double uu = length_squared(u), vv = length_squared(v), uv = dot(u, v);
    ASSERT(!(uu <= 0) && !(vv <= 0));
    const double ru = dot(r, u), rv = dot(r, v);
    const double s = clamp((ru * vv - rv * uv) / (uu * vv - uv * uv), 0, 1);
    const double t = clamp((s * uv - rv) / vv, least, 1);
    return {clamp((ru + t * uv) / uu, 0, 1), t};
}

// The axis of two edges, whether or not they form a face of the Minkowski difference.
struct EdgeAxis {
    double distance = -1e300;
    Vec3 normal;
};
EdgeAxis edge_axis(const Pair& p, std::uint32_t ea, std::uint32_t eb) {
    const HullEdge &x = p.a.edges[ea], &y = p.b.edges[eb];
    const Vec3 pa = p.a.vertices[x.from], u = p.a.vertices[x.to] - pa;
    const Vec3 pb = p.vertex_b(y.from), v = p.vertex_b(y.to) - pb;
    Vec3 n = cross(u, v);
    const double l2 = length_squared(n), uu = length_squared(u), vv = length_squared(v);
    if (l2 < 1e-10 * uu * vv) return {};  // parallel: a face axis is more accurate
    n = n * (1 / square_root(l2));
    // Orient n out of a and into b. For an edge in the plane of a triangle, only b determines the
    // sign.
    if (dot(n, pa - p.a.middle) < dot(n, pb - p.middle_b)) n = -n;
    return {dot(n, pb - pa), n};
}

Best with_points(const Pair& p, const EdgeAxis& axis, std::uint32_t ea, std::uint32_t eb) {
    if (axis.distance == EdgeAxis{}.distance) return {};
    const HullEdge &x = p.a.edges[ea], &y = p.b.edges[eb];
    const Vec3 pa = p.a.vertices[x.from], u = p.a.vertices[x.to] - pa;
    const Vec3 pb = p.vertex_b(y.from), v = p.vertex_b(y.to) - pb;
    const Nearest at = nearest_on_edges(pb - pa, u, v, 0);
    return {axis.distance, axis.normal, edge_pair | ea << 14 | eb, pa + u * at.s, pb + v * at.t};
}

constexpr std::size_t max_faces = 2 * max_hull_vertices, max_edges = 3 * max_hull_vertices;

Vec3 along_edge(const Polyhedron& shape, const HullEdge& edge) {
    return shape.vertices[edge.to] - shape.vertices[edge.from];
}

// The point of an edge nearest to the origin. Along the common perpendicular of two edges all
// points of an edge are equal, and single precision is most accurate for the nearest one.
Vec3 nearest_to_origin(Vec3 from, Vec3 along) {
    return from - along * clamp(dot(from, along) / length_squared(along), 0, 1);
}

// The candidates of the first shape in groups of four.
struct EdgeLanes {
    Float4 first[3], second[3];  // normals of the two faces
    Float4 along[3], point[3];
    Float4 squared;  // length of the edge

    void put(int lane, Vec3 n1, Vec3 n2, Vec3 u, Vec3 at) {
        for (int k = 0; k < 3; k++) {
            first[k][lane] = static_cast<float>(n1[k]);
            second[k][lane] = static_cast<float>(n2[k]);
            along[k][lane] = static_cast<float>(u[k]);
            point[k][lane] = static_cast<float>(at[k]);
        }
        squared[lane] = static_cast<float>(length_squared(u));
    }
};

// An edge of the second shape, with the negated normals of its faces, against four of the first.
class EdgeTest {
public:
    EdgeTest(Vec3 n1, Vec3 n2, Vec3 v, Vec3 at) {
        spread(n1, n1_);
        spread(n2 - n1, change_);
        spread(n2, n2_);
        spread(v, along_);
        spread(at, point_);
    }
    // Returns the edges that may form a face of the Minkowski difference with a separation above
    // `least`. The normal is where the arcs cross: on the arc of the second edge, perpendicular to
    // the first one. Nearly parallel edges, for which it is inaccurate, are all returned.
    unsigned operator()(const EdgeLanes& a, Float4 least) const {
        const Float4 cba = times(n1_, a.along), dba = times(n2_, a.along);
        const Float4 steep = larger4(cba * cba, dba * dba);
        const Mask4 parallel = steep <= a.squared * splat4(1e-4f);
        const Float4 zero = splat4(0);
        Mask4 meet = cba * dba < zero;
        if (lanes_set(meet | parallel) == 0) return 0;
        const Float4 adc = times(a.first, along_), bdc = times(a.second, along_);
        meet &= (adc * bdc < zero) & (cba * bdc > zero);
        if (lanes_set(meet) == 0) return lanes_set(parallel);
        const Float4 part = meet ? cba / (cba - dba) : zero;
        Float4 n[3], apart[3];
        for (int k = 0; k < 3; k++) {
            n[k] = n1_[k] + change_[k] * part;
            apart[k] = point_[k] - a.point[k];
        }
        const Float4 distance = times(n, apart), size = root4(times(n, n));
        return lanes_set(parallel | (meet & (distance > least * size)));
    }

private:
    static void spread(Vec3 v, Float4 (&to)[3]) {
        for (int k = 0; k < 3; k++) to[k] = splat4(static_cast<float>(v[k]));
    }
    static Float4 times(const Float4 (&a)[3], const Float4 (&b)[3]) {
        return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
    }

    Float4 n1_[3], n2_[3], change_[3], along_[3], point_[3];
};

// The edges that may show the largest separation.
struct KeptEdges {
    KeptEdges() {}  // NOLINT(modernize-use-equals-default): does not clear the array

    std::size_t count = 0;
    std::uint32_t edge[max_edges];
};
void keep_edges(KeptEdges& kept, const Polyhedron& shape, std::span<const InnerBalls> balls,
                double sign, const AxisFilter& filter) {
    alignas(16) float most[max_edges + 8];
    ASSERT(shape.edges.size() <= max_edges);
    show_arcs(shape, balls, sign, most);
    for (std::uint32_t k = 0; k < shape.edges.size(); k++)
        if (filter.may_be_best(most[k])) kept.edge[kept.count++] = k;
}

Best edge_axes(const Pair& p, const AxisFilter& filter) {
    KeptEdges of_a, of_b;
    keep_edges(of_a, p.a, filter.in_a(), 1, filter);
    if (of_a.count == 0) return {};
    keep_edges(of_b, p.b, filter.in_b(), -1, filter);
    if (of_b.count == 0) return {};
    const Vec3 origin = p.a.inner_radius < p.b.inner_radius ? p.a.middle : p.middle_b;
    const std::size_t groups = (of_a.count + 3) / 4;
    UninitializedArray<EdgeLanes, max_edges / 4 + 1> lanes;
    for (std::size_t k = 0; k < 4 * groups; k++) {
        const HullEdge& x = p.a.edges[of_a.edge[std::min(k, of_a.count - 1)]];
        const Vec3 u = along_edge(p.a, x);
        lanes[k / 4].put(static_cast<int>(k % 4), p.a.faces[x.left].normal,
                         p.a.faces[x.right].normal, u,
                         nearest_to_origin(p.a.vertices[x.from] - origin, u));
    }
    // Single precision selects the candidates; the best one is found among them exactly.
    const double rounding = 1e-5 * p.size;
    double least = filter.least() - rounding;
    EdgeAxis best;
    std::uint32_t best_a = 0, best_b = 0;
    for (std::size_t j = 0; j < of_b.count; j++) {
        const HullEdge& y = p.b.edges[of_b.edge[j]];
        const Vec3 nb1 = -p.normal_b(y.left), nb2 = -p.normal_b(y.right);
        const Vec3 v = p.axes * along_edge(p.b, y);
        const EdgeTest test(nb1, nb2, v, nearest_to_origin(p.vertex_b(y.from) - origin, v));
        for (std::size_t group = 0; group < groups; group++) {
            unsigned todo = test(lanes[group], splat4(static_cast<float>(least)));
            for (std::size_t k = 4 * group; todo != 0; k++, todo >>= 1) {
                if ((todo & 1) == 0 || k >= of_a.count) continue;
                const std::uint32_t i = of_a.edge[k];
                const HullEdge& x = p.a.edges[i];
                if (!arcs_cross(p.a.faces[x.left].normal, p.a.faces[x.right].normal,
                                along_edge(p.a, x), nb1, nb2, v))
                    continue;
                const EdgeAxis e = edge_axis(p, i, of_b.edge[j]);
                if (e.distance <= best.distance) continue;
                best = e;
                best_a = i;
                best_b = of_b.edge[j];
                least = maximum(least, best.distance - rounding);
            }
        }
    }
    return with_points(p, best, best_a, best_b);
}

void make_pair(Pair& p, const Convex& a, const Convex& b, PolyhedronParts& parts_a,
               PolyhedronParts& parts_b) {
    p.a = polyhedron_of(a, parts_a);
    p.b = polyhedron_of(b, parts_b);
    p.position = transposed_times(a.axes, b.position - a.position);
    p.axes = transpose(a.axes) * b.axes;
    p.size = minimum(size_of(a), size_of(b));
    ASSERT(p.size > 0);
    p.middle_b = p.position + p.axes * p.b.middle;
}

Best axis_of(const Pair& p, AxisCode code) {
    if (kind_of(code) == face_of_a && first_edge(code) < p.a.faces.size())
        return face_axis_a(p, first_edge(code));
    if (kind_of(code) == face_of_b && first_edge(code) < p.b.faces.size())
        return face_axis_b(p, first_edge(code));
    if (kind_of(code) == edge_pair && first_edge(code) < p.a.edges.size() &&
        second_edge(code) < p.b.edges.size()) {
        // Only a real face of the Minkowski difference bounds the distance; other axes may not.
        const HullEdge &x = p.a.edges[first_edge(code)], &y = p.b.edges[second_edge(code)];
        if (arcs_cross(p.a.faces[x.left].normal, p.a.faces[x.right].normal,
                       p.a.vertices[x.to] - p.a.vertices[x.from], -p.normal_b(y.left),
                       -p.normal_b(y.right), p.vertex_b(y.to) - p.vertex_b(y.from)))
            return with_points(p, edge_axis(p, first_edge(code), second_edge(code)),
                               first_edge(code), second_edge(code));
    }
    return {};
}

Separation in_world(const Convex& a, const Best& best) {
    return {best.distance, a.axes * best.normal, best.code, a.position + a.axes * best.on_a,
            a.position + a.axes * best.on_b};
}

}  // namespace

bool is_edge_pair(AxisCode code) {
    return kind_of(code) == edge_pair;
}

AxisCode axis_of_face(std::uint32_t face) {
    return face_of_a | face << 14;
}

Separation separate(const Convex& a, const Convex& b, AxisCode cached, double enough) {
    PolyhedronParts parts_a, parts_b;
    Pair p;
    make_pair(p, a, b, parts_a, parts_b);
    const Best old = axis_of(p, cached);
    if (old.distance > enough) return in_world(a, old);

    // Among axes that are equal up to rounding, the cached one wins, then faces before edges. The
    // normal of a resting contact must not flicker.
    const double tie = 2e-5 * p.size;
    AxisFilter filter(p, old);
    alignas(16) float most[max_faces + 8];
    ASSERT(p.a.faces.size() <= max_faces && p.b.faces.size() <= max_faces);
    show_normals(p.a, filter.in_a(), 1, most);
    Best best = best_face(p.a.faces.size(), most, enough, filter,
                          [&](std::uint32_t face) { return face_axis_a(p, face); });
    if (best.distance > enough) return in_world(a, best);
    show_normals(p.b, filter.in_b(), -1, most);
    const Best face_b = best_face(p.b.faces.size(), most, enough, filter,
                                  [&](std::uint32_t face) { return face_axis_b(p, face); });
    if (face_b.distance > enough) return in_world(a, face_b);
    if (face_b.distance > best.distance + 1e-9 * size_of(a)) best = face_b;
    const Best edge = edge_axes(p, filter);
    if (edge.distance > best.distance + tie) best = edge;
    if (old.code != 0 && old.distance > best.distance - tie) best = old;
    return in_world(a, best);
}

Separation separate_again(const Convex& a, const Convex& b, AxisCode cached) {
    PolyhedronParts parts_a, parts_b;
    Pair p;
    make_pair(p, a, b, parts_a, parts_b);
    return in_world(a, axis_of(p, cached));
}

Separation separate_by_face(const Convex& a, const Convex& b, Vec3 direction) {
    PolyhedronParts parts_a, parts_b;
    Pair p;
    make_pair(p, a, b, parts_a, parts_b);
    const auto max_along = [](const Polyhedron& shape, Vec3 d) {
        std::uint32_t best = 0;
        double most = -2;
        for_each_face_along(shape, d, [&](std::size_t face, double along) {
            if (along <= most) return;
            most = along;
            best = static_cast<std::uint32_t>(face);
        });
        return best;
    };
    const Best of_a = face_axis_a(p, max_along(p.a, transposed_times(a.axes, direction)));
    const Best of_b = face_axis_b(p, max_along(p.b, -transposed_times(b.axes, direction)));
    return in_world(a, of_b.distance > of_a.distance ? of_b : of_a);
}

Separation separate_segment(const Convex& polyhedron, const Convex& segment) {
    PolyhedronParts parts;
    const Polyhedron p = polyhedron_of(polyhedron, parts);
    const Vec3 middle = transposed_times(polyhedron.axes, segment.position - polyhedron.position);
    const Vec3 along = transposed_times(polyhedron.axes, segment.axes.y) * segment.size.y;
    Best best;
    for (std::uint32_t f = 0; f < p.faces.size(); f++) {
        const Vec3 n = p.faces[f].normal;
        const Vec3 end = dot(n, along) > 0 ? middle - along : middle + along;
        const double s = dot(n, end) - p.faces[f].offset;
        if (s > best.distance) best = {s, n, face_of_a | f << 14, end - n * s, end};
    }
    for (std::uint32_t e = 0; e < p.edges.size(); e++) {
        const HullEdge& edge = p.edges[e];
        // The normals of a segment form the great circle perpendicular to it.
        if (dot(p.faces[edge.left].normal, along) * dot(p.faces[edge.right].normal, along) >= 0)
            continue;
        const Vec3 from = p.vertices[edge.from], u = p.vertices[edge.to] - from;
        Vec3 n = cross(u, along);
        const double l2 = length_squared(n), uu = length_squared(u), vv = length_squared(along);
        if (l2 < 1e-10 * uu * vv) continue;
        n = n * (1 / square_root(l2));
        if (dot(n, from - p.middle) < 0) n = -n;
        const double s = dot(n, middle - from);
        if (s <= best.distance) continue;
        const Nearest at = nearest_on_edges(middle - from, u, along, -1);
        best = {s, n, edge_pair | e << 14, from + u * at.s, middle + along * at.t};
    }
    return in_world(polyhedron, best);
}

}  // namespace jostle::physics
