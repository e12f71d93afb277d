// SPDX-License-Identifier: MIT
#include "modules/convex_decomposition/src/closed_mesh.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "jostle/physics/scalar.h"

namespace jostle::modules::convex_decomposition {
namespace {

using namespace physics;

constexpr std::size_t triangles_max = 200000;
constexpr double largest = 1e5;  // m

Error invalid(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

Status check_numbers(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices) {
    if (indices.empty() || indices.size() % 3 != 0 || indices.size() / 3 > triangles_max)
        return invalid("indices has " + std::to_string(indices.size()) +
                       " elements; it must have 3 per triangle, for 1 to 200000 triangles");
    for (std::size_t k = 0; k < indices.size(); k++)
        if (indices[k] >= vertices.size())
            return invalid("indices[" + std::to_string(k) + "] is " + std::to_string(indices[k]) +
                           "; there are " + std::to_string(vertices.size()) + " vertices");
    for (std::size_t k = 0; k < vertices.size(); k++)
        for (int axis = 0; axis < 3; axis++)
            if (!(absolute(vertices[k][axis]) <= largest))
                return invalid("vertices[" + std::to_string(k) +
                               "] is out of range; it must be within 1e5 m");
    return {};
}

// Merges vertices at the same position: files often duplicate them for colours.
std::vector<std::uint32_t> welded(std::span<const Vec3> vertices) {
    const auto less = [](Vec3 a, Vec3 b) {
        return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z);
    };
    std::map<Vec3, std::uint32_t, decltype(less)> first(less);
    std::vector<std::uint32_t> merged;
    for (std::uint32_t k = 0; k < vertices.size(); k++)
        merged.push_back(first.emplace(vertices[k], k).first->second);
    return merged;
}

// Each directed edge must occur as often as its opposite.
Status check_edges(std::span<const std::uint32_t> corners) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges;
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
        for (std::size_t k = 0; k < 3; k++)
            directed_edges[{corners[t + k], corners[t + (k + 1) % 3]}]++;
    for (const auto& [edge, count] : directed_edges) {
        const auto opposite = directed_edges.find({edge.second, edge.first});
        if (opposite != directed_edges.end() && opposite->second == count) continue;
        return invalid("the mesh is not a solid: the edge from vertex " +
                       std::to_string(edge.first) + " to " + std::to_string(edge.second) +
                       " does not have a triangle on each side");
    }
    return {};
}

double volume_of(const std::vector<Triangle>& triangles, Vec3 origin) {
    double six = 0;
    for (const Triangle& t : triangles)
        six += dot(t[0] - origin, cross(t[1] - origin, t[2] - origin));
    return six / 6;
}

Vec3 nearest_on(const Triangle& t, Vec3 p) {
    // Ericson, "Real-Time Collision Detection" (2005), 5.1.5.
    const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return t[0];
    const Vec3 bp = p - t[1];
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return t[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + ab * (d1 / (d1 - d3));
    const Vec3 cp = p - t[2];
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return t[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return t[1] + (t[2] - t[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double sum = va + vb + vc;
    return sum == 0 ? t[0] : t[0] + ab * (vb / sum) + ac * (vc / sum);
}

// Returns true if a ray from the point along +x hits the triangle. In the (y, z) projection, each
// edge belongs to exactly one of its two triangles.
bool is_crossed(const Triangle& t, Vec3 p) {
    bool inside = false;
    for (std::size_t k = 0; k < 3; k++) {
        const Vec3 a = t[k], b = t[(k + 1) % 3];
        if ((a.z > p.z) == (b.z > p.z)) continue;
        if (p.y < a.y + (b.y - a.y) * (p.z - a.z) / (b.z - a.z)) inside = !inside;
    }
    if (!inside) return false;
    const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
    if (n.x == 0) return false;
    return t[0].x - (n.y * (p.y - t[0].y) + n.z * (p.z - t[0].z)) / n.x > p.x;
}

}  // namespace

Result<ClosedMesh> make_closed_mesh(std::span<const Vec3> vertices,
                                    std::span<const std::uint32_t> indices) {
    if (Status s = check_numbers(vertices, indices); !s.ok()) return s.error();
    const std::vector<std::uint32_t> merged = welded(vertices);
    std::vector<std::uint32_t> corners;
    for (std::size_t t = 0; t < indices.size(); t += 3) {
        const std::uint32_t a = merged[indices[t]], b = merged[indices[t + 1]],
                            c = merged[indices[t + 2]];
        if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
    }
    if (corners.empty()) return invalid("the mesh has no triangle with an area");
    if (Status s = check_edges(corners); !s.ok()) return s.error();
    ClosedMesh mesh;
    mesh.bounds = {vertices[corners[0]], vertices[corners[0]]};
    for (std::size_t t = 0; t < corners.size(); t += 3) {
        mesh.triangles.push_back(
            {vertices[corners[t]], vertices[corners[t + 1]], vertices[corners[t + 2]]});
        for (const Vec3 p : mesh.triangles.back())
            mesh.bounds = {min(mesh.bounds.low, p), max(mesh.bounds.high, p)};
    }
    mesh.volume = volume_of(mesh.triangles, (mesh.bounds.low + mesh.bounds.high) * 0.5);
    if (mesh.volume < 0) {
        for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
        mesh.volume = -mesh.volume;
    }
    const Vec3 size = mesh.bounds.high - mesh.bounds.low;
    if (!(mesh.volume > 1e-9 * size.x * size.y * size.z))
        return invalid("the mesh encloses no volume");
    return mesh;
}

bool is_inside(const std::vector<Triangle>& surface, Vec3 point) {
    bool inside = false;
    for (const Triangle& t : surface) inside ^= is_crossed(t, point);
    return inside;
}

double distance_to_surface(const std::vector<Triangle>& surface, Vec3 point) {
    double nearest2 = 1e300;
    for (const Triangle& t : surface)
        nearest2 = minimum(nearest2, length_squared(nearest_on(t, point) - point));
    return square_root(nearest2);
}

}  // namespace jostle::modules::convex_decomposition
