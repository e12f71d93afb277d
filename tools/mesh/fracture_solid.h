// SPDX-License-Identifier: MIT
//
// A solid that breaks, made ahead of time: from a mesh, a box or points, to chunks and bonds.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "jostle/modules/convex_decomposition.h"
#include "jostle/modules/fractured_shape.h"
#include "jostle/modules/seed_patterns.h"

namespace jostle::convert {

// One of the three.
struct Solid {
    std::string_view obj = {};                  // the text of a file
    double scale = 1;                           // m to a unit of it
    std::optional<physics::Vec3> box = {};      // m, its sides; about the origin
    std::vector<physics::Vec3> points = {};     // m, of which the hull is taken
    decomposition::Options decomposition = {};  // of a mesh that is not convex
};

struct FracturedSolid {
    modules::FracturedShape shape;
    std::size_t parts = 1;               // convex ones that it was cut into before
    double max_volume_error = 0;         // of the mesh's volume, that they hold too much
    double volume = 0, lost_volume = 0;  // m^3: FractureResult
};

// Anchors what reaches as far as any chunk does along `anchor`, if there is one.
physics::Result<FracturedSolid> fracture_solid(const Solid& solid,
                                               const modules::SeedPatternOptions& plan,
                                               std::optional<physics::Vec3> anchor = {},
                                               const modules::FractureProgress& progress = {});

}  // namespace jostle::convert
