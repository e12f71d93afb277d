// SPDX-License-Identifier: MIT
//
// Where the seeds of chunks lie: how a thing looks when it is broken. The same ones for the same
// number on any machine.
//
//     uniform    everywhere alike: stone
//     radial     rings and spokes about a centre, closer towards it: glass
//     grid       even blocks: masonry
//     clustered  most of them near a centre, small chunks there and large ones around
//
// Thread rule: any thread; plain data.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/result.h"

namespace jostle::modules {

enum class SeedPattern : std::uint8_t { uniform, radial, grid, clustered };

struct SeedPatternOptions {
    SeedPattern pattern = SeedPattern::uniform;
    int count = 100;  // 1 to chunks_max; a grid and rings take what fits best
    std::uint64_t seed = 1;
    // Of radial and clustered; without one the middle of the bounds.
    std::optional<physics::Vec3> center = {};
    double spread = 0.15;  // of a cluster: its radius as a share of the longest side, 0.001 to 1
};

// Within bounds whose sides are 2e-4 to 2e4 m. Of uniform and clustered only such as `inside`
// takes, if there is one; an error when it takes next to none.
physics::Result<std::vector<physics::Vec3>> generate_seeds(
    const physics::Aabb& bounds, const SeedPatternOptions& plan,
    const std::function<bool(physics::Vec3)>& inside = {});

}  // namespace jostle::modules
