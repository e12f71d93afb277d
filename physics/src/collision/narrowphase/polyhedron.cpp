// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/polyhedron.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

constexpr HullEdge box_edges[12] = {{0, 4, 0, 2}, {4, 6, 0, 5}, {6, 2, 0, 3}, {2, 0, 0, 4},
                                    {1, 3, 1, 4}, {3, 7, 1, 3}, {7, 5, 1, 5}, {5, 1, 1, 2},
                                    {0, 1, 2, 4}, {5, 4, 2, 5}, {6, 7, 3, 5}, {3, 2, 3, 4}};

// Faces: front, back, then the sides along the edges 01, 12, 20. Each edge occurs twice: between
// front and side, and between side and back.
constexpr std::uint16_t triangle_loops[12] = {0, 1, 2, 0, 2, 1, 1, 0, 2, 1, 0, 2};
constexpr HullEdge triangle_edges[6] = {{0, 1, 0, 2}, {1, 2, 0, 3}, {2, 0, 0, 4},
                                        {1, 0, 1, 2}, {2, 1, 1, 3}, {0, 2, 1, 4}};

Polyhedron box_of(Vec3 h, PolyhedronParts& parts) {
    ASSERT(h.x > 0 && h.y > 0 && h.z > 0);
    for (int k = 0; k < 8; k++) parts.vertices[k] = box_corner(h, k);
    for (int f = 0; f < 6; f++) {
        Vec3 n;
        n[f / 2] = f % 2 == 0 ? -1 : 1;
        parts.faces[f] = {n, h[f / 2], static_cast<std::uint32_t>(4 * f), 4};
    }
    return {{parts.vertices.data(), 8},     {parts.faces.data(), 6}, box_loops, box_edges, {},
            minimum(h.x, minimum(h.y, h.z))};
}

Polyhedron flat_of(const Vec3* corner, PolyhedronParts& parts) {
    for (int k = 0; k < 3; k++) parts.vertices[k] = corner[k];
    const Vec3 n = normalized(cross(corner[1] - corner[0], corner[2] - corner[0]));
    parts.faces[0] = {n, dot(n, corner[0]), 0, 3};
    parts.faces[1] = {-n, -dot(n, corner[0]), 3, 3};
    for (std::uint32_t k = 0; k < 3; k++) {
        const Vec3 side = normalized(cross(corner[(k + 1) % 3] - corner[k], n));
        parts.faces[2 + k] = {side, dot(side, corner[k]), 6 + 2 * k, 2};
    }
    return {{parts.vertices.data(), 3},
            {parts.faces.data(), 5},
            triangle_loops,
            triangle_edges,
            (corner[0] + corner[1] + corner[2]) * (1.0 / 3)};
}

// The largest projection of the vector between two balls onto the normals between the two faces of
// an edge.
double most_of_arc(Vec3 d, Vec3 first, Vec3 second, Vec3 along) {
    const double most = maximum(dot(d, first), dot(d, second));
    const Vec3 turn = cross(first, second);
    ASSERT(!(length_squared(along) <= 0));
    if (dot(cross(first, d), turn) < 0 || dot(cross(d, second), turn) < 0) return most;
    // Among all directions perpendicular to the edge, d without its component along the edge has
    // the largest projection, if it lies between the two normals.
    const double part = dot(d, along);
    return square_root(maximum(0, length_squared(d) - part * part / length_squared(along)));
}

// Rounds up to a float.
float rounded_up(double most, Vec3 apart) {
    return static_cast<float>(most + 1e-6 * length(apart));
}

}  // namespace

Polyhedron polyhedron_of(const Convex& shape, PolyhedronParts& parts) {
    if (shape.core == Core::box) return box_of(shape.size, parts);
    if (shape.core == Core::triangle) return flat_of(shape.corner, parts);
    ASSERT(shape.core == Core::hull);
    const ConvexHull& hull = *shape.hull;
    return {hull.vertices, hull.faces,        hull.face_vertices, hull.edges,
            hull.center,   hull.inner_radius, hull.lanes.get()};
}

std::size_t furthest_vertex(const Polyhedron& shape, Vec3 d) {
    if (shape.lanes != nullptr) return furthest_vertex(*shape.lanes, d);
    ASSERT(!shape.vertices.empty());
    std::size_t best = 0;
    for (std::size_t k = 1; k < shape.vertices.size(); k++)
        if (dot(shape.vertices[k], d) > dot(shape.vertices[best], d)) best = k;
    return best;
}

void show_normals(const Polyhedron& shape, std::span<const InnerBalls> balls, double sign,
                  float* to) {
    if (shape.lanes != nullptr) return show_normals(*shape.lanes, balls, sign, to);
    for (std::size_t k = 0; k < shape.faces.size(); k++) {
        to[k] = 1e30f;
        for (const InnerBalls& ball : balls) {
            const double shown = sign * dot(ball.apart, shape.faces[k].normal) - ball.radii;
            to[k] = std::min(to[k], rounded_up(shown, ball.apart));
        }
    }
}

void show_arcs(const Polyhedron& shape, std::span<const InnerBalls> balls, double sign, float* to) {
    if (shape.lanes != nullptr) return show_arcs(*shape.lanes, balls, sign, to);
    for (std::size_t k = 0; k < shape.edges.size(); k++) {
        const HullEdge& edge = shape.edges[k];
        const Vec3 along = shape.vertices[edge.to] - shape.vertices[edge.from];
        to[k] = 1e30f;
        for (const InnerBalls& ball : balls) {
            const double shown = most_of_arc(ball.apart * sign, shape.faces[edge.left].normal,
                                             shape.faces[edge.right].normal, along);
            to[k] = std::min(to[k], rounded_up(shown - ball.radii, ball.apart));
        }
    }
}

}  // namespace jostle::physics
