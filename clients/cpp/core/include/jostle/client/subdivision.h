// SPDX-License-Identifier: MIT
//
// Smooth curves and surfaces through or near the points of a point object, for rendering: a rope of
// twenty points looks round, a cloth of a few hundred points looks like cloth. Pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/client/point_objects.h"

namespace jostle::client {

/// The Catmull-Rom spline through the points (Catmull and Rom, "A class of local interpolating
/// splines", 1974), with `parts` pieces, at least 1, between two points. Returns the points and
/// those between them.
std::vector<PointPosition> subdivide_strand(std::span<const PointPosition> points,
                                            std::size_t parts);

/// The bicubic Catmull-Rom surface through a grid of `columns` x rows points, row by row. The
/// result has (columns - 1) * parts + 1 columns.
std::vector<PointPosition> subdivide_grid(std::span<const PointPosition> points,
                                          std::size_t columns, std::size_t parts);

/// A triangle mesh: three points per triangle.
struct TriangleMesh {
    std::vector<PointPosition> points;
    std::vector<std::uint32_t> triangles;
};

/// One step of Loop's subdivision (C. Loop, "Smooth subdivision surfaces based on triangles", 1987)
/// with the weights of Warren for inner points: each triangle becomes four. Edges of one triangle
/// are borders, which become cubic B-splines. Triangles with a point beyond the list are dropped.
TriangleMesh subdivide_mesh(const TriangleMesh& mesh);

}  // namespace jostle::client
