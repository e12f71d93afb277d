// SPDX-License-Identifier: MIT
//
// Common interface of meshes and height fields: indexed triangles, found by box or by ray, with
// their neighbours across edges.
#pragma once

#include <cstdint>
#include <limits>

#include "jostle/base/check.h"
#include "jostle/physics/aabb.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/mesh.h"
#include "physics/src/geometry/bvh.h"

namespace jostle::physics {

inline constexpr std::uint32_t no_triangle = 0xffffffff;  // as an index

struct SurfaceTriangle {
    Vec3 corner[3];  // local, counter-clockwise seen from the front
    std::uint32_t index = 0;
};

// The neighbour across an edge.
struct SurfaceEdge {
    bool border = true;  // no neighbour, or more than one
    Vec3 normal;         // of the neighbour, oriented consistently
    // Height of the neighbour's far corner above the plane of this triangle, m; negative: a ridge
    // seen from the front.
    double fold = 0;
    double reach = 1;  // distance of that corner from the edge, m
};

inline Vec3 normal_of(const SurfaceTriangle& t) {
    return normalized(cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]));
}

SurfaceTriangle triangle_of(const TriangleMesh& mesh, std::uint32_t index);
// The index of a height-field triangle is cell * 2 + half.
SurfaceTriangle triangle_of(const HeightGrid& grid, std::uint32_t index);
SurfaceTriangle triangle_of(const Geometry& surface, std::uint32_t index);

// Edge k runs from corner k to corner k + 1. Returns the triangle across it, or no_triangle.
std::uint32_t neighbour_of(const Geometry& surface, std::uint32_t index, int k);
SurfaceEdge edge_of(const Geometry& surface, const SurfaceTriangle& triangle, int k);

// How much the surface turns at the edges of a triangle, whose normal is `front`: see
// TriangleMesh::folds. Computed for height fields, stored for meshes.
struct SurfaceFolds {
    float at[3];
};
inline constexpr float no_neighbour_fold = std::numeric_limits<float>::infinity();
SurfaceFolds folds_of(const Geometry& surface, const SurfaceTriangle& triangle, Vec3 front);
// The corner of a triangle that is furthest from the line through two points. The other two may be
// up to the welding distance away from the corners of a neighbour.
Vec3 opposite_corner(const SurfaceTriangle& triangle, Vec3 from, Vec3 to);
// At an edge between two points of a triangle with the normal `front`; `far` is the neighbour's
// corner opposite the edge.
float fold_at(Vec3 from, Vec3 to, Vec3 front, Vec3 far);

inline bool is_hole(const HeightGrid& grid, std::size_t cell) {
    ASSERT(grid.holes.empty() || cell < grid.holes.size());
    return !grid.holes.empty() && grid.holes[cell] != 0;
}

// Calls visit(const SurfaceTriangle&) for every triangle whose box overlaps, in an order that
// depends only on the surface.
template <class Visit>
void for_each_triangle(const TriangleMesh& mesh, const Aabb& box, Visit&& visit) {
    mesh.tree->query(box, [&](std::uint32_t index) {
        const SurfaceTriangle t = triangle_of(mesh, index);
        const Aabb own{min(t.corner[0], min(t.corner[1], t.corner[2])),
                       max(t.corner[0], max(t.corner[1], t.corner[2]))};
        if (overlap(own, box)) visit(t);
    });
}

inline Vec3 sample(const HeightGrid& grid, std::uint32_t column, std::uint32_t row) {
    ASSERT(column < grid.columns && row < grid.rows);
    return {(column - 0.5 * (grid.columns - 1)) * grid.spacing_x,
            grid.heights[std::size_t{row} * grid.columns + column],
            (row - 0.5 * (grid.rows - 1)) * grid.spacing_z};
}

struct CellRange {
    std::uint32_t column_begin = 0, column_end = 0, row_begin = 0, row_end = 0;
};
CellRange cells_under(const HeightGrid& grid, const Aabb& box);

template <class Visit>
void for_each_triangle(const HeightGrid& grid, const Aabb& box, Visit&& visit) {
    const CellRange cells = cells_under(grid, box);
    const auto visit_half = [&](const SurfaceTriangle& t) {
        const Aabb own{min(t.corner[0], min(t.corner[1], t.corner[2])),
                       max(t.corner[0], max(t.corner[1], t.corner[2]))};
        if (overlap(own, box)) visit(t);
    };
    for (std::uint32_t r = cells.row_begin; r < cells.row_end; r++) {
        Vec3 near = sample(grid, cells.column_begin, r),
             next_row = sample(grid, cells.column_begin, r + 1);
        for (std::uint32_t c = cells.column_begin; c < cells.column_end; c++) {
            const std::uint32_t cell = r * (grid.columns - 1) + c;
            const Vec3 next = sample(grid, c + 1, r), far = sample(grid, c + 1, r + 1);
            if (!is_hole(grid, cell)) {
                visit_half({{near, far, next}, cell * 2});
                visit_half({{near, next_row, far}, cell * 2 + 1});
            }
            near = next;
            next_row = far;
        }
    }
}

template <class Visit>
void for_each_triangle(const Geometry& surface, const Aabb& box, Visit&& visit) {
    if (const auto* mesh = std::get_if<Mesh>(&surface))
        for_each_triangle(*mesh->data, box, visit);
    else
        for_each_triangle(*std::get<HeightField>(surface).data, box, visit);
}

}  // namespace jostle::physics
