// SPDX-License-Identifier: MIT
//
// Scratch data that prepare_islands and merge_islands reuse from step to step. The solver reads
// `unknown`.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jostle/physics/vec3.h"
#include "physics/src/constraint_graph/solver_tier.h"

namespace jostle::physics {

// Extent of the standing part of an island, by its bodies' centres of mass.
struct IslandExtent {
    double low = 1e300, high = -1e300;  // m, along the up direction
    double thickness = 0;               // m, sum over all bodies
    int bodies = 0;
    // Sums over the bodies of their horizontal positions, relative to the first of them, m and m^2.
    Vec3 first;
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    bool tier_chosen = false;  // its tier was chosen together with another island's
};

struct IslandScratch {
    std::vector<std::uint32_t> awake;          // islands, in ascending order
    std::vector<IslandExtent> extents;         // indexed by island; valid for the awake ones
    std::vector<std::uint32_t> weights;        // indexed by island
    std::vector<std::uint32_t> touch_changes;  // contacts whose touching flag changes
    // By colour set, in a world with a tolerance: whether it has an island of unknown error.
    std::array<std::uint8_t, solved_set_count> unknown{};
};

}  // namespace jostle::physics
