// SPDX-License-Identifier: MIT
//
// Builds triangle meshes: checks, neighbours across edges, tree.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/mesh.h"
#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/surface.h"

namespace jostle::physics {
namespace {

Error mesh_error(std::string message) {
    return invalid_argument("mesh: " + std::move(message));
}

// Exporters write coordinates in single precision and often one vertex per corner of a triangle.
// Vertices within the larger of two distances count as one: in m, and as a fraction of the mesh's
// size. The limit relative to the shortest edge at a vertex keeps triangles from collapsing.
constexpr double weld_fraction = 2e-6, weld_edge = 0.02;

// Vertices sorted by cells of a grid, to find those near a point.
class VertexCells {
public:
    VertexCells(const std::vector<Vec3>& vertices, double width) : width_(width) {
        cells_.reserve(vertices.size());
        for (std::uint32_t i = 0; i < vertices.size(); i++)
            cells_.push_back({key_of(cell_of(vertices[i])), i});
        std::sort(cells_.begin(), cells_.end());
    }

    // Calls visit(vertex) for all vertices within `reach` of p along each axis, and some others.
    // `reach` is less than the width of a cell.
    template <class Visit>
    void for_each_near(Vec3 p, double reach, Visit&& visit) const {
        const Vec3 low = cell_of(p - Vec3{reach, reach, reach}),
                   high = cell_of(p + Vec3{reach, reach, reach});
        for (double x = low.x; x <= high.x; x++)
            for (double y = low.y; y <= high.y; y++)
                for (double z = low.z; z <= high.z; z++) visit_cell(key_of({x, y, z}), visit);
    }

private:
    using Entry = std::pair<std::uint64_t, std::uint32_t>;  // cell, vertex

    Vec3 cell_of(Vec3 p) const {
        return {std::floor(p.x / width_), std::floor(p.y / width_), std::floor(p.z / width_)};
    }
    // Different cells may have the same key.
    static std::uint64_t key_of(Vec3 cell) {
        Hasher hasher;
        for (int k = 0; k < 3; k++) hasher.add(bits_of(cell[k] + 0.0));
        return hasher.value;
    }
    template <class Visit>
    void visit_cell(std::uint64_t key, Visit&& visit) const {
        for (auto at = std::lower_bound(cells_.begin(), cells_.end(), Entry{key, 0});
             at != cells_.end() && at->first == key; at++)
            visit(at->second);
    }

    double width_;  // m
    std::vector<Entry> cells_;
};

// Returns for each vertex how far from it another one may be to count as the same, m.
std::vector<double> weld_reaches(const TriangleMesh& mesh) {
    const double size = length(mesh.bounds.high - mesh.bounds.low);
    const double most = maximum(tuning::weld_distance, weld_fraction * size);
    std::vector<double> reach(mesh.vertices.size(), 0);
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const auto& t : mesh.triangles) {
        double shortest = 1e300;
        for (int e = 0; e < 3; e++)
            shortest =
                minimum(shortest, length(mesh.vertices[t[(e + 1) % 3]] - mesh.vertices[t[e]]));
        for (const std::uint32_t v : t) {
            const double own = minimum(most, weld_edge * shortest);
            reach[v] = used[v] ? minimum(reach[v], own) : own;
            used[v] = true;
        }
    }
    return reach;
}

// Returns for each vertex the lowest index of the vertices that count as the same.
std::vector<std::uint32_t> weld(const TriangleMesh& mesh) {
    const std::vector<double> reach = weld_reaches(mesh);
    const double most = *std::max_element(reach.begin(), reach.end());
    std::vector<std::uint32_t> first(mesh.vertices.size());
    for (std::uint32_t i = 0; i < first.size(); i++) first[i] = i;
    const auto first_of = [&](std::uint32_t v) {
        while (first[v] != v) v = first[v] = first[first[v]];
        return v;
    };
    const VertexCells cells(mesh.vertices, 4 * most);
    ASSERT(most > 0);
    for (std::uint32_t i = 0; i < first.size(); i++)
        cells.for_each_near(mesh.vertices[i], reach[i], [&](std::uint32_t j) {
            const double both = minimum(reach[i], reach[j]);
            if (j >= i || length_squared(mesh.vertices[j] - mesh.vertices[i]) > both * both) return;
            const std::uint32_t a = first_of(i), b = first_of(j);
            first[std::max(a, b)] = std::min(a, b);
        });
    for (std::uint32_t i = 0; i < first.size(); i++) first[i] = first_of(i);
    return first;
}

// Drops all but the first of the triangles with the same corners, in either winding: they are one
// sheet. `slot`: see weld().
void drop_repeated_triangles(TriangleMesh& mesh, std::vector<Aabb>& boxes,
                             const std::vector<std::uint32_t>& slot) {
    using Entry = std::pair<std::array<std::uint32_t, 3>, std::uint32_t>;
    std::vector<Entry> sorted;
    sorted.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); t++) {
        std::array<std::uint32_t, 3> corners = mesh.triangles[t];
        for (std::uint32_t& corner : corners) corner = slot[corner];
        std::sort(corners.begin(), corners.end());
        sorted.push_back({corners, t});
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<bool> repeated(mesh.triangles.size(), false);
    for (std::size_t k = 1; k < sorted.size(); k++)
        repeated[sorted[k].second] = sorted[k].first == sorted[k - 1].first;
    std::size_t retained = 0;
    for (std::size_t t = 0; t < repeated.size(); t++) {
        if (repeated[t]) continue;
        mesh.triangles[retained] = mesh.triangles[t];
        boxes[retained++] = boxes[t];
    }
    mesh.triangles.resize(retained);
    boxes.resize(retained);
    ASSERT(retained > 0);
}

void find_neighbours(TriangleMesh& mesh, const std::vector<std::uint32_t>& slot) {
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

void find_folds(TriangleMesh& mesh) {
    mesh.folds.resize(mesh.triangles.size());
    ASSERT(mesh.neighbours.size() == mesh.triangles.size());
    for (std::uint32_t index = 0; index < mesh.triangles.size(); index++) {
        const SurfaceTriangle t = triangle_of(mesh, index);
        const Vec3 front = normal_of(t);
        for (int k = 0; k < 3; k++) {
            const std::uint32_t other = mesh.neighbours[index][static_cast<std::size_t>(k)];
            mesh.folds[index][static_cast<std::size_t>(k)] =
                other == no_triangle ? no_neighbour_fold
                                     : fold_at(t.corner[k], t.corner[(k + 1) % 3], front,
                                               opposite_corner(triangle_of(mesh, other),
                                                               t.corner[k], t.corner[(k + 1) % 3]));
        }
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
    const std::vector<std::uint32_t> slot = weld(*mesh);
    for (std::size_t v = 0; v < slot.size(); v++)
        mesh->weld_gap =
            maximum(mesh->weld_gap, length(mesh->vertices[v] - mesh->vertices[slot[v]]));
    drop_repeated_triangles(*mesh, boxes, slot);
    find_neighbours(*mesh, slot);
    find_folds(*mesh);
    mesh->tree = std::make_shared<const Bvh>(boxes);
    ASSERT(boxes.size() == mesh->triangles.size() && mesh->neighbours.size() == boxes.size());
    mesh->content_hash = hash_of(*mesh);
    return std::shared_ptr<const TriangleMesh>(std::move(mesh));
}

}  // namespace jostle::physics
