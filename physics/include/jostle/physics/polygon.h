// SPDX-License-Identifier: MIT
//
// Polygons: point location, triangulation, convex decomposition, and conversion to prisms that a
// world accepts as shapes. Corners are given in order, in either direction; the last one is
// connected to the first one. Coordinates are in metres. All predicates are exact (planar.h).
//
// A simple polygon has 3 to max_polygon_corners distinct corners, finite and within
// +-limits::max_coordinate. Its sides have no common points except the corner between neighbours.
// Corners of 180 degrees are allowed. Holes are not supported: split such a polygon into two, or
// pass its parts one by one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/planar.h"

namespace jostle::physics::planar {

/// Maximum number of corners of a polygon.
inline constexpr std::size_t max_polygon_corners = 4096;

/// Returns the signed area in m^2, positive if the corners are counter-clockwise. Subject to
/// rounding. O(n).
double signed_area(std::span<const Vec2> polygon);

/// The location of a point relative to a polygon.
enum class Location : std::uint8_t { outside, boundary, inside };

/// Locates a point relative to any polygon, simple or not, by the even-odd rule: a point is inside
/// if a ray to infinity crosses an odd number of sides (Shimrat, "Algorithm 112: Position of point
/// relative to polygon", 1962). A point on a side or a corner is on the boundary. O(n), exact.
Location locate_by_crossings(std::span<const Vec2> polygon, Vec2 p);
/// Locates a point by the non-zero winding rule: a point is inside if its winding number is not
/// zero. The result equals that of locate_by_crossings() for simple polygons. In the middle of a
/// five-pointed star drawn in one stroke, locate_by_crossings() returns outside and this function
/// returns inside (Sunday, "Inclusion of a point in a polygon", 2001).
Location locate_by_winding(std::span<const Vec2> polygon, Vec2 p);
/// Returns the number of counter-clockwise turns of the polygon around a point that is not on its
/// boundary.
int winding_number(std::span<const Vec2> polygon, Vec2 p);

/// Checks that the polygon is simple. Errors: invalid_argument, naming the corners or sides that
/// violate the condition. Sides are sorted along x and compared if they overlap in x: O(n log n)
/// typically, O(n^2) in the worst case.
Status check_polygon(std::span<const Vec2> polygon);

using Triangle = std::array<std::uint32_t, 3>;  ///< corner indices, counter-clockwise

/// Triangulates a simple polygon of n corners into n - 2 triangles that use every corner; none is
/// degenerate. Errors: those of check_polygon().
///
/// Ear clipping (Meisters, "Polygons have ears", 1975) with incremental updates of the ears: O(n r)
/// for r non-convex corners.
Result<std::vector<Triangle>> triangulate(std::span<const Vec2> polygon);

using ConvexPart = std::vector<std::uint32_t>;  ///< corner indices, counter-clockwise

/// Decomposes a simple polygon into convex parts: at most four times the minimum number, unless
/// max_corners (at least 3) limits their size. A corner of a part may have 180 degrees. Errors:
/// those of check_polygon().
///
/// Joins triangles that form convex parts (Hertel and Mehlhorn, "Fast triangulation of simple
/// polygons", 1983). Cost: triangulate() plus O(n).
Result<std::vector<ConvexPart>> convex_parts(std::span<const Vec2> polygon,
                                             std::size_t max_corners = max_polygon_corners);

/// Converts the convex parts of a simple polygon in the xy plane to prisms from z = -half_depth to
/// half_depth. In a planar world, they are the shapes of one body. Slivers are dropped: parts whose
/// area is less than 1e-5 of the square of the prism's longest side. Coordinates are within
/// +-max_shape_size; half_depth is from min_shape_size to max_shape_size.
Result<std::vector<std::shared_ptr<const ConvexHull>>> build_prisms(std::span<const Vec2> polygon,
                                                                    double half_depth);
/// Same as build_prisms(), combined into one compound, for worlds that are not planar.
Result<std::shared_ptr<const CompoundShape>> build_prism_compound(std::span<const Vec2> polygon,
                                                                  double half_depth);

}  // namespace jostle::physics::planar
