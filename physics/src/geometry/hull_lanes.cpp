// SPDX-License-Identifier: MIT
#include "physics/src/geometry/hull_lanes.h"

#include <algorithm>
#include <cstdint>

#include "jostle/base/check.h"
#include "physics/src/geometry/box_lanes.h"

namespace jostle::physics {
namespace {

// 16-byte vectors, which all x86-64 and ARM64 processors support; compilers may split wider ones
// into scalars.
using Four = Float4;
using FourMask = Mask4;

Four load(const float* p) {
    return *static_cast<const Four*>(static_cast<const void*>(p));
}
void store(float* p, Four e) {
    *static_cast<Four*>(static_cast<void*>(p)) = e;
}
Four splat(float f) {
    return Four{f, f, f, f};
}

// A pair of balls in single precision, with margins for rounding.
struct BallLanes {
    Four x, y, z, squared, off, lateral;
};
BallLanes lanes_of(const InnerBalls& balls, double sign) {
    const Vec3 d = balls.apart * sign;
    const double rounding = 4e-6 * (length(d) + balls.radii);
    const auto lanes = [](double v) { return splat(static_cast<float>(v)); };
    return {lanes(d.x),
            lanes(d.y),
            lanes(d.z),
            lanes(length_squared(d)),
            lanes(rounding - balls.radii),
            lanes(-1e-5 * length(d))};
}

// Four lanes starting at `at`.
Four along(const DirectionLanes& n, std::size_t at, const BallLanes& d) {
    return (load(n.x + at) * d.x + load(n.y + at) * d.y) + load(n.z + at) * d.z;
}
Four larger(Four a, Four b) {
    return a > b ? a : b;
}
Four smaller(Four a, Four b) {
    return a < b ? a : b;
}
// The maximum over the normals of an arc.
Four most_of_arc(const ArcLanes& arc, std::size_t at, const BallLanes& ball) {
    const Four at_ends = larger(along(arc.first, at, ball), along(arc.second, at, ball));
    const FourMask between = (along(arc.after_first, at, ball) >= ball.lateral) &
                             (along(arc.before_second, at, ball) >= ball.lateral);
    // Of all directions perpendicular to the edge, the projection of the balls' direction gives the
    // maximum if it lies on the arc.
    const Four part = along(arc.along, at, ball);
    const Four square = larger(ball.squared - part * part, splat(0.0f));
    return (between ? larger(root4(square), at_ends) : at_ends) + ball.off;
}

void put(DirectionLanes& lanes, std::size_t lane, Vec3 v) {
    ASSERT(lane < 8);
    lanes.x[lane] = static_cast<float>(v.x);
    lanes.y[lane] = static_cast<float>(v.y);
    lanes.z[lane] = static_cast<float>(v.z);
}

// Number of blocks of `lanes` elements that hold `count` elements.
constexpr std::size_t blocks(std::size_t count, std::size_t lanes) {
    return (count + lanes - 1) / lanes;
}

}  // namespace

HullLanes lanes_of(const ConvexHull& hull) {
    HullLanes lanes;
    ASSERT(!hull.vertices.empty() && !hull.faces.empty() && !hull.edges.empty());
    lanes.vertices.resize(blocks(hull.vertices.size(), 4));
    for (std::size_t k = 0; k < 4 * lanes.vertices.size(); k++) {
        const Vec3 v = hull.vertices[std::min(k, hull.vertices.size() - 1)];
        VertexLanes& to = lanes.vertices[k / 4];
        to.x[k % 4] = v.x, to.y[k % 4] = v.y, to.z[k % 4] = v.z;
        lanes.outer_radius = maximum(lanes.outer_radius, length(v - hull.center));
    }
    lanes.near_vertices.resize(blocks(hull.vertices.size(), 8));
    for (std::size_t k = 0; k < 8 * lanes.near_vertices.size(); k++)
        put(lanes.near_vertices[k / 8], k % 8,
            hull.vertices[std::min(k, hull.vertices.size() - 1)] - hull.center);
    lanes.normals.resize(blocks(hull.faces.size(), 8));
    for (std::size_t k = 0; k < 8 * lanes.normals.size(); k++)
        put(lanes.normals[k / 8], k % 8, hull.faces[std::min(k, hull.faces.size() - 1)].normal);
    lanes.arcs.resize(blocks(hull.edges.size(), 8));
    for (std::size_t k = 0; k < 8 * lanes.arcs.size(); k++) {
        const HullEdge& edge = hull.edges[std::min(k, hull.edges.size() - 1)];
        const Vec3 first = hull.faces[edge.left].normal, second = hull.faces[edge.right].normal;
        const Vec3 turn = normalized(cross(first, second));
        ArcLanes& to = lanes.arcs[k / 8];
        put(to.first, k % 8, first);
        put(to.second, k % 8, second);
        put(to.after_first, k % 8, cross(turn, first));
        put(to.before_second, k % 8, cross(second, turn));
        put(to.along, k % 8, normalized(hull.vertices[edge.to] - hull.vertices[edge.from]));
    }
    return lanes;
}

namespace {

// Writes the dot products with d in single precision and returns the largest.
float dots_along(const std::vector<DirectionLanes>& of, Vec3 d, float* to) {
    const Four x = splat(static_cast<float>(d.x)), y = splat(static_cast<float>(d.y)),
               z = splat(static_cast<float>(d.z));
    Four most = splat(-3e38f);
    for (const DirectionLanes& n : of)
        for (std::size_t half = 0; half < 8; half += 4) {
            const Four at = (load(n.x + half) * x + load(n.y + half) * y) + load(n.z + half) * z;
            store(to, at);
            most = larger(most, at);
            to += 4;
        }
    return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
}

}  // namespace

float normals_along(const HullLanes& lanes, Vec3 d, float* to) {
    return dots_along(lanes.normals, d, to);
}

std::size_t furthest_vertex(const HullLanes& lanes, Vec3 d) {
    alignas(16) float along[max_hull_vertices + 8];
    const std::size_t count = 8 * lanes.near_vertices.size();
    ASSERT(count > 0 && count <= max_hull_vertices + 8);
    const double size = length(d);
    // Single precision needs a direction of moderate length.
    const bool usual = size > 1e-15 && size < 1e15;
    const float most = usual ? dots_along(lanes.near_vertices, d, along) : 0;
    const double least = double{most} - 2e-6 * (size * lanes.outer_radius);
    std::size_t best = 0;
    double reach = -1e300;
    const auto compare = [&](std::size_t k) {
        const VertexLanes& v = lanes.vertices[k / 4];
        const double at = (v.x[k % 4] * d.x + v.y[k % 4] * d.y) + v.z[k % 4] * d.z;
        if (!(at > reach)) return;
        reach = at;
        best = k;
    };
    const std::size_t vertices = 4 * lanes.vertices.size();
    if (!usual) {
        for (std::size_t k = 0; k < vertices; k++) compare(k);
        return best;
    }
    const Four limit = splat(static_cast<float>(least));
    for (std::size_t group = 0; group < vertices; group += 4) {
        unsigned near = lanes_set(load(along + group) >= limit);
        for (std::size_t k = group; near != 0; k++, near >>= 1)
            if ((near & 1) != 0) compare(k);
    }
    return best;
}

void show_normals(const HullLanes& lanes, std::span<const InnerBalls> balls, double sign,
                  float* to) {
    for (std::size_t b = 0; b < balls.size(); b++) {
        const BallLanes ball = lanes_of(balls[b], sign);
        for (std::size_t k = 0; k < 8 * lanes.normals.size(); k += 4) {
            const Four shown = along(lanes.normals[k / 8], k % 8, ball) + ball.off;
            store(to + k, b == 0 ? shown : smaller(shown, load(to + k)));
        }
    }
}

void show_arcs(const HullLanes& lanes, std::span<const InnerBalls> balls, double sign, float* to) {
    for (std::size_t b = 0; b < balls.size(); b++) {
        const BallLanes ball = lanes_of(balls[b], sign);
        for (std::size_t k = 0; k < 8 * lanes.arcs.size(); k += 4) {
            const Four shown = most_of_arc(lanes.arcs[k / 8], k % 8, ball);
            store(to + k, b == 0 ? shown : smaller(shown, load(to + k)));
        }
    }
}

}  // namespace jostle::physics
