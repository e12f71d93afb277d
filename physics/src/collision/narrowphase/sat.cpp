// SPDX-License-Identifier: MIT
#include "collision/narrowphase/sat.h"

#include "foundation/check.h"
#include "foundation/uninitialized_array.h"

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

// Both shapes in a's frame. b's normals and vertices are turned once.
struct Pair {
    Polyhedron a, b;
    UninitializedArray<Vec3, max_hull_vertices> vertices_b;
    Vec3 middle_b;
    Vec3 position;  // of b's frame in a's
    Mat3 axes;      // b's axes in a's

    Vec3 normal_b(std::uint32_t face) const { return axes * b.faces[face].normal; }
};

struct Best {
    double distance = -1e300;
    Vec3 normal;  // from a to b
    AxisCode code = 0;
    Vec3 on_a, on_b;
};

// How far b's deepest vertex is from a face of a.
Best face_axis_a(const Pair& p, std::uint32_t face) {
    const HullFace& f = p.a.faces[face];
    double lowest = 1e300;
    std::size_t deepest = 0;
    for (std::size_t k = 0; k < p.b.vertices.size(); k++) {
        const double d = dot(f.normal, p.vertices_b[k]);
        if (d < lowest) {
            lowest = d;
            deepest = k;
        }
    }
    const double s = lowest - f.offset;
    return {s, f.normal, face_of_a | face << 14, p.vertices_b[deepest] - f.normal * s,
            p.vertices_b[deepest]};
}

Best face_axis_b(const Pair& p, std::uint32_t face) {
    const Vec3 n = p.normal_b(face);
    const double offset = p.b.faces[face].offset + dot(n, p.position);
    double lowest = 1e300;
    std::size_t deepest = 0;
    for (std::size_t k = 0; k < p.a.vertices.size(); k++) {
        const double d = dot(n, p.a.vertices[k]);
        if (d < lowest) {
            lowest = d;
            deepest = k;
        }
    }
    const double s = lowest - offset;
    return {s, -n, face_of_b | face << 14, p.a.vertices[deepest], p.a.vertices[deepest] - n * s};
}

// Whether the arcs (na1, na2) and (nb1, nb2) on the sphere of directions cross; nb are b's normals
// turned round. along_a = na2 x na1 and along_b alike are the edges' directions.
bool arcs_cross(Vec3 na1, Vec3 na2, Vec3 along_a, Vec3 nb1, Vec3 nb2, Vec3 along_b) {
    const double cba = dot(nb1, along_a), dba = dot(nb2, along_a);
    const double adc = dot(na1, along_b), bdc = dot(na2, along_b);
    return cba * dba < 0 && adc * bdc < 0 && cba * bdc > 0;
}

// Where s u, 0 <= s <= 1, and r + t v, least <= t <= 1, are closest (Ericson, "Real-Time Collision
// Detection", 5.1.9). Edges that are all but parallel meet in what they have in common.
struct Nearest {
    double s, t;
};
Nearest nearest_on_edges(Vec3 r, Vec3 u, Vec3 v, double least) {
    const double uu = length_squared(u), vv = length_squared(v), uv = dot(u, v);
    const double ru = dot(r, u), rv = dot(r, v);
    const double s = clamp((ru * vv - rv * uv) / (uu * vv - uv * uv), 0, 1);
    const double t = clamp((s * uv - rv) / vv, least, 1);
    return {clamp((ru + t * uv) / uu, 0, 1), t};
}

// The axis of two edges, whether or not they are a face of the difference.
Best edge_axis(const Pair& p, std::uint32_t ea, std::uint32_t eb) {
    const HullEdge &x = p.a.edges[ea], &y = p.b.edges[eb];
    const Vec3 pa = p.a.vertices[x.from], u = p.a.vertices[x.to] - pa;
    const Vec3 pb = p.vertices_b[y.from], v = p.vertices_b[y.to] - pb;
    Vec3 n = cross(u, v);
    const double l2 = length_squared(n), uu = length_squared(u), vv = length_squared(v);
    if (l2 < 1e-10 * uu * vv) return {};  // parallel: a face says it better
    n = n * (1 / square_root(l2));
    // Out of a and into b: of a triangle's edge with one that lies in its plane only b can tell.
    if (dot(n, pa - p.a.middle) < dot(n, pb - p.middle_b)) n = -n;
    const Vec3 r = pb - pa;
    const Nearest at = nearest_on_edges(r, u, v, 0);
    return {dot(n, r), n, edge_pair | ea << 14 | eb, pa + u * at.s, pb + v * at.t};
}

