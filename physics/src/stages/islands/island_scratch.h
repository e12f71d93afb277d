// SPDX-License-Identifier: MIT
//
// What prepare_islands and merge_islands use again from step to step. For the solver in it:
// `unknown`.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jostle/physics/vec3.h"
#include "physics/src/constraint_graph/solver_tier.h"

namespace jostle::physics {

// What stands of an island, by its bodies' centres of mass.
struct IslandExtent {
    double low = 1e300, high = -1e300;  // m, upwards
    double thickness = 0;               // m, of all bodies
    int bodies = 0;
    // Sums over the bodies of where they are on the ground, from the first of them, m and m^2.
    Vec3 first;
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    bool tier_chosen = false;  // its tier was looked at together with another's
};

struct IslandScratch {
    std::vector<std::uint32_t> awake;          // islands, rising
    std::vector<IslandExtent> extents;         // by island, of these
    std::vector<std::uint32_t> weights;        // by island
    std::vector<std::uint32_t> touch_changes;  // contacts whose touching flag changes
    // By colour set, in a world with a tolerance: whether it has an island of unknown error.
    std::array<std::uint8_t, solved_set_count> unknown{};
};

}  // namespace jostle::physics
