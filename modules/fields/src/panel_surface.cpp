// SPDX-License-Identifier: MIT
#include "modules/fields/src/panel_surface.h"

#include <algorithm>
#include <map>
#include <utility>

#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"

namespace jostle::modules::fields_detail {

using namespace physics;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

double volume_of(const PanelSurface& surface) {
    double volume = 0;
    for (const Triangle& t : surface.triangles)
        volume +=
            dot(surface.vertices[t[0]], cross(surface.vertices[t[1]], surface.vertices[t[2]])) *
            (1.0 / 6);
    return volume;
}

PanelSurface of_box(const Box& box) {
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    const Vec3 h = box.half_extents;
    PanelSurface surface;
    for (int k = 0; k < 8; k++)  // the bits of k select x, y, z
        surface.vertices.push_back(
            {(k & 1) != 0 ? h.x : -h.x, (k & 2) != 0 ? h.y : -h.y, (k & 4) != 0 ? h.z : -h.z});
    for (const auto& f : faces) {
        surface.triangles.push_back({f[0], f[1], f[2]});
        surface.triangles.push_back({f[0], f[2], f[3]});
    }
    return surface;
}

PanelSurface of_hull(const ConvexHull& hull) {
    PanelSurface surface;
    surface.vertices = hull.vertices;
    for (const HullFace& face : hull.faces) {
        const auto corners = hull.vertices_of(face);
        for (std::size_t k = 1; k + 1 < corners.size(); k++)
            surface.triangles.push_back({corners[0], corners[k], corners[k + 1]});
    }
    return surface;
}

// ---- surfaces of revolution about the y axis ----

struct Ring {
    double y, radius;
};
constexpr std::uint32_t around = 12;

// Surface of revolution of rings from bottom to top. The first and the last ring have radius 0.
PanelSurface turned(const std::vector<Ring>& rings, double volume) {
    PanelSurface surface;
    surface.round = true;
    const auto last = static_cast<std::uint32_t>(rings.size() - 1);
    surface.vertices.push_back({0, rings.front().y, 0});
    for (std::uint32_t r = 1; r < last; r++)
        for (std::uint32_t k = 0; k < around; k++) {
            const SinCos turn = sin_cos(2 * pi / around * k);
            surface.vertices.push_back(
                {rings[r].radius * turn.sin, rings[r].y, rings[r].radius * turn.cos});
        }
    surface.vertices.push_back({0, rings.back().y, 0});
    const auto at = [](std::uint32_t ring, std::uint32_t k) {
        return 1 + (ring - 1) * around + k % around;
    };
    const auto top = static_cast<std::uint32_t>(surface.vertices.size() - 1);
    for (std::uint32_t k = 0; k < around; k++) {
        surface.triangles.push_back({0, at(1, k + 1), at(1, k)});
        for (std::uint32_t r = 1; r + 1 < last; r++) {
            const std::uint32_t a = at(r, k), b = at(r, k + 1), c = at(r + 1, k),
                                d = at(r + 1, k + 1);
            surface.triangles.push_back({a, b, c});
            surface.triangles.push_back({b, d, c});
        }
        surface.triangles.push_back({top, at(last - 1, k), at(last - 1, k + 1)});
    }
    const double wider = square_root(volume / volume_of(surface));
    for (Vec3& v : surface.vertices) v.x *= wider, v.z *= wider;
    return surface;
}

// A quarter circle of three arcs, from the pole to the equator.
constexpr std::array<Ring, 3> quarter{
    {{1, 0}, {0.86602540378443865, 0.5}, {0.5, 0.86602540378443865}}};

PanelSurface of_capsule(double radius, double half_length) {
    std::vector<Ring> rings;
    for (const Ring& q : quarter) rings.push_back({-half_length - radius * q.y, radius * q.radius});
    rings.push_back({-half_length, radius});
    if (half_length > 0) rings.push_back({half_length, radius});
    for (std::size_t k = quarter.size(); k-- > 0;)
        rings.push_back({half_length + radius * quarter[k].y, radius * quarter[k].radius});
    const double r2 = pi * radius * radius;
    PanelSurface surface = turned(rings, r2 * (2 * half_length + radius * (4.0 / 3)));
    if (half_length == 0) surface.ball = radius;
    return surface;
}

PanelSurface of_cylinder(const Cylinder& c) {
    return turned({{-c.half_length, 0},
                   {-c.half_length, c.radius},
                   {c.half_length, c.radius},
                   {c.half_length, 0}},
                  2 * pi * c.radius * c.radius * c.half_length);
}

PanelSurface of_cone(const Cone& c) {
    return turned({{-c.half_length, 0}, {-c.half_length, c.radius}, {c.half_length, 0}},
                  2 * pi * c.radius * c.radius * c.half_length / 3);
}

void apply_pose(PanelSurface& surface, const Transform& pose) {
    for (Vec3& v : surface.vertices) v = apply(pose, v);
    surface.center = apply(pose, surface.center);
    surface.axis = rotate(pose.rotation, surface.axis);
}

PanelSurface of_convex(const Geometry& geometry) {
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) return of_capsule(sphere->radius, 0);
    if (const auto* capsule = std::get_if<Capsule>(&geometry))
        return of_capsule(capsule->radius, capsule->half_length);
    if (const auto* box = std::get_if<Box>(&geometry)) return of_box(*box);
    if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) return of_cylinder(*cylinder);
    if (const auto* cone = std::get_if<Cone>(&geometry)) return of_cone(*cone);
    return of_hull(*std::get<Hull>(geometry).data);
}

