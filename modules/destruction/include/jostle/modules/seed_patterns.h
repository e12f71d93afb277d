// SPDX-License-Identifier: MIT
//
// Patterns of fracture seeds, which determine the appearance of a broken solid. The results are
// deterministic and equal on all machines.
//
//     uniform    uniformly distributed: stone
//     radial     rings and spokes about a centre, denser towards it: glass
//     grid       equal blocks: masonry
//     clustered  mostly near a centre: small chunks there and large ones around
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

/// Pattern of seeds.
enum class SeedPattern : std::uint8_t { uniform, radial, grid, clustered };

/// Parameters of a seed pattern.
struct SeedPatternOptions {
    SeedPattern pattern = SeedPattern::uniform;
    int count = 100;  ///< 1 to chunks_max; grid and radial use the nearest suitable number
    /// Seed of the random number generator.
    std::uint64_t seed = 1;
    /// Centre of radial and clustered patterns, m; the middle of the bounds by default.
    std::optional<physics::Vec3> center = {};
    double spread = 0.15;  ///< cluster radius as a fraction of the longest side, 0.001 to 1
};

/// Generates seeds in bounds whose sides are 2e-4 to 2e4 m. For uniform and clustered patterns,
/// `inside` selects the accepted points. invalid_argument names the option that is out of range, or
/// reports that `inside` accepts too few points.
physics::Result<std::vector<physics::Vec3>> generate_seeds(
    const physics::Aabb& bounds, const SeedPatternOptions& plan,
    const std::function<bool(physics::Vec3)>& inside = {});

}  // namespace jostle::modules
