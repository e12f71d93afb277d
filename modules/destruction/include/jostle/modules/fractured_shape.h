// SPDX-License-Identifier: MIT
//
// A solid that is pre-fractured into convex chunks, and the bonds between them. Create it offline
// or once at startup, and pass it to Destruction::add().
//
//     FracturedShape wall = *fracture_box({3, 1.5, 0.15}, random_seeds({3, 1.5, 0.15}, 200, 7));
//     anchor(wall, {0, -1, 0}, 1.45);   // the chunks at its foot
//
// Thread rule: any thread; plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/result.h"
#include "jostle/physics/transform.h"

namespace jostle::modules {

/// Maximum number of chunks of a shape.
inline constexpr std::size_t chunks_max = 20000;
/// Maximum number of hulls of fracture_parts().
inline constexpr std::size_t fracture_parts_max = 1024;

/// A convex chunk. Positions are in the frame of the whole shape.
struct FractureChunk {
    physics::Geometry geometry = {};
    physics::Transform pose = {};  ///< of the geometry
    physics::Vec3 center = {};     ///< m, centre of mass
    double volume = 0;             ///< m^3
    /// m^5, about `center`, at density 1
    physics::Mat3 unit_inertia = physics::diagonal({0, 0, 0});
    bool anchored = false;  ///< fixed to the ground: its connected group is static
};

/// The common face of two chunks, as the cross-section of a beam.
struct FractureBond {
    std::uint32_t a = 0, b = 0;         ///< indices of chunks, a < b
    physics::Vec3 center = {};          ///< m, of the face
    physics::Vec3 normal = {};          ///< unit, from a to b
    physics::Vec3 axis = {};            ///< unit, in the face: principal axis u; v = normal x u
    double area = 0;                    ///< m^2
    double moment_u = 0, moment_v = 0;  ///< m^4, second moments of area about the axes u and v
    double reach_u = 0, reach_v = 0;    ///< m, largest distance of the face from the axes u and v
};

/// A fractured solid.
struct FracturedShape {
    std::vector<FractureChunk> chunks = {};
    std::vector<FractureBond> bonds = {};
};

/// Fractures a hull into Voronoi cells: one chunk per seed, the part of the hull that is nearer to
/// it than to any other seed. `seeds`: 1 to chunks_max distinct points within 10 km of the origin.
/// A seed with an empty cell creates no chunk. invalid_argument names the seed that is invalid or
/// whose chunk is too thin.
physics::Result<FracturedShape> fracture_hull(const physics::ConvexHull& hull,
                                              std::span<const physics::Vec3> seeds);
/// The same for a box about the origin. half_extents: m, 1e-4 to 1e4 each.
physics::Result<FracturedShape> fracture_box(physics::Vec3 half_extents,
                                             std::span<const physics::Vec3> seeds);
/// Progress callback, called from time to time.
using FractureProgress = std::function<void(std::size_t seeds_done, std::size_t seeds)>;

/// Result of fracture_parts().
struct FractureResult {
    FracturedShape shape = {};
    double volume = 0;  ///< m^3, of the solid; overlaps count once
    /// m^3, omitted slivers: too thin for a hull, or less than a millionth of the mean volume
    double lost_volume = 0;
};
/// The same for a solid of several hulls, such as a decomposed mesh. Cells end at the boundaries of
/// parts, and bonds connect them where parts touch. Where parts overlap, the first one has
/// precedence. `parts`: 1 to fracture_parts_max hulls, none null.
physics::Result<FractureResult> fracture_parts(
    std::span<const std::shared_ptr<const physics::ConvexHull>> parts,
    std::span<const physics::Vec3> seeds, const FractureProgress& progress = {});
/// Splits a box into nx * ny * nz equal boxes, x varying fastest. Each count is 1 to 1000, their
/// product at most chunks_max.
physics::Result<FracturedShape> split_box(physics::Vec3 half_extents, int nx, int ny, int nz);

/// Returns uniformly distributed points in a box about the origin. Deterministic for a seed.
std::vector<physics::Vec3> random_seeds(physics::Vec3 half_extents, int count, std::uint64_t seed);

/// Anchors each chunk that has a point x with dot(direction, x) >= offset. Returns the number of
/// anchored chunks.
std::size_t anchor(FracturedShape& shape, physics::Vec3 direction, double offset);

}  // namespace jostle::modules
