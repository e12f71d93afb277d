// SPDX-License-Identifier: MIT
//
// Builds triangle meshes: checks, neighbours across edges, tree.
#include <algorithm>
#include <map>

#include "jostle/base/check.h"
#include "jostle/physics/mesh.h"
#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/surface.h"

namespace jostle::physics {
namespace {

Error mesh_error(std::string message) {
    return invalid_argument("mesh: " + std::move(message));
}

// Returns for each vertex the lowest index of a vertex at the same position.
std::vector<std::uint32_t> same_positions(const std::vector<Vec3>& vertices) {
    std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
    for (std::uint32_t i = 0; i < order.size(); i++) order[i] = i;
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        const Vec3 &p = vertices[a], &q = vertices[b];
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        if (p.z != q.z) return p.z < q.z;
        return a < b;
    };
    std::sort(order.begin(), order.end(), less);
    for (std::size_t k = 0; k < order.size(); k++)
        first[order[k]] =
            k > 0 && vertices[order[k]] == vertices[order[k - 1]] ? first[order[k - 1]] : order[k];
    return first;
}

void find_neighbours(TriangleMesh& mesh) {
    const std::vector<std::uint32_t> slot = same_positions(mesh.vertices);
    struct Side {
        std::uint32_t low, high;  // unique vertices at its two ends
        std::uint32_t triangle, edge;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); t++)
        for (std::uint32_t e = 0; e < 3; e++) {
            const std::uint32_t a = slot[mesh.triangles[t][e]],
                                b = slot[mesh.triangles[t][(e + 1) % 3]];
            sides.push_back({std::min(a, b), std::max(a, b), t, e});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.low, x.high, x.triangle, x.edge) <
               std::tie(y.low, y.high, y.triangle, y.edge);
    });
    mesh.neighbours.assign(mesh.triangles.size(), {no_triangle, no_triangle, no_triangle});
    ASSERT(sides.size() == 3 * mesh.triangles.size());
    for (std::size_t k = 0; k < sides.size();) {
        std::size_t end = k + 1;
        while (end < sides.size() && sides[end].low == sides[k].low &&
               sides[end].high == sides[k].high)
            end++;
        if (end - k == 2) {
            mesh.neighbours[sides[k].triangle][sides[k].edge] = sides[k + 1].triangle;
            mesh.neighbours[sides[k + 1].triangle][sides[k + 1].edge] = sides[k].triangle;
        }
        k = end;
    }
}

std::uint64_t hash_of(const TriangleMesh& mesh) {
    Hasher hasher;
    hasher.add(mesh.vertices.size());
    for (const Vec3 v : mesh.vertices)
        for (int k = 0; k < 3; k++) hasher.add(bits_of(v[k]));
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t corner : t) hasher.add(corner);
    return hasher.value;
}

}  // namespace

Result<std::shared_ptr<const TriangleMesh>> build_mesh(
    std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles) {
    if (vertices.size() < 3)
        return mesh_error("it has " + std::to_string(vertices.size()) +
                          " vertices; it must have at least 3");
    if (triangles.empty()) return mesh_error("it has no triangles");
    if (triangles.size() > max_mesh_triangles || vertices.size() > 3 * max_mesh_triangles)
        return mesh_error("it has " + std::to_string(triangles.size()) + " triangles; at most " +
                          std::to_string(max_mesh_triangles) + " are allowed");
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices.assign(vertices.begin(), vertices.end());
    mesh->bounds = {vertices[0], vertices[0]};
    for (std::size_t i = 0; i < vertices.size(); i++) {
        const Vec3 reach = abs(vertices[i]);
        if (!is_finite(vertices[i]) || maximum(reach.x, maximum(reach.y, reach.z)) > max_shape_size)
            return mesh_error("vertices[" + std::to_string(i) +
                              "] is not finite or further than 10000 m from the origin");
        mesh->bounds = unite(mesh->bounds, {vertices[i], vertices[i]});
    }
    const double size = length(mesh->bounds.high - mesh->bounds.low);
    std::vector<Aabb> boxes;
    for (std::size_t t = 0; t < triangles.size(); t++) {
        for (const std::uint32_t corner : triangles[t])
            if (corner >= vertices.size())
                return mesh_error("triangles[" + std::to_string(t) + "] refers to vertex " +
                                  std::to_string(corner) + "; there are " +
                                  std::to_string(vertices.size()) + " vertices");
        const Vec3 a = vertices[triangles[t][0]], b = vertices[triangles[t][1]],
                   c = vertices[triangles[t][2]];
        const double longest = maximum(length(b - a), maximum(length(c - b), length(a - c)));
        if (length(cross(b - a, c - a)) <= 1e-9 * size * longest) continue;
        mesh->triangles.push_back(triangles[t]);
        boxes.push_back({min(a, min(b, c)), max(a, max(b, c))});
    }
    if (mesh->triangles.empty()) return mesh_error("all its triangles are degenerate");
    find_neighbours(*mesh);
    mesh->tree = std::make_shared<const Bvh>(boxes);
    ASSERT(boxes.size() == mesh->triangles.size() && mesh->neighbours.size() == boxes.size());
    mesh->content_hash = hash_of(*mesh);
    return std::shared_ptr<const TriangleMesh>(std::move(mesh));
}

}  // namespace jostle::physics
