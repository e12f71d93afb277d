// SPDX-License-Identifier: MIT
#include "physics/src/geometry/surface.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

// The triangle across edge k of a height-field triangle. Half 0 has the corners 00, 11, 10 (column,
// row); its edges are the diagonal, the side to the next column and the side to the previous row.
// Half 1 has 00, 01, 11: the side to the previous column, the side to the next row, the diagonal.
std::uint32_t across(const HeightGrid& grid, std::uint32_t index, int k) {
    const std::uint32_t columns = grid.columns - 1, rows = grid.rows - 1;
    ASSERT(k >= 0 && k < 3 && index < 2 * columns * rows);
    const std::uint32_t cell = index / 2, c = cell % columns, r = cell / columns;
    if (index % 2 == 0) {
        if (k == 0) return index + 1;
        if (k == 1) return c + 1 < columns ? (cell + 1) * 2 + 1 : no_triangle;
        return r > 0 ? (cell - columns) * 2 + 1 : no_triangle;
    }
    if (k == 2) return index - 1;
    if (k == 0) return c > 0 ? (cell - 1) * 2 : no_triangle;
    return r + 1 < rows ? (cell + columns) * 2 : no_triangle;
}

}  // namespace

std::uint32_t neighbour_of(const Geometry& surface, std::uint32_t index, int k) {
    if (const auto* mesh = std::get_if<Mesh>(&surface))
        return mesh->data->neighbours[index][static_cast<std::size_t>(k)];
    const HeightGrid& grid = *std::get<HeightField>(surface).data;
    const std::uint32_t other = across(grid, index, k);
    return other != no_triangle && is_hole(grid, other / 2) ? no_triangle : other;
}

SurfaceTriangle triangle_of(const TriangleMesh& mesh, std::uint32_t index) {
    const auto& t = mesh.triangles[index];
    ASSERT(t[0] < mesh.vertices.size() && t[1] < mesh.vertices.size() &&
           t[2] < mesh.vertices.size());
    return {{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, index};
}

SurfaceTriangle triangle_of(const HeightGrid& grid, std::uint32_t index) {
    const std::uint32_t cell = index / 2, c = cell % (grid.columns - 1),
                        r = cell / (grid.columns - 1);
    const Vec3 near = sample(grid, c, r), far = sample(grid, c + 1, r + 1);
    if (index % 2 == 0) return {{near, far, sample(grid, c + 1, r)}, index};
    return {{near, sample(grid, c, r + 1), far}, index};
}

SurfaceTriangle triangle_of(const Geometry& surface, std::uint32_t index) {
    if (const auto* mesh = std::get_if<Mesh>(&surface)) return triangle_of(*mesh->data, index);
    return triangle_of(*std::get<HeightField>(surface).data, index);
}

SurfaceEdge edge_of(const Geometry& surface, const SurfaceTriangle& t, int k) {
    ASSERT(k >= 0 && k < 3);
    const std::uint32_t other = neighbour_of(surface, t.index, k);
    if (other == no_triangle) return {};
    const SurfaceTriangle n = triangle_of(surface, other);
    const Vec3 from = t.corner[k], along = normalized(t.corner[(k + 1) % 3] - from);
    // The far corner of the neighbour is the one furthest from the common edge.
    Vec3 far;
    double reach = -1;
    for (const Vec3 p : n.corner) {
        const Vec3 d = p - from, off = d - along * dot(d, along);
        if (length(off) > reach) {
            reach = length(off);
            far = p;
        }
    }
    // Neighbours may have the opposite winding. Orient the normal so that the two faces form one
    // sheet: seen along the edge, the far corner lies away from this triangle.
    const Vec3 own = normal_of(t);
    ASSERT(reach >= 0 && other != t.index);
    const Vec3 off = (far - from) - along * dot(far - from, along);
    Vec3 normal = normalized(cross(off, along));
    if (length_squared(cross(off, along)) == 0) normal = own;
    return {.border = false, .normal = normal, .fold = dot(own, far - from), .reach = reach};
}

Vec3 opposite_corner(const SurfaceTriangle& triangle, Vec3 from, Vec3 to) {
    Vec3 far;
    double furthest = -1;
    for (const Vec3 c : triangle.corner) {
        const double off = length_squared(cross(c - from, to - from));
        if (off > furthest) furthest = off, far = c;
    }
    return far;
}

float fold_at(Vec3 from, Vec3 to, Vec3 front, Vec3 far) {
    const Vec3 outward = normalized(cross(to - from, front)), off = far - from;
    const double up = dot(off, front), out = dot(off, outward);
    // The neighbour's plane descends by `down` over `out`; half of an angle of up to 180 degrees.
    const double down = -up;
    const double tangent = down / (out + square_root(out * out + down * down));
    return tangent == tangent ? static_cast<float>(tangent) : 0;
}

namespace {

// The corner of the triangle across edge k that is opposite the edge: see across().
Vec3 opposite_corner(const HeightGrid& grid, std::uint32_t index, int k) {
    static constexpr int step[2][3][2] = {{{0, 1}, {2, 1}, {0, -1}}, {{-1, 0}, {1, 2}, {1, 0}}};
    const std::uint32_t cell = index / 2, c = cell % (grid.columns - 1),
                        r = cell / (grid.columns - 1);
    const int(&to)[2] = step[index % 2][k];
    return sample(grid, c + static_cast<std::uint32_t>(to[0]),
                  r + static_cast<std::uint32_t>(to[1]));
}

}  // namespace

SurfaceFolds folds_of(const Geometry& surface, const SurfaceTriangle& t, Vec3 front) {
    SurfaceFolds folds;
    if (const auto* mesh = std::get_if<Mesh>(&surface)) {
        std::copy_n(mesh->data->folds[t.index].data(), 3, folds.at);
        return folds;
    }
    const HeightGrid& grid = *std::get<HeightField>(surface).data;
    for (int k = 0; k < 3; k++)
        folds.at[k] = neighbour_of(surface, t.index, k) == no_triangle
                          ? no_neighbour_fold
                          : fold_at(t.corner[k], t.corner[(k + 1) % 3], front,
                                    opposite_corner(grid, t.index, k));
    return folds;
}

CellRange cells_under(const HeightGrid& grid, const Aabb& box) {
    if (!overlap(grid.bounds, box)) return {};
    const auto cell = [](double x, double spacing, std::uint32_t samples) {
        const double at = std::floor(x / spacing + 0.5 * (samples - 1));
        return static_cast<std::uint32_t>(clamp(at, 0, samples - 2.0));
    };
    return {cell(box.low.x, grid.spacing_x, grid.columns),
            cell(box.high.x, grid.spacing_x, grid.columns) + 1,
            cell(box.low.z, grid.spacing_z, grid.rows),
            cell(box.high.z, grid.spacing_z, grid.rows) + 1};
}

}  // namespace jostle::physics