Best edge_axes(const Pair& p) {
    Best best;
    for (std::uint32_t j = 0; j < p.b.edges.size(); j++) {
        const HullEdge& y = p.b.edges[j];
        const Vec3 nb1 = -p.normal_b(y.left), nb2 = -p.normal_b(y.right);
        const Vec3 v = p.vertices_b[y.to] - p.vertices_b[y.from];
        for (std::uint32_t i = 0; i < p.a.edges.size(); i++) {
            const HullEdge& x = p.a.edges[i];
            const Vec3 u = p.a.vertices[x.to] - p.a.vertices[x.from];
            if (!arcs_cross(p.a.faces[x.left].normal, p.a.faces[x.right].normal, u, nb1, nb2, v))
                continue;
            const Best e = edge_axis(p, i, j);
            if (e.distance > best.distance) best = e;
        }
    }
    return best;
}

void make_pair(Pair& p, const Convex& a, const Convex& b, PolyhedronParts& parts_a,
               PolyhedronParts& parts_b) {
    p.a = polyhedron_of(a, parts_a);
    p.b = polyhedron_of(b, parts_b);
    p.position = transposed_times(a.axes, b.position - a.position);
    p.axes = transpose(a.axes) * b.axes;
    p.middle_b = p.position + p.axes * p.b.middle;
    for (std::size_t k = 0; k < p.b.vertices.size(); k++)
        p.vertices_b[k] = p.position + p.axes * p.b.vertices[k];
}

Best axis_of(const Pair& p, AxisCode code) {
    if (kind_of(code) == face_of_a && first_edge(code) < p.a.faces.size())
        return face_axis_a(p, first_edge(code));
    if (kind_of(code) == face_of_b && first_edge(code) < p.b.faces.size())
        return face_axis_b(p, first_edge(code));
    if (kind_of(code) == edge_pair && first_edge(code) < p.a.edges.size() &&
        second_edge(code) < p.b.edges.size()) {
        // Only a real face of the difference bounds the distance; others may lie.
        const HullEdge &x = p.a.edges[first_edge(code)], &y = p.b.edges[second_edge(code)];
        if (arcs_cross(p.a.faces[x.left].normal, p.a.faces[x.right].normal,
                       p.a.vertices[x.to] - p.a.vertices[x.from], -p.normal_b(y.left),
                       -p.normal_b(y.right), p.vertices_b[y.to] - p.vertices_b[y.from]))
            return edge_axis(p, first_edge(code), second_edge(code));
    }
    return {};
}

Separation in_world(const Convex& a, const Best& best) {
    return {best.distance, a.axes * best.normal, best.code, a.position + a.axes * best.on_a,
            a.position + a.axes * best.on_b};
}

}  // namespace

Separation separate(const Convex& a, const Convex& b, AxisCode cached, double enough) {
    PolyhedronParts parts_a, parts_b;
    Pair p;
    make_pair(p, a, b, parts_a, parts_b);
    const Best old = axis_of(p, cached);
    if (old.distance > enough) return in_world(a, old);

    // Of axes that are equal up to rounding the cached one stays, else faces go before edges: the
    // normal of a resting contact must not flicker.
    const double tie = 2e-5 * minimum(size_of(a), size_of(b));
    Best best;
    for (std::uint32_t f = 0; f < p.a.faces.size(); f++) {
        const Best candidate = face_axis_a(p, f);
        if (candidate.distance > enough) return in_world(a, candidate);
        if (candidate.distance > best.distance) best = candidate;
    }
    Best face_b;
    for (std::uint32_t f = 0; f < p.b.faces.size(); f++) {
        const Best candidate = face_axis_b(p, f);
        if (candidate.distance > enough) return in_world(a, candidate);
        if (candidate.distance > face_b.distance) face_b = candidate;
    }
    if (face_b.distance > best.distance + 1e-9 * size_of(a)) best = face_b;
    const Best edge = edge_axes(p);
    if (edge.distance > best.distance + tie) best = edge;
    if (old.code != 0 && old.distance > best.distance - tie) best = old;
    return in_world(a, best);
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
        // The segment's normals are the great circle across it.
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
