// SPDX-License-Identifier: MIT
//
// Polygons in the plane: where a point is, triangles, convex parts, and prisms that a world takes
// as shapes. Corners are given in order, either way round; the last is joined to the first.
// Coordinates are metres. All decisions are exact (planar.h).
//
// A simple polygon has 3 to max_polygon_corners different corners, finite and within
// +-limits::max_coordinate, and sides that share nothing but the corner between neighbours. Corners
// of 180 degrees are welcome. There are no holes: cut such a polygon in two, or give its parts one
// by one.
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

inline constexpr std::size_t max_polygon_corners = 4096;

// m^2; positive when the corners run counter-clockwise. To rounding. O(n).
double signed_area(std::span<const Vec2> polygon);

enum class Location : std::uint8_t { outside, boundary, inside };

// Any polygon, simple or not. On a side or a corner: boundary. O(n), exact.
//
// Inside where a ray to infinity crosses an odd number of sides (Shimrat, "Algorithm 112: Position
// of point relative to polygon", 1962).
Location locate_by_crossings(std::span<const Vec2> polygon, Vec2 p);
// Inside where the polygon runs round the point at all. The two agree on simple polygons; in the
// middle of a five-pointed star drawn in one stroke the first says outside and this one inside
// (Sunday, "Inclusion of a point in a polygon", 2001).
Location locate_by_winding(std::span<const Vec2> polygon, Vec2 p);
// How often it runs counter-clockwise round a point that is not on its boundary.
int winding_number(std::span<const Vec2> polygon, Vec2 p);

// Whether it is simple, or an Error that names the corners or sides that are to blame. Sides are
// sorted along x, and compared where they overlap there: O(n log n) for most, O(n^2) at worst.
Status check_polygon(std::span<const Vec2> polygon);

using Triangle = std::array<std::uint32_t, 3>;  // corners by index, counter-clockwise

// Of n corners, n - 2 triangles that fill a simple polygon and use every corner; none is flat. Ear
// clipping (Meisters, "Polygons have ears", 1975), with the ears kept up to date: O(n r) for r
// corners that are not convex.
Result<std::vector<Triangle>> triangulate(std::span<const Vec2> polygon);

using ConvexPart = std::vector<std::uint32_t>;  // corners by index, counter-clockwise

// Convex parts that fill a simple polygon, at most four times as many as are needed, if max_corners
// does not stop it: triangles, of which those that stay convex together are joined (Hertel and
// Mehlhorn, "Fast triangulation of simple polygons", 1983). A corner of a part may be one of 180
// degrees. max_corners is at least 3. As triangulate(), and O(n).
Result<std::vector<ConvexPart>> convex_parts(std::span<const Vec2> polygon,
                                             std::size_t max_corners = max_polygon_corners);

// The convex parts of a simple polygon in the xy plane, each as a prism from z = -half_depth to
// half_depth. In a planar world: the shapes of one body. Slivers are left out: parts whose area is
// less than 1e-5 of the square of the prism's longest side. Coordinates are within
// +-max_shape_size; half_depth is from min_shape_size to max_shape_size.
Result<std::vector<std::shared_ptr<const ConvexHull>>> build_prisms(std::span<const Vec2> polygon,
                                                                    double half_depth);
// The same as one compound, for worlds that are not planar.
Result<std::shared_ptr<const CompoundShape>> build_prism_compound(std::span<const Vec2> polygon,
                                                                  double half_depth);

}  // namespace jostle::physics::planar
