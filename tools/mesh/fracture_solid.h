// SPDX-License-Identifier: MIT
//
// Fractures a solid in advance: cuts a mesh, a box or the hull of points into chunks with bonds.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "jostle/modules/convex_decomposition.h"
#include "jostle/modules/fractured_shape.h"
#include "jostle/modules/seed_patterns.h"

namespace jostle::mesh {

// Exactly one of obj, box and points is set.
struct Solid {
    std::string_view obj = {};               // content of an OBJ file
    double scale = 1;                        // m per unit of the file
    std::optional<physics::Vec3> box = {};   // m, edge lengths; centred on the origin
    std::vector<physics::Vec3> points = {};  // m; their convex hull is cut
    modules::convex_decomposition::Options decomposition = {};  // for a mesh that is not convex
};

struct FracturedSolid {
    modules::FracturedShape shape;
    std::size_t parts = 1;        // convex parts of the mesh
    double max_volume_error = 0;  // excess volume of the parts, as a share of the mesh's volume
    double volume = 0, lost_volume = 0;  // m^3; see FractureResult
};

// Fractures a solid. With `anchor`, anchors the chunks that reach as far as any chunk in that
// direction.
physics::Result<FracturedSolid> fracture_solid(const Solid& solid,
                                               const modules::SeedPatternOptions& plan,
                                               std::optional<physics::Vec3> anchor = {},
                                               const modules::FractureProgress& progress = {});

}  // namespace jostle::mesh
