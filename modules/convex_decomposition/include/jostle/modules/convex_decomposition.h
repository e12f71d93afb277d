// SPDX-License-Identifier: MIT
//
// Approximate convex decomposition: a closed mesh becomes a set of convex hulls that together hold
// it, so that a dynamic body can have its shape. What they hold too much is measured and said.
//
// The box around the mesh is cut by planes across its axes, each time where the part with the most
// excess gains most, until the excess is small enough; then neighbours whose common hull adds
// little are joined again. A part is the hull of what of the mesh lies in its box: exact, without
// voxels. After the idea of J. M. Lien and N. M. Amato, "Approximate convex decomposition of
// polyhedra" (2007), and the planes of K. Mamou and F. Ghorbel's V-HACD.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/hull.h"
#include "jostle/physics/result.h"

namespace jostle::decomposition {

struct Options {
    int hulls_max = 32;              // 1 to 1024
    double max_volume_error = 0.03;  // of the mesh's volume, that parts may hold too much; 0 to 10
    int planes_per_axis = 15;        // that are tried across each axis of a part; 1 to 127
};

struct Decomposition {
    std::vector<std::shared_ptr<const physics::ConvexHull>> parts;
    double mesh_volume = 0;       // m^3
    double max_volume_error = 0;  // of it: what the hulls hold together, less the mesh; parts of
                                  // one cut do not overlap, parts that were joined may
    double max_distance = 0;  // m: the furthest that a point of a hull's surface, of many that were
                              // asked, lies outside the mesh
};

// Triangles are three indices each, counter-clockwise seen from outside; all the wrong way round is
// put right. At most 200,000. An error says what keeps the mesh from being a solid: an edge that
// does not have two triangles, no volume, numbers out of range.
physics::Result<Decomposition> decompose(std::span<const physics::Vec3> vertices,
                                         std::span<const std::uint32_t> indices,
                                         const Options& options = {});

}  // namespace jostle::decomposition
