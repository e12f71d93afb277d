// SPDX-License-Identifier: MIT
//
// Approximate convex decomposition: converts a closed mesh to a set of convex hulls that contain
// it, so that a dynamic body can have its shape. The volume error is measured and returned.
//
// The bounding box of the mesh is cut by axis-aligned planes. Each cut is applied to the part with
// the largest excess volume, at the plane that reduces the volume most, until the total excess is
// small enough. Then neighbours whose common hull adds little volume are merged again. A part is
// the hull of the mesh inside its box, computed exactly without voxels. Based on J.-M. Lien and N.
// M. Amato, "Approximate convex decomposition of polyhedra" (2007), with the planes of V-HACD (K.
// Mamou and F. Ghorbel).
//
// Thread rule: any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/hull.h"
#include "jostle/physics/result.h"

namespace jostle::modules::convex_decomposition {

/// Options of the decomposition.
struct Options {
    int hulls_max = 32;  ///< maximum number of hulls, 1 to 1024
    /// Allowed excess volume as a fraction of the mesh's volume, 0 to 10.
    double max_volume_error = 0.03;
    int planes_per_axis = 15;  ///< planes tried across each axis of a part, 1 to 127
};

/// Result of the decomposition.
struct Decomposition {
    /// The hulls.
    std::vector<std::shared_ptr<const physics::ConvexHull>> parts;
    double mesh_volume = 0;  ///< m^3
    /// Sum of the differences between the volumes of the hulls and of their parts of the mesh, as a
    /// fraction of the mesh volume; merged parts may overlap
    double max_volume_error = 0;
    double max_distance = 0;  ///< m, largest sampled distance of a hull's surface outside the mesh
};

/// Decomposes a mesh of at most 200,000 triangles. Triangles are three indices each,
/// counter-clockwise seen from outside. If all are clockwise, they are reversed. Vertices are
/// within 1e5 m.
///
/// Returns invalid_argument if an option is out of range or the mesh is not a solid: an edge
/// without a triangle on each side, zero volume, or numbers out of range. Returns
/// resource_exhausted if a part has no valid hull; increase hulls_max then. A smooth part with more
/// corners than a hull can have gets a hull of its outermost corners.
physics::Result<Decomposition> decompose(std::span<const physics::Vec3> vertices,
                                         std::span<const std::uint32_t> indices,
                                         const Options& options = {});

}  // namespace jostle::modules::convex_decomposition
