// SPDX-License-Identifier: MIT
//
// Fractures solids given as cells by the Voronoi cells of seeds: creates chunks and bonds.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "jostle/modules/fractured_shape.h"
#include "jostle/physics/result.h"
#include "jostle/physics/vec3.h"
#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// An error names the seed whose chunk is too thin for a hull.
physics::Result<FracturedShape> fracture_cell(const ConvexCell& solid,
                                              std::span<const physics::Vec3> seeds);
// `parts` must not overlap.
physics::Result<FractureResult> fracture_cells(std::span<const ConvexCell> parts,
                                               std::span<const physics::Vec3> seeds,
                                               const FractureProgress& progress);

// Voronoi cells of seeds, clipped from a convex solid one by one. The plane between two seeds is
// bit-identical for both cells, so the cells fill the solid up to rounding error.
//
// Relative to the size: points within this distance of a plane are on it, because of rounding.
inline constexpr double plane_tolerance_ratio = 1e-14;

// Seeds must be finite and distinct, 1 to chunks_max.
physics::Status check_seeds(std::span<const physics::Vec3> seeds);
// The part of the solid that is nearer to this seed than to any other.
ConvexCell voronoi_cell(const ConvexCell& solid, std::span<const physics::Vec3> seeds,
                        std::size_t own, double plane_tolerance);
// The part of the solid that is nearer to this seed than to one other seed.
ConvexCell clip_by_bisector(const ConvexCell& solid, std::span<const physics::Vec3> seeds,
                            std::size_t own, std::uint32_t other, double plane_tolerance);

// Converts hulls that may overlap to disjoint cells.
//
// Where hulls overlap, the first one has precedence; the rest of the others is cut along its faces.
// Slivers of less than 1e-9 of the volume are dropped.
std::vector<ConvexCell> disjoint_cells(
    std::span<const std::shared_ptr<const physics::ConvexHull>> hulls);

// Finds coplanar contact areas between faces of two convex solids.
//
// Relative to the size: faces within this distance and angle are in contact.
inline constexpr double face_contact_tolerance_ratio = 1e-6;

struct FaceContact {
    physics::Vec3 normal;               // unit, from a to b
    std::vector<physics::Vec3> points;  // common area of both faces, in order about the normal
};

std::vector<FaceContact> face_contacts(const ConvexCell& a, const ConvexCell& b, double near);

// Section properties of a flat convex polygon, for beams.
struct Section {
    double area = 0;
    physics::Vec3 center, axis;  // principal axis u; v = normal x u
    double moment_u = 0, moment_v = 0;
    double reach_u = 0, reach_v = 0;
};

// `points` are in order about the unit normal.
Section section_of(std::span<const physics::Vec3> points, physics::Vec3 normal);

}  // namespace jostle::modules::destruction_detail