// ---- refinement ----

struct LongestEdge {
    std::size_t from = 0;  // corner; the edge leads to the next corner
    double squared = 0;
};

LongestEdge longest_edge(const PanelSurface& surface, const Triangle& t) {
    LongestEdge longest;
    for (std::size_t k = 0; k < 3; k++) {
        const double squared =
            length_squared(surface.vertices[t[(k + 1) % 3]] - surface.vertices[t[k]]);
        if (squared > longest.squared) longest = {k, squared};
    }
    return longest;
}

using Middles = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

std::uint32_t middle_of(PanelSurface& surface, Middles& middles, std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(surface.vertices.size());
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), next);
    if (is_new) surface.vertices.push_back((surface.vertices[a] + surface.vertices[b]) * 0.5);
    return at->second;
}

}  // namespace

std::vector<PanelSurface> panel_surfaces(const Geometry& geometry, const Transform& pose) {
    std::vector<PanelSurface> all;
    const auto add = [&](const Geometry& convex, const Transform& at) {
        PanelSurface& surface = all.emplace_back(of_convex(convex));
        apply_pose(surface, at);
        for (const Triangle& t : surface.triangles) surface.area += length(area_of(surface, t));
    };
    if (const auto* compound = std::get_if<Compound>(&geometry)) {
        for (const CompoundChild& child : compound->data->children)
            add(child.geometry, compose(pose, child.pose));
    } else if (is_convex(kind_of(geometry))) {
        add(geometry, pose);
    }
    return all;
}

void refine(PanelSurface& surface, double longest, double largest, std::size_t most) {
    Middles middles;
    // Proceeds in rounds over all triangles that are too large, so that the limit `most` affects
    // the smallest ones.
    for (bool halved = true; halved;) {
        halved = false;
        const std::size_t count = surface.triangles.size();
        for (std::size_t n = 0; n < count && surface.triangles.size() < most; n++) {
            const Triangle t = surface.triangles[n];
            const LongestEdge edge = longest_edge(surface, t);
            if (edge.squared <= longest * longest && length(area_of(surface, t)) <= largest)
                continue;
            const std::uint32_t a = t[edge.from], b = t[(edge.from + 1) % 3],
                                c = t[(edge.from + 2) % 3];
            const std::uint32_t m = middle_of(surface, middles, a, b);
            surface.triangles[n] = {a, m, c};
            surface.triangles.push_back({m, b, c});
            halved = true;
        }
    }
}

Vec3 area_of(const PanelSurface& surface, const Triangle& t) {
    const Vec3 a = surface.vertices[t[0]];
    return cross(surface.vertices[t[1]] - a, surface.vertices[t[2]] - a) * 0.5;
}

}  // namespace jostle::modules::fields_detail
